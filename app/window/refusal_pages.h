// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "panels/property_panel.h"
#include "scene/overlay.h"
#include "window/face_paint.h"
#include "window/presentation.h"

#include <QString>

#include <vector>

namespace moldwright {

class Actions;
struct RefusedMesh;

/// The ids of a mesh that cannot be designed with, and of one of its places, in tree and panel; the place's
/// number is −1 for the id of anything else.
[[nodiscard]] QString refusedId();
[[nodiscard]] QString faultId(int place);
[[nodiscard]] int faultNumber(const QString& id);

/// How many of its places are in the tree; what goes from one to the next goes over these.
[[nodiscard]] int listedFaults(const RefusedMesh& refused);

/// What the window says of it, in place of what it says of a project: see presentation.h.
[[nodiscard]] std::array<StepState, stepCount> refusedStates(const RefusedMesh& refused);
[[nodiscard]] std::vector<ProjectRow> refusedRows(const RefusedMesh& refused);
[[nodiscard]] Verdict refusedVerdict(const RefusedMesh& refused);

/// The page of one of its places, or of the mesh for the id of anything else.
[[nodiscard]] PropertyPage refusedPage(const QString& selected, const RefusedMesh& refused,
                                       const Actions& actions);
void fillRefusedPage(PropertyPanel& panel, const RefusedMesh& refused);

/// What is at fault in red, what the red means, and a mark at the foremost places; the chosen one is always
/// among them, in bold.
[[nodiscard]] FacePaint refusedPaint(const RefusedMesh& refused);
[[nodiscard]] scene::PanelContent refusedLegend(const RefusedMesh& refused);
[[nodiscard]] std::vector<int> markedFaults(const RefusedMesh& refused, const QString& selected);
[[nodiscard]] std::vector<scene::Chip> faultMarks(const RefusedMesh& refused, const QString& selected);

/// All that is wrong, as text for another program.
[[nodiscard]] QString diagnosisText(const RefusedMesh& refused);

} // namespace moldwright
