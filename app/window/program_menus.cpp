// SPDX-License-Identifier: AGPL-3.0-or-later
// The commands that every program has, and those of the views.
#include "window/action_menus.h"

namespace moldwright {

std::vector<ActionSpec> ActionMenus::file() {
    return {
        {"open", QT_TR_NOOP("&Open a part…"), "open", "Ctrl+O",
         QT_TR_NOOP("Open a mesh (STL, OBJ, PLY, OFF) or a Moldwright project."), Needs::Idle},
        {"start-page", QT_TR_NOOP("&Close the part"), "close", "Ctrl+W",
         QT_TR_NOOP("Close the part and go back to the start page."), Needs::IdleInView},
        {"read-again", QT_TR_NOOP("Read the file &again"), "redo", "F5",
         QT_TR_NOOP(
             "Read the mesh that cannot be used once more, after it was mended in the program that made it."),
         Needs::Refused},
        {"repair-mesh", QT_TR_NOOP("Re&pair the mesh"), "finish", "Ctrl+R",
         QT_TR_NOOP(
             "Mend what is wrong with the mesh, or make a closed skin about it, and open that. The file "
             "stays as it is."),
         Needs::Refused},
        {"leave-refused", QT_TR_NOOP("&Back to what was open"), "restore", "",
         QT_TR_NOOP("Leave the mesh that cannot be used; what was open before comes back. Esc does so too."),
         Needs::Refused},
        {"save", QT_TR_NOOP("&Save"), "save", "Ctrl+S", QT_TR_NOOP("Save the project to its file."),
         Needs::IdlePart, false, true},
        {"save-as", QT_TR_NOOP("Save &as…"), "save", "Ctrl+Shift+S",
         QT_TR_NOOP("Save the project to another file."), Needs::IdlePart},
        {"recover", QT_TR_NOOP("Re&cover lost work"), "restore", "",
         QT_TR_NOOP("Open what was not saved last time."), Needs::LostWork},
        {"export-cast", QT_TR_NOOP("&Export the shape…"), "export", "Ctrl+E",
         QT_TR_NOOP("Write the shape in view as STL, PLY, OBJ or OFF."), Needs::IdlePart, false, true},
        {"export-mold", QT_TR_NOOP("Export the &halves…"), "export", "Ctrl+Shift+E",
         QT_TR_NOOP("Write both mold halves into a folder."), Needs::MoldBuilt},
        {"quit", QT_TR_NOOP("&Quit"), "", "Ctrl+Q", QT_TR_NOOP("Close Moldwright."), Needs::Nothing, false,
         true},
    };
}

std::vector<ActionSpec> ActionMenus::edit() {
    return {
        {"undo", QT_TR_NOOP("&Undo"), "undo", "Ctrl+Z", QT_TR_NOOP("Take the last edit back."), Needs::Undo},
        {"redo", QT_TR_NOOP("&Redo"), "redo", "Ctrl+Shift+Z", QT_TR_NOOP("Do the edit again."), Needs::Redo},
        {"copy-measured", QT_TR_NOOP("&Copy what was measured"), "", "Ctrl+C",
         QT_TR_NOOP("Put the measured values on the clipboard, as text."), Needs::Measured, false, true},
        {"copy-diagnosis", QT_TR_NOOP("Copy the &diagnosis"), "", "",
         QT_TR_NOOP("Put all that is wrong with the mesh on the clipboard, as text."), Needs::Refused},
        {"rename", QT_TR_NOOP("R&ename"), "", "F2", QT_TR_NOOP("Give what is chosen another name."),
         Needs::Renamable, false, true},
        {"hide", QT_TR_NOOP("&Show or hide"), "eye", "H", QT_TR_NOOP("Show or hide what is chosen."),
         Needs::Hideable},
        {"find-command", QT_TR_NOOP("&Find a command"), "search", "Ctrl+K",
         QT_TR_NOOP("Find any command by its words."), Needs::Nothing, false, true},
        {"preferences", QT_TR_NOOP("&Preferences…"), "scale", "Ctrl+,",
         QT_TR_NOOP("Theme, language, mouse, defaults and keys."), Needs::Nothing, false, true},
    };
}

std::vector<ActionSpec> ActionMenus::view() {
    return {
        {"fit", QT_TR_NOOP("&Fit all"), "fit", "Shift+F", QT_TR_NOOP("Bring everything into sight."),
         Needs::InView},
        {"fit-selection", QT_TR_NOOP("Fit what is &chosen"), "fit", "F",
         QT_TR_NOOP("Bring what is chosen in the project into sight; else everything."), Needs::InView},
        {"next-fault", QT_TR_NOOP("Show the ne&xt place"), "search", "F3",
         QT_TR_NOOP("Bring the next place where the mesh cannot be used into sight."), Needs::FaultPlace},
        {"home", QT_TR_NOOP("&Home view"), "", "0", QT_TR_NOOP("Look from the front, right and above."),
         Needs::InView},
        {"front", QT_TR_NOOP("F&ront"), "", "1", QT_TR_NOOP("Look from the front."), Needs::InView},
        {"right", QT_TR_NOOP("R&ight"), "", "3", QT_TR_NOOP("Look from the right."), Needs::InView},
        {"top", QT_TR_NOOP("&Top"), "", "7", QT_TR_NOOP("Look from above."), Needs::InView},
        {"opposite", QT_TR_NOOP("Opp&osite"), "", "9", QT_TR_NOOP("Look from the other side."),
         Needs::InView},
        {"along-normal", QT_TR_NOOP("At the parting plane"), "", "8",
         QT_TR_NOOP("Look along the normal of the parting plane."), Needs::Plane},
        {"perspective", QT_TR_NOOP("&Perspective"), "perspective", "5",
         QT_TR_NOOP("Show depth as the eye sees it, or without."), Needs::Nothing, true},
        {"one-view", QT_TR_NOOP("&One view"), "one", "Alt+1", QT_TR_NOOP("Show one view."), Needs::InView,
         true, true},
        {"two-views", QT_TR_NOOP("T&wo views"), "two", "Alt+2",
         QT_TR_NOOP("Show the part and its cast beside each other."), Needs::InView, true},
        {"four-views", QT_TR_NOOP("Fo&ur views"), "four", "Alt+4",
         QT_TR_NOOP("Show it from above, from the front, from the right, and freely."), Needs::InView, true},
        {"link-views", QT_TR_NOOP("Lin&k the views"), "link", "Shift+L",
         QT_TR_NOOP("Let all views move together."), Needs::InView, true},
        {"show-undercuts", QT_TR_NOOP("&Undercuts"), "", "U",
         QT_TR_NOOP("Paint the faces below the required draft red."), Needs::Part, true, true},
        {"show-draft", QT_TR_NOOP("&Draft map"), "", "D", QT_TR_NOOP("Paint every face by its draft angle."),
         Needs::Part, true},
        {"show-depth", QT_TR_NOOP("Undercut d&epth"), "", "Shift+U",
         QT_TR_NOOP("Paint every undercut by how far it is blocked, in mm."), Needs::Part, true},
        {"show-deviation", QT_TR_NOOP("De&viation"), "", "Shift+D",
         QT_TR_NOOP("Paint how far cast and part are apart, in mm."), Needs::Part, true},
        {"show-difference", QT_TR_NOOP("Differe&nce"), "", "Shift+V",
         QT_TR_NOOP("Paint how far the casts of two compared variants are apart, in mm."), Needs::Part, true},
        {"show-strain", QT_TR_NOOP("&Strain"), "", "Shift+S",
         QT_TR_NOOP("Paint how much the surface was stretched, in percent."), Needs::Part, true},
        {"show-importance", QT_TR_NOOP("&Importance"), "", "I",
         QT_TR_NOOP("Paint every face by how important it is to keep its shape."), Needs::Part, true},
        {"show-steel", QT_TR_NOOP("S&teel"), "", "Shift+M",
         QT_TR_NOOP("Paint the walls of the mold by the steel behind them, in mm."), Needs::Part, true},
        {"show-plain", QT_TR_NOOP("P&lain"), "", "L", QT_TR_NOOP("Show the shape alone."), Needs::Part, true},
        {"show-plane", QT_TR_NOOP("Parting plane"), "plane", "",
         QT_TR_NOOP("Show or hide the parting plane."), Needs::Nothing, true, true},
        {"show-directions", QT_TR_NOOP("Removal directions"), "direction", "",
         QT_TR_NOOP("Show or hide both removal directions."), Needs::Nothing, true},
        {"show-edges", QT_TR_NOOP("Mesh edges"), "edges", "",
         QT_TR_NOOP("Show or hide the edges of the faces."), Needs::Nothing, true},
        {"see-through", QT_TR_NOOP("See-through"), "see-through", "",
         QT_TR_NOOP("Show the shape as if it were glass."), Needs::Nothing, true},
        {"measure", QT_TR_NOOP("&Measure"), "measure", "M",
         QT_TR_NOOP("Click places on the surface: draft, thickness, distance, angle. Esc leaves."),
         Needs::Part, true, true},
        {"section", QT_TR_NOOP("Se&ction"), "section", "C",
         QT_TR_NOOP("Cut the view open at the parting plane, or anywhere along it."), Needs::Plane, true},
        {"screenshot", QT_TR_NOOP("Save a picture…"), "camera", "",
         QT_TR_NOOP("Write the view as a PNG picture."), Needs::InView, false, true},
        {"turntable", QT_TR_NOOP("Save a t&urntable…"), "turntable", "",
         QT_TR_NOOP("Turn the view once around and write an animated PNG. Esc stops."), Needs::IdlePart},
    };
}

std::vector<ActionSpec> ActionMenus::window() {
    return {
        {"theme-light", QT_TR_NOOP("&Light"), "", "", QT_TR_NOOP("Use the light theme."), Needs::Nothing,
         true},
        {"theme-dark", QT_TR_NOOP("&Dark"), "", "", QT_TR_NOOP("Use the dark theme."), Needs::Nothing, true},
        {"theme-system", QT_TR_NOOP("Like the desk&top"), "", "", QT_TR_NOOP("Follow the desktop's colours."),
         Needs::Nothing, true},
        {"step-part", QT_TR_NOOP("Go to Part"), "", "Ctrl+1", QT_TR_NOOP("Go to the step Part."), Needs::Part,
         false, true},
        {"step-plane", QT_TR_NOOP("Go to Plane"), "", "Ctrl+2", QT_TR_NOOP("Go to the step Plane."),
         Needs::Part},
        {"step-guides", QT_TR_NOOP("Go to Guides"), "", "Ctrl+3", QT_TR_NOOP("Go to the step Guides."),
         Needs::Part},
        {"step-deform", QT_TR_NOOP("Go to Deform"), "", "Ctrl+4", QT_TR_NOOP("Go to the step Deform."),
         Needs::Part},
        {"step-check", QT_TR_NOOP("Go to Check"), "", "Ctrl+5", QT_TR_NOOP("Go to the step Check."),
         Needs::Part},
        {"step-mold", QT_TR_NOOP("Go to Mold"), "", "Ctrl+6", QT_TR_NOOP("Go to the step Mold."),
         Needs::Part},
        {"step-report", QT_TR_NOOP("Go to Report"), "", "Ctrl+7", QT_TR_NOOP("Go to the step Report."),
         Needs::Part},
        {"next-zone", QT_TR_NOOP("Next area"), "", "F6",
         QT_TR_NOOP("Move the keyboard to the next area of the window."), Needs::Nothing, false, true},
        {"previous-zone", QT_TR_NOOP("Previous area"), "", "Shift+F6",
         QT_TR_NOOP("Move the keyboard to the previous area of the window."), Needs::Nothing},
        {"reset-layout", QT_TR_NOOP("&Reset the layout"), "", "",
         QT_TR_NOOP("Put all panels back where they were at first."), Needs::Nothing},
    };
}

std::vector<ActionSpec> ActionMenus::help() {
    return {
        {"keys", QT_TR_NOOP("&Keys and mouse"), "keys", "?", QT_TR_NOOP("Show all keys on one sheet.")},
        {"tour", QT_TR_NOOP("Take the &tour"), "tour", "",
         QT_TR_NOOP("Five steps from a part to its mold, at your own pace.")},
        {"about", QT_TR_NOOP("&About Moldwright"), "info", "", QT_TR_NOOP("Version, licence, libraries.")},
    };
}

} // namespace moldwright
