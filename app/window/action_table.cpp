// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/action_table.h"

#include "theme/icons.h"

#include <QCoreApplication>
#include <QtGlobal>

namespace moldwright {

#define WORDS(text) QT_TRANSLATE_NOOP("Actions", text)

std::span<const ActionSpec> actionTable() {
    static const std::vector<ActionSpec> table = {
        {"open", WORDS("&File"), WORDS("&Open a part…"), "open", "Ctrl+O",
         WORDS("Open a mesh (STL, OBJ, PLY, OFF) or a Moldwright project."), Needs::Idle},
        {"start-page", WORDS("&File"), WORDS("&Close the part"), "close", "Ctrl+W",
         WORDS("Close the part and go back to the start page."), Needs::IdlePart},
        {"save", WORDS("&File"), WORDS("&Save"), "save", "Ctrl+S", WORDS("Save the project to its file."),
         Needs::IdlePart, false, true},
        {"save-as", WORDS("&File"), WORDS("Save &as…"), "save", "Ctrl+Shift+S",
         WORDS("Save the project to another file."), Needs::IdlePart},
        {"export-cast", WORDS("&File"), WORDS("&Export the shape…"), "export", "Ctrl+E",
         WORDS("Write the shape in view as STL, PLY, OBJ or OFF."), Needs::IdlePart, false, true},
        {"export-mold", WORDS("&File"), WORDS("Export the &halves…"), "export", "Ctrl+Shift+E",
         WORDS("Write both mold halves into a folder."), Needs::MoldBuilt},
        {"quit", WORDS("&File"), WORDS("&Quit"), "", "Ctrl+Q", WORDS("Close Moldwright."), Needs::Nothing,
         false, true},

        {"undo", WORDS("&Edit"), WORDS("&Undo"), "undo", "Ctrl+Z", WORDS("Take the last edit back."),
         Needs::Undo},
        {"redo", WORDS("&Edit"), WORDS("&Redo"), "redo", "Ctrl+Shift+Z", WORDS("Do the edit again."),
         Needs::Redo},
        {"find-command", WORDS("&Edit"), WORDS("&Find a command"), "search", "Ctrl+K",
         WORDS("Find any command by its words."), Needs::Nothing, false, true},

        {"fit", WORDS("&View"), WORDS("&Fit all"), "fit", "Shift+F", WORDS("Bring everything into sight."),
         Needs::Part},
        {"home", WORDS("&View"), WORDS("&Home view"), "", "0", WORDS("Look from the front, right and above."),
         Needs::Part},
        {"front", WORDS("&View"), WORDS("F&ront"), "", "1", WORDS("Look from the front."), Needs::Part},
        {"right", WORDS("&View"), WORDS("R&ight"), "", "3", WORDS("Look from the right."), Needs::Part},
        {"top", WORDS("&View"), WORDS("&Top"), "", "7", WORDS("Look from above."), Needs::Part},
        {"opposite", WORDS("&View"), WORDS("Opp&osite"), "", "9", WORDS("Look from the other side."),
         Needs::Part},
        {"along-normal", WORDS("&View"), WORDS("At the parting plane"), "", "8",
         WORDS("Look along the normal of the parting plane."), Needs::Plane},
        {"perspective", WORDS("&View"), WORDS("&Perspective"), "perspective", "5",
         WORDS("Show depth as the eye sees it, or without."), Needs::Nothing, true},
        {"show-undercuts", WORDS("&View"), WORDS("&Undercuts"), "", "U",
         WORDS("Paint the faces below the required draft red."), Needs::Part, true, true},
        {"show-draft", WORDS("&View"), WORDS("&Draft map"), "", "D",
         WORDS("Paint every face by its draft angle."), Needs::Part, true},
        {"show-plain", WORDS("&View"), WORDS("P&lain"), "", "L", WORDS("Show the shape alone."), Needs::Part,
         true},
        {"show-plane", WORDS("&View"), WORDS("Parting plane"), "plane", "",
         WORDS("Show or hide the parting plane."), Needs::Nothing, true, true},
        {"show-directions", WORDS("&View"), WORDS("Removal directions"), "direction", "",
         WORDS("Show or hide both removal directions."), Needs::Nothing, true},
        {"show-edges", WORDS("&View"), WORDS("Mesh edges"), "edges", "",
         WORDS("Show or hide the edges of the faces."), Needs::Nothing, true},
        {"see-through", WORDS("&View"), WORDS("See-through"), "see-through", "",
         WORDS("Show the shape as if it were glass."), Needs::Nothing, true},
        {"screenshot", WORDS("&View"), WORDS("Save a picture…"), "camera", "",
         WORDS("Write the view as a PNG picture."), Needs::Part, false, true},

        {"lay-flat", WORDS("&Part"), WORDS("&Lay flat on a face"), "lay-flat", "",
         WORDS("Click the face that shall lie on the ground. Esc leaves."), Needs::IdlePart, true},
        {"turn-x", WORDS("&Part"), WORDS("Turn about &X"), "turn", "",
         WORDS("Turn the part by 90° about the x axis."), Needs::IdlePart, false, true},
        {"turn-y", WORDS("&Part"), WORDS("Turn about &Y"), "turn", "",
         WORDS("Turn the part by 90° about the y axis."), Needs::IdlePart},
        {"turn-z", WORDS("&Part"), WORDS("Turn about &Z"), "turn", "",
         WORDS("Turn the part by 90° about the z axis."), Needs::IdlePart},
        {"centre", WORDS("&Part"), WORDS("Move to the &middle"), "move", "",
         WORDS("Put the middle of the part above the origin, on the ground."), Needs::IdlePart},

        {"best-plane", WORDS("P&lane"), WORDS("&Best plane"), "candidates", "Ctrl+B",
         WORDS("Search all planes for the one that leaves the least to deform."), Needs::IdlePart},
        {"next-plane", WORDS("P&lane"), WORDS("&Next best plane"), "candidates", "Ctrl+Shift+B",
         WORDS("Take the next plane of the last search."), Needs::IdlePlane},
        {"best-directions", WORDS("P&lane"), WORDS("Best &directions"), "direction", "",
         WORDS("Tilt both directions to where the least is left to deform."), Needs::IdlePlane, false, true},
        {"normal-directions", WORDS("P&lane"), WORDS("Directions along the &normal"), "direction", "",
         WORDS("Let both halves leave straight along the plane's normal."), Needs::IdlePlane},

        {"run", WORDS("&Deform"), WORDS("&Run"), "play", "Ctrl+Return",
         WORDS("Bend the part until it leaves the mold, and prove it."), Needs::IdlePlane},
        {"stop", WORDS("&Deform"), WORDS("&Stop"), "stop", "Ctrl+.", WORDS("Stop; the part stays as it was."),
         Needs::Running},
        {"restore", WORDS("&Deform"), WORDS("Restore original shape"), "restore", "",
         WORDS("Back to the undeformed part; the plane stays."), Needs::CastShape, false, true},

        {"build-mold", WORDS("&Mold"), WORDS("&Build mold"), "mold", "Ctrl+M",
         WORDS("Make both mold halves around the cast, and prove that they come off."), Needs::ProvedCast},
        {"open-mold", WORDS("&Mold"), WORDS("&Open or close the mold"), "explode", "X",
         WORDS("Move the halves apart along their directions, or together."), Needs::MoldBuilt},

        {"print-report", WORDS("&Report"), WORDS("&Print report…"), "print", "Ctrl+P",
         WORDS("Make a PDF with pictures, draft, volumes and the proof."), Needs::CastShape},

        {"theme-light", WORDS("&Window"), WORDS("&Light"), "", "", WORDS("Use the light theme."),
         Needs::Nothing, true},
        {"theme-dark", WORDS("&Window"), WORDS("&Dark"), "", "", WORDS("Use the dark theme."), Needs::Nothing,
         true},
        {"theme-system", WORDS("&Window"), WORDS("Like the desk&top"), "", "",
         WORDS("Follow the desktop's colours."), Needs::Nothing, true},
        {"next-zone", WORDS("&Window"), WORDS("Next area"), "", "F6",
         WORDS("Move the keyboard to the next area of the window."), Needs::Nothing, false, true},
        {"previous-zone", WORDS("&Window"), WORDS("Previous area"), "", "Shift+F6",
         WORDS("Move the keyboard to the previous area of the window."), Needs::Nothing},
        {"reset-layout", WORDS("&Window"), WORDS("&Reset the layout"), "", "",
         WORDS("Put all panels back where they were at first."), Needs::Nothing},

        {"keys", WORDS("&Help"), WORDS("&Keys and mouse"), "keys", "?", WORDS("Show all keys on one sheet.")},
        {"about", WORDS("&Help"), WORDS("&About Moldwright"), "info", "",
         WORDS("Version, licence, libraries.")},
    };
    return table;
}

#undef WORDS

Actions::Actions(QObject* parent) : QObject(parent) {
    const auto translated = [](const char* text) { return QCoreApplication::translate("Actions", text); };
    for (const ActionSpec& spec : actionTable()) {
        auto* action = new QAction(translated(spec.text), this);
        action->setObjectName(QString::fromLatin1(spec.id));
        action->setProperty("menu", translated(spec.menu));
        action->setProperty("iconName", QString::fromLatin1(spec.icon));
        if (*spec.icon)
            action->setIcon(themeIcon(QString::fromLatin1(spec.icon)));
        action->setShortcut(QKeySequence(QString::fromLatin1(spec.shortcut)));
        action->setShortcutContext(Qt::WindowShortcut);
        action->setStatusTip(translated(spec.hint));
        const QString keys = action->shortcut().toString(QKeySequence::NativeText);
        action->setToolTip(keys.isEmpty() ? translated(spec.hint)
                                          : QStringLiteral("%1 (%2)").arg(translated(spec.hint), keys));
        action->setCheckable(spec.checkable);
        m_actions[action->objectName()] = action;
        m_ordered.push_back(action);
    }
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
