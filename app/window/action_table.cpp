// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/action_table.h"

#include "theme/icons.h"
#include "window/preferences.h"

#include <QCoreApplication>
#include <QtGlobal>

#include <algorithm>

namespace moldwright {

std::span<const ActionSpec> actionTable() {
    static const std::vector<ActionSpec> table = {
        {"open", QT_TRANSLATE_NOOP("Actions", "&File"), QT_TRANSLATE_NOOP("Actions", "&Open a part…"), "open",
         "Ctrl+O", QT_TRANSLATE_NOOP("Actions", "Open a mesh (STL, OBJ, PLY, OFF) or a Moldwright project."),
         Needs::Idle},
        {"start-page", QT_TRANSLATE_NOOP("Actions", "&File"), QT_TRANSLATE_NOOP("Actions", "&Close the part"),
         "close", "Ctrl+W", QT_TRANSLATE_NOOP("Actions", "Close the part and go back to the start page."),
         Needs::IdlePart},
        {"save", QT_TRANSLATE_NOOP("Actions", "&File"), QT_TRANSLATE_NOOP("Actions", "&Save"), "save",
         "Ctrl+S", QT_TRANSLATE_NOOP("Actions", "Save the project to its file."), Needs::IdlePart, false,
         true},
        {"save-as", QT_TRANSLATE_NOOP("Actions", "&File"), QT_TRANSLATE_NOOP("Actions", "Save &as…"), "save",
         "Ctrl+Shift+S", QT_TRANSLATE_NOOP("Actions", "Save the project to another file."), Needs::IdlePart},
        {"export-cast", QT_TRANSLATE_NOOP("Actions", "&File"),
         QT_TRANSLATE_NOOP("Actions", "&Export the shape…"), "export", "Ctrl+E",
         QT_TRANSLATE_NOOP("Actions", "Write the shape in view as STL, PLY, OBJ or OFF."), Needs::IdlePart,
         false, true},
        {"export-mold", QT_TRANSLATE_NOOP("Actions", "&File"),
         QT_TRANSLATE_NOOP("Actions", "Export the &halves…"), "export", "Ctrl+Shift+E",
         QT_TRANSLATE_NOOP("Actions", "Write both mold halves into a folder."), Needs::MoldBuilt},
        {"quit", QT_TRANSLATE_NOOP("Actions", "&File"), QT_TRANSLATE_NOOP("Actions", "&Quit"), "", "Ctrl+Q",
         QT_TRANSLATE_NOOP("Actions", "Close Moldwright."), Needs::Nothing, false, true},

        {"undo", QT_TRANSLATE_NOOP("Actions", "&Edit"), QT_TRANSLATE_NOOP("Actions", "&Undo"), "undo",
         "Ctrl+Z", QT_TRANSLATE_NOOP("Actions", "Take the last edit back."), Needs::Undo},
        {"redo", QT_TRANSLATE_NOOP("Actions", "&Edit"), QT_TRANSLATE_NOOP("Actions", "&Redo"), "redo",
         "Ctrl+Shift+Z", QT_TRANSLATE_NOOP("Actions", "Do the edit again."), Needs::Redo},
        {"copy-measured", QT_TRANSLATE_NOOP("Actions", "&Edit"),
         QT_TRANSLATE_NOOP("Actions", "&Copy what was measured"), "", "Ctrl+C",
         QT_TRANSLATE_NOOP("Actions", "Put the measured values on the clipboard, as text."), Needs::Measured,
         false, true},
        {"find-command", QT_TRANSLATE_NOOP("Actions", "&Edit"),
         QT_TRANSLATE_NOOP("Actions", "&Find a command"), "search", "Ctrl+K",
         QT_TRANSLATE_NOOP("Actions", "Find any command by its words."), Needs::Nothing, false, true},
        {"preferences", QT_TRANSLATE_NOOP("Actions", "&Edit"), QT_TRANSLATE_NOOP("Actions", "&Preferences…"),
         "scale", "Ctrl+,", QT_TRANSLATE_NOOP("Actions", "Theme, language, mouse, defaults and keys."),
         Needs::Nothing, false, true},

        {"fit", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "&Fit all"), "fit",
         "Shift+F", QT_TRANSLATE_NOOP("Actions", "Bring everything into sight."), Needs::Part},
        {"home", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "&Home view"), "", "0",
         QT_TRANSLATE_NOOP("Actions", "Look from the front, right and above."), Needs::Part},
        {"front", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "F&ront"), "", "1",
         QT_TRANSLATE_NOOP("Actions", "Look from the front."), Needs::Part},
        {"right", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "R&ight"), "", "3",
         QT_TRANSLATE_NOOP("Actions", "Look from the right."), Needs::Part},
        {"top", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "&Top"), "", "7",
         QT_TRANSLATE_NOOP("Actions", "Look from above."), Needs::Part},
        {"opposite", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "Opp&osite"), "",
         "9", QT_TRANSLATE_NOOP("Actions", "Look from the other side."), Needs::Part},
        {"along-normal", QT_TRANSLATE_NOOP("Actions", "&View"),
         QT_TRANSLATE_NOOP("Actions", "At the parting plane"), "", "8",
         QT_TRANSLATE_NOOP("Actions", "Look along the normal of the parting plane."), Needs::Plane},
        {"perspective", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "&Perspective"),
         "perspective", "5", QT_TRANSLATE_NOOP("Actions", "Show depth as the eye sees it, or without."),
         Needs::Nothing, true},
        {"one-view", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "&One view"), "one",
         "Alt+1", QT_TRANSLATE_NOOP("Actions", "Show one view."), Needs::Part, true, true},
        {"two-views", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "T&wo views"),
         "two", "Alt+2", QT_TRANSLATE_NOOP("Actions", "Show the part and its cast beside each other."),
         Needs::Part, true},
        {"four-views", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "Fo&ur views"),
         "four", "Alt+4",
         QT_TRANSLATE_NOOP("Actions", "Show it from above, from the front, from the right, and freely."),
         Needs::Part, true},
        {"link-views", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "Lin&k the views"),
         "link", "Shift+L", QT_TRANSLATE_NOOP("Actions", "Let all views move together."), Needs::Part, true},
        {"show-undercuts", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "&Undercuts"),
         "", "U", QT_TRANSLATE_NOOP("Actions", "Paint the faces below the required draft red."), Needs::Part,
         true, true},
        {"show-draft", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "&Draft map"), "",
         "D", QT_TRANSLATE_NOOP("Actions", "Paint every face by its draft angle."), Needs::Part, true},
        {"show-depth", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "Undercut d&epth"),
         "", "Shift+U", QT_TRANSLATE_NOOP("Actions", "Paint every undercut by how far it is blocked, in mm."),
         Needs::Part, true},
        {"show-deviation", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "De&viation"),
         "", "Shift+D", QT_TRANSLATE_NOOP("Actions", "Paint how far cast and part are apart, in mm."),
         Needs::Part, true},
        {"show-strain", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "&Strain"), "",
         "Shift+S", QT_TRANSLATE_NOOP("Actions", "Paint how much the surface was stretched, in percent."),
         Needs::Part, true},
        {"show-plain", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "P&lain"), "", "L",
         QT_TRANSLATE_NOOP("Actions", "Show the shape alone."), Needs::Part, true},
        {"show-plane", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "Parting plane"),
         "plane", "", QT_TRANSLATE_NOOP("Actions", "Show or hide the parting plane."), Needs::Nothing, true,
         true},
        {"show-directions", QT_TRANSLATE_NOOP("Actions", "&View"),
         QT_TRANSLATE_NOOP("Actions", "Removal directions"), "direction", "",
         QT_TRANSLATE_NOOP("Actions", "Show or hide both removal directions."), Needs::Nothing, true},
        {"show-edges", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "Mesh edges"),
         "edges", "", QT_TRANSLATE_NOOP("Actions", "Show or hide the edges of the faces."), Needs::Nothing,
         true},
        {"see-through", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "See-through"),
         "see-through", "", QT_TRANSLATE_NOOP("Actions", "Show the shape as if it were glass."),
         Needs::Nothing, true},
        {"measure", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "&Measure"),
         "measure", "M",
         QT_TRANSLATE_NOOP("Actions",
                           "Click places on the surface: draft, thickness, distance, angle. Esc leaves."),
         Needs::Part, true, true},
        {"section", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "Se&ction"),
         "section", "C",
         QT_TRANSLATE_NOOP("Actions", "Cut the view open at the parting plane, or anywhere along it."),
         Needs::Plane, true},
        {"screenshot", QT_TRANSLATE_NOOP("Actions", "&View"), QT_TRANSLATE_NOOP("Actions", "Save a picture…"),
         "camera", "", QT_TRANSLATE_NOOP("Actions", "Write the view as a PNG picture."), Needs::Part, false,
         true},
        {"turntable", QT_TRANSLATE_NOOP("Actions", "&View"),
         QT_TRANSLATE_NOOP("Actions", "Save a t&urntable…"), "turntable", "",
         QT_TRANSLATE_NOOP("Actions", "Turn the view once around and write an animated PNG. Esc stops."),
         Needs::IdlePart},

        {"lay-flat", QT_TRANSLATE_NOOP("Actions", "&Part"),
         QT_TRANSLATE_NOOP("Actions", "&Lay flat on a face"), "lay-flat", "",
         QT_TRANSLATE_NOOP("Actions", "Click the face that shall lie on the ground. Esc leaves."),
         Needs::IdlePart, true},
        {"turn-x", QT_TRANSLATE_NOOP("Actions", "&Part"), QT_TRANSLATE_NOOP("Actions", "Turn about &X"),
         "turn", "", QT_TRANSLATE_NOOP("Actions", "Turn the part by 90° about the x axis."), Needs::IdlePart,
         false, true},
        {"turn-y", QT_TRANSLATE_NOOP("Actions", "&Part"), QT_TRANSLATE_NOOP("Actions", "Turn about &Y"),
         "turn", "", QT_TRANSLATE_NOOP("Actions", "Turn the part by 90° about the y axis."), Needs::IdlePart},
        {"turn-z", QT_TRANSLATE_NOOP("Actions", "&Part"), QT_TRANSLATE_NOOP("Actions", "Turn about &Z"),
         "turn", "", QT_TRANSLATE_NOOP("Actions", "Turn the part by 90° about the z axis."), Needs::IdlePart},
        {"turn-by", QT_TRANSLATE_NOOP("Actions", "&Part"), QT_TRANSLATE_NOOP("Actions", "Tu&rn by an angle…"),
         "turn", "R", QT_TRANSLATE_NOOP("Actions", "Turn the part about an axis, by any angle."),
         Needs::IdlePart},
        {"centre", QT_TRANSLATE_NOOP("Actions", "&Part"), QT_TRANSLATE_NOOP("Actions", "Move to the &middle"),
         "move", "",
         QT_TRANSLATE_NOOP("Actions", "Put the middle of the part above the origin, on the ground."),
         Needs::IdlePart},

        {"best-plane", QT_TRANSLATE_NOOP("Actions", "P&lane"), QT_TRANSLATE_NOOP("Actions", "&Best plane"),
         "candidates", "Ctrl+B",
         QT_TRANSLATE_NOOP("Actions", "Search all planes for the one that leaves the least to deform."),
         Needs::IdlePart},
        {"next-plane", QT_TRANSLATE_NOOP("Actions", "P&lane"),
         QT_TRANSLATE_NOOP("Actions", "&Next best plane"), "candidates", "Ctrl+Shift+B",
         QT_TRANSLATE_NOOP("Actions", "Take the next plane of the last search."), Needs::IdlePlane},
        {"suggested-plane", QT_TRANSLATE_NOOP("Actions", "P&lane"),
         QT_TRANSLATE_NOOP("Actions", "Take the &suggested plane"), "candidates", "",
         QT_TRANSLATE_NOOP("Actions", "Part the part where nothing stands in the way of the mold."),
         Needs::SuggestedPlane},
        {"best-directions", QT_TRANSLATE_NOOP("Actions", "P&lane"),
         QT_TRANSLATE_NOOP("Actions", "Best &directions"), "direction", "",
         QT_TRANSLATE_NOOP("Actions", "Tilt both directions to where the least is left to deform."),
         Needs::IdlePlane, false, true},
        {"normal-directions", QT_TRANSLATE_NOOP("Actions", "P&lane"),
         QT_TRANSLATE_NOOP("Actions", "Directions along the &normal"), "direction", "",
         QT_TRANSLATE_NOOP("Actions", "Let both halves leave straight along the plane's normal."),
         Needs::IdlePlane},
        {"plane-x", QT_TRANSLATE_NOOP("Actions", "P&lane"), QT_TRANSLATE_NOOP("Actions", "Square to &X"),
         "plane", "Shift+X",
         QT_TRANSLATE_NOOP("Actions",
                           "Turn the plane square to the x axis; it stays where it is in the part."),
         Needs::IdlePlane, false, true},
        {"plane-y", QT_TRANSLATE_NOOP("Actions", "P&lane"), QT_TRANSLATE_NOOP("Actions", "Square to &Y"),
         "plane", "Shift+Y",
         QT_TRANSLATE_NOOP("Actions",
                           "Turn the plane square to the y axis; it stays where it is in the part."),
         Needs::IdlePlane},
        {"plane-z", QT_TRANSLATE_NOOP("Actions", "P&lane"), QT_TRANSLATE_NOOP("Actions", "Square to &Z"),
         "plane", "Shift+Z",
         QT_TRANSLATE_NOOP("Actions",
                           "Turn the plane square to the z axis; it stays where it is in the part."),
         Needs::IdlePlane},
        {"plane-by-points", QT_TRANSLATE_NOOP("Actions", "P&lane"),
         QT_TRANSLATE_NOOP("Actions", "Through three &points"), "plane", "T",
         QT_TRANSLATE_NOOP("Actions", "Click three places that the plane shall run through. Esc leaves."),
         Needs::IdlePlane, true},
        {"plane-on-face", QT_TRANSLATE_NOOP("Actions", "P&lane"), QT_TRANSLATE_NOOP("Actions", "On a &face"),
         "plane", "Shift+T",
         QT_TRANSLATE_NOOP("Actions", "Click the face that the plane shall lie in. Esc leaves."),
         Needs::IdlePlane, true},

        {"pin", QT_TRANSLATE_NOOP("Actions", "&Guides"), QT_TRANSLATE_NOOP("Actions", "&Pin a point"), "pin",
         "P",
         QT_TRANSLATE_NOOP("Actions",
                           "Click points of the part that shall lie on the parting plane. Esc leaves."),
         Needs::IdlePart, true},
        {"pin-inside", QT_TRANSLATE_NOOP("Actions", "&Guides"),
         QT_TRANSLATE_NOOP("Actions", "Pin a point &inside"), "pin-inside", "Shift+P",
         QT_TRANSLATE_NOOP("Actions",
                           "Click to pin the point farthest inside below the pointer. Esc leaves."),
         Needs::IdlePart, true},
        {"suggest-pins", QT_TRANSLATE_NOOP("Actions", "&Guides"),
         QT_TRANSLATE_NOOP("Actions", "&Suggest pins"), "candidates", "Ctrl+G",
         QT_TRANSLATE_NOOP("Actions",
                           "Look for points worth pinning: ends of limbs, where limbs meet, along the body."),
         Needs::IdlePart, false, true},
        {"accept-tips", QT_TRANSLATE_NOOP("Actions", "&Guides"), QT_TRANSLATE_NOOP("Actions", "Accept &tips"),
         "pin", "Ctrl+Shift+G",
         QT_TRANSLATE_NOOP("Actions", "Pin all suggested points that are ends of limbs."),
         Needs::SuggestedTips},
        {"remove-pin", QT_TRANSLATE_NOOP("Actions", "&Guides"),
         QT_TRANSLATE_NOOP("Actions", "&Remove the pin"), "close", "Del",
         QT_TRANSLATE_NOOP("Actions", "Remove the pin that is chosen."), Needs::ChosenPin, false, true},
        {"clear-pins", QT_TRANSLATE_NOOP("Actions", "&Guides"),
         QT_TRANSLATE_NOOP("Actions", "Remove &all pins"), "close", "",
         QT_TRANSLATE_NOOP("Actions", "Remove all pins; the suggested ones stay."), Needs::Pins},
        {"import-pins", QT_TRANSLATE_NOOP("Actions", "&Guides"),
         QT_TRANSLATE_NOOP("Actions", "Pins from a &file…"), "open", "",
         QT_TRANSLATE_NOOP("Actions", "Read pins from a JSON file, as the command line takes it."),
         Needs::IdlePart, false, true},
        {"export-pins", QT_TRANSLATE_NOOP("Actions", "&Guides"),
         QT_TRANSLATE_NOOP("Actions", "Pins &into a file…"), "export", "",
         QT_TRANSLATE_NOOP("Actions", "Write all pins as JSON for the command line or another project."),
         Needs::Pins},

        {"run", QT_TRANSLATE_NOOP("Actions", "&Deform"), QT_TRANSLATE_NOOP("Actions", "&Run"), "play",
         "Ctrl+Return", QT_TRANSLATE_NOOP("Actions", "Bend the part until it leaves the mold, and prove it."),
         Needs::IdlePlane},
        {"fill-and-run", QT_TRANSLATE_NOOP("Actions", "&Deform"),
         QT_TRANSLATE_NOOP("Actions", "Fi&ll and run"), "cavity", "",
         QT_TRANSLATE_NOOP("Actions", "Run, and fill the places that no bending frees."), Needs::IdlePlane},
        {"find-undercuts", QT_TRANSLATE_NOOP("Actions", "&Deform"),
         QT_TRANSLATE_NOOP("Actions", "Find &undercuts"), "cavity", "Ctrl+Shift+U",
         QT_TRANSLATE_NOOP("Actions", "List the undercuts at this plane, to have each one bent or filled."),
         Needs::IdlePlane},
        {"fill-here", QT_TRANSLATE_NOOP("Actions", "&Deform"),
         QT_TRANSLATE_NOOP("Actions", "Fill or &join here"), "cavity", "",
         QT_TRANSLATE_NOOP("Actions", "Have what the chosen obstruction spans filled; Run bends the rest."),
         Needs::FillableObstruction},
        {"finish", QT_TRANSLATE_NOOP("Actions", "&Deform"), QT_TRANSLATE_NOOP("Actions", "&Finish"), "finish",
         "Ctrl+Shift+Return",
         QT_TRANSLATE_NOOP("Actions", "Bend no further: finish the shape from where it is, and prove it."),
         Needs::Bending},
        {"pause", QT_TRANSLATE_NOOP("Actions", "&Deform"), QT_TRANSLATE_NOOP("Actions", "&Pause"), "pause",
         "Space", QT_TRANSLATE_NOOP("Actions", "Hold the shape where it is, or bend it further."),
         Needs::Running},
        {"stop", QT_TRANSLATE_NOOP("Actions", "&Deform"), QT_TRANSLATE_NOOP("Actions", "&Stop"), "stop",
         "Ctrl+.", QT_TRANSLATE_NOOP("Actions", "End the run; the shape it reached is kept."),
         Needs::Running},
        {"restore", QT_TRANSLATE_NOOP("Actions", "&Deform"),
         QT_TRANSLATE_NOOP("Actions", "Restore original shape"), "restore", "",
         QT_TRANSLATE_NOOP("Actions", "Back to the undeformed part; the plane stays."), Needs::CastShape,
         false, true},

        {"build-mold", QT_TRANSLATE_NOOP("Actions", "&Mold"), QT_TRANSLATE_NOOP("Actions", "&Build mold"),
         "mold", "Ctrl+M",
         QT_TRANSLATE_NOOP("Actions", "Make both mold halves around the cast, and prove that they come off."),
         Needs::ProvedCast},
        {"open-mold", QT_TRANSLATE_NOOP("Actions", "&Mold"),
         QT_TRANSLATE_NOOP("Actions", "&Open or close the mold"), "explode", "X",
         QT_TRANSLATE_NOOP("Actions", "Move the halves apart along their directions, or together."),
         Needs::MoldBuilt},

        {"print-report", QT_TRANSLATE_NOOP("Actions", "&Report"),
         QT_TRANSLATE_NOOP("Actions", "&Print report…"), "print", "Ctrl+P",
         QT_TRANSLATE_NOOP("Actions", "Make a PDF with pictures, draft, volumes and the proof."),
         Needs::CastShape},

        {"theme-light", QT_TRANSLATE_NOOP("Actions", "&Window"), QT_TRANSLATE_NOOP("Actions", "&Light"), "",
         "", QT_TRANSLATE_NOOP("Actions", "Use the light theme."), Needs::Nothing, true},
        {"theme-dark", QT_TRANSLATE_NOOP("Actions", "&Window"), QT_TRANSLATE_NOOP("Actions", "&Dark"), "", "",
         QT_TRANSLATE_NOOP("Actions", "Use the dark theme."), Needs::Nothing, true},
        {"theme-system", QT_TRANSLATE_NOOP("Actions", "&Window"),
         QT_TRANSLATE_NOOP("Actions", "Like the desk&top"), "", "",
         QT_TRANSLATE_NOOP("Actions", "Follow the desktop's colours."), Needs::Nothing, true},
        {"step-part", QT_TRANSLATE_NOOP("Actions", "&Window"), QT_TRANSLATE_NOOP("Actions", "Go to Part"), "",
         "Ctrl+1", QT_TRANSLATE_NOOP("Actions", "Go to the step Part."), Needs::Part, false, true},
        {"step-plane", QT_TRANSLATE_NOOP("Actions", "&Window"), QT_TRANSLATE_NOOP("Actions", "Go to Plane"),
         "", "Ctrl+2", QT_TRANSLATE_NOOP("Actions", "Go to the step Plane."), Needs::Part},
        {"step-guides", QT_TRANSLATE_NOOP("Actions", "&Window"), QT_TRANSLATE_NOOP("Actions", "Go to Guides"),
         "", "Ctrl+3", QT_TRANSLATE_NOOP("Actions", "Go to the step Guides."), Needs::Part},
        {"step-deform", QT_TRANSLATE_NOOP("Actions", "&Window"), QT_TRANSLATE_NOOP("Actions", "Go to Deform"),
         "", "Ctrl+4", QT_TRANSLATE_NOOP("Actions", "Go to the step Deform."), Needs::Part},
        {"step-check", QT_TRANSLATE_NOOP("Actions", "&Window"), QT_TRANSLATE_NOOP("Actions", "Go to Check"),
         "", "Ctrl+5", QT_TRANSLATE_NOOP("Actions", "Go to the step Check."), Needs::Part},
        {"step-mold", QT_TRANSLATE_NOOP("Actions", "&Window"), QT_TRANSLATE_NOOP("Actions", "Go to Mold"), "",
         "Ctrl+6", QT_TRANSLATE_NOOP("Actions", "Go to the step Mold."), Needs::Part},
        {"step-report", QT_TRANSLATE_NOOP("Actions", "&Window"), QT_TRANSLATE_NOOP("Actions", "Go to Report"),
         "", "Ctrl+7", QT_TRANSLATE_NOOP("Actions", "Go to the step Report."), Needs::Part},
        {"next-zone", QT_TRANSLATE_NOOP("Actions", "&Window"), QT_TRANSLATE_NOOP("Actions", "Next area"), "",
         "F6", QT_TRANSLATE_NOOP("Actions", "Move the keyboard to the next area of the window."),
         Needs::Nothing, false, true},
        {"previous-zone", QT_TRANSLATE_NOOP("Actions", "&Window"),
         QT_TRANSLATE_NOOP("Actions", "Previous area"), "", "Shift+F6",
         QT_TRANSLATE_NOOP("Actions", "Move the keyboard to the previous area of the window."),
         Needs::Nothing},
        {"reset-layout", QT_TRANSLATE_NOOP("Actions", "&Window"),
         QT_TRANSLATE_NOOP("Actions", "&Reset the layout"), "", "",
         QT_TRANSLATE_NOOP("Actions", "Put all panels back where they were at first."), Needs::Nothing},

        {"keys", QT_TRANSLATE_NOOP("Actions", "&Help"), QT_TRANSLATE_NOOP("Actions", "&Keys and mouse"),
         "keys", "?", QT_TRANSLATE_NOOP("Actions", "Show all keys on one sheet.")},
        {"tour", QT_TRANSLATE_NOOP("Actions", "&Help"), QT_TRANSLATE_NOOP("Actions", "Take the &tour"),
         "tour", "", QT_TRANSLATE_NOOP("Actions", "Five steps from a part to its mold, at your own pace."),
         Needs::Nothing},
        {"about", QT_TRANSLATE_NOOP("Actions", "&Help"), QT_TRANSLATE_NOOP("Actions", "&About Moldwright"),
         "info", "", QT_TRANSLATE_NOOP("Actions", "Version, licence, libraries.")},
    };
    return table;
}

namespace {

/// The tool tip tells the keys, so both change together.
void giveKeys(QAction& action, const QKeySequence& keys) {
    action.setShortcut(keys);
    const QString words = keys.toString(QKeySequence::NativeText);
    action.setToolTip(words.isEmpty() ? action.statusTip()
                                      : QStringLiteral("%1 (%2)").arg(action.statusTip(), words));
}

} // namespace

Actions::Actions(QObject* parent) : QObject(parent) {
    const auto translated = [](const char* text) { return QCoreApplication::translate("Actions", text); };
    for (const ActionSpec& spec : actionTable()) {
        auto* action = new QAction(translated(spec.text), this);
        action->setObjectName(QString::fromLatin1(spec.id));
        action->setProperty("menu", translated(spec.menu));
        action->setProperty("iconName", QString::fromLatin1(spec.icon));
        if (*spec.icon)
            action->setIcon(themeIcon(QString::fromLatin1(spec.icon)));
        action->setShortcutContext(Qt::WindowShortcut);
        action->setStatusTip(translated(spec.hint));
        action->setCheckable(spec.checkable);
        m_actions[action->objectName()] = action;
        m_ordered.push_back(action);
        giveKeys(*action, preferences::keysOf(action->objectName())
                              .value_or(QKeySequence(QString::fromLatin1(spec.shortcut))));
    }
}

QKeySequence Actions::firstKeys(const QString& id) const {
    for (const ActionSpec& spec : actionTable())
        if (id == QLatin1String(spec.id))
            return QKeySequence(QString::fromLatin1(spec.shortcut));
    return {};
}

void Actions::setKeys(const QString& id, const QKeySequence& keys) {
    preferences::setKeysOf(id, keys == firstKeys(id) ? std::nullopt : std::optional(keys));
    giveKeys(*m_actions.at(id), keys);
}

void Actions::resetKeys() {
    for (const auto& [id, action] : m_actions)
        setKeys(id, firstKeys(id));
}

bool Actions::anyKeysChanged() const {
    return std::ranges::any_of(m_ordered, [&](const QAction* action) {
        return action->shortcut() != firstKeys(action->objectName());
    });
}

const QAction* Actions::withKeys(const QKeySequence& keys) const {
    const auto found =
        std::ranges::find_if(m_ordered, [&](const QAction* action) { return action->shortcut() == keys; });
    return keys.isEmpty() || found == m_ordered.end() ? nullptr : *found;
}

void Actions::on(const QString& id, const std::function<void()>& run) {
    connect(m_actions.at(id), &QAction::triggered, this, [run] { run(); });
}

void Actions::update(const std::function<bool(Needs)>& isSo) {
    std::size_t i = 0;
    for (const ActionSpec& spec : actionTable())
        m_ordered[i++]->setEnabled(isSo(spec.needs));
}

} // namespace moldwright
