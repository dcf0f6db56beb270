// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/check.h"

#include <QString>

namespace moldwright {

/// A mesh that was read and found sound, waiting for its unit.
struct OpenedMesh {
    QString name;
    QString file; ///< empty for a sample
    PreparedMesh prepared;
};

} // namespace moldwright
