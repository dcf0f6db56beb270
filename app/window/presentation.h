// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/analysis.h"
#include "castability/mold_state.h"
#include "panels/project_tree.h"
#include "scene/overlay.h"
#include "theme/icons.h"
#include "window/display_mode.h"

#include <QString>

#include <array>
#include <set>
#include <vector>

namespace moldwright {

class Workbench;

/// What the user hid.
struct Visibility {
    bool shape = true;
    bool plane = true;
    bool directions = true;
    bool mold = true;
    bool pins = true;
    bool suggestedPins = true;
    bool importance = true;
    std::set<QString> hidden; ///< rows hidden one by one: pins, regions

    [[nodiscard]] bool shows(const QString& id) const { return !hidden.contains(id); }
};

/// Shows or hides what the eyes of rows in the tree stand for; of several all are hidden unless all are.
void toggle(Visibility& visible, const QStringList& ids);
/// A row of numbered ones ("pin-3") is removed: those after it get the number before theirs.
void forgetRow(Visibility& visible, const QString& id);

/// The steps of the job.
enum class Step { Part, Plane, Guides, Deform, Check, Mold, Report };
inline constexpr int stepCount = 7;

struct StepState {
    Standing standing = Standing::Todo;
    QString words;
};

struct Verdict {
    Standing standing = Standing::Info;
    QString sentence;
    QString reason;
};

/// How each step stands; the project's tree; the verdict: all read off the workbench, nothing computed.
[[nodiscard]] std::array<StepState, stepCount> stepStates(const Workbench& bench);
[[nodiscard]] std::vector<ProjectRow> projectRows(const Workbench& bench, const Visibility& visible);
[[nodiscard]] Verdict verdictOf(const Workbench& bench);

/// What a view with this content shows, in a word.
[[nodiscard]] scene::PanelContent stateChipFor(const Workbench& bench, ViewContent content);
/// The same where a view shows the mold.
[[nodiscard]] scene::PanelContent moldChip(const Workbench& bench);

/// "12.3°" with a true minus; a draft is rounded down, so that nothing is promised that does not hold.
[[nodiscard]] QString angleText(double degrees, int decimals = 1);
[[nodiscard]] QString draftText(double degrees);
[[nodiscard]] QString percentText(double fraction);
/// "×16".
[[nodiscard]] QString weightText(double weight);
/// Angle of direction 1 or 2 to the plane's normal, degrees.
[[nodiscard]] double tiltDegrees(const MoldState& state, int side);

} // namespace moldwright
