// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "project/project.h"

namespace moldwright {

/// What of a project a run takes up while it goes on.
[[nodiscard]] LiveSettings liveSettings(const Project& project);

/// The run that a project asks for. Precondition: it has a part.
[[nodiscard]] DesignRequest designRequest(const Project& project);

/// Whether a run begun with one project is what the other asks for, but for what it takes up while it goes
/// on.
[[nodiscard]] bool sameButLive(const Project& one, const Project& other);

/// The project with the settings that a run took up.
[[nodiscard]] Project withLiveSettings(Project project, const LiveSettings& settings);

} // namespace moldwright
