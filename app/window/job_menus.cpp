// SPDX-License-Identifier: AGPL-3.0-or-later
// The commands of the job, step by step.
#include "window/action_menus.h"

namespace moldwright {

std::vector<ActionSpec> ActionMenus::part() {
    return {
        {"lay-flat", QT_TR_NOOP("&Lay flat on a face"), "lay-flat", "",
         QT_TR_NOOP("Click the face that shall lie on the ground. Esc leaves."), Needs::IdlePart, true},
        {"turn-x", QT_TR_NOOP("Turn about &X"), "turn", "",
         QT_TR_NOOP("Turn the part by 90° about the x axis."), Needs::IdlePart, false, true},
        {"turn-y", QT_TR_NOOP("Turn about &Y"), "turn", "",
         QT_TR_NOOP("Turn the part by 90° about the y axis."), Needs::IdlePart},
        {"turn-z", QT_TR_NOOP("Turn about &Z"), "turn", "",
         QT_TR_NOOP("Turn the part by 90° about the z axis."), Needs::IdlePart},
        {"turn-by", QT_TR_NOOP("Tu&rn by an angle…"), "turn", "R",
         QT_TR_NOOP("Turn the part about an axis, by any angle."), Needs::IdlePart},
        {"centre", QT_TR_NOOP("Move to the &middle"), "move", "",
         QT_TR_NOOP("Put the middle of the part above the origin, on the ground."), Needs::IdlePart},
        {"new-variant", QT_TR_NOOP("&New variant"), "variants", "Ctrl+Shift+N",
         QT_TR_NOOP("Begin another design of this part, without pins and regions."), Needs::IdlePart, false,
         true},
        {"duplicate-variant", QT_TR_NOOP("&Duplicate the variant"), "variants", "Ctrl+D",
         QT_TR_NOOP("Work on a copy of this design; the other stays as it is."), Needs::IdlePart},
        {"choose-variant", QT_TR_NOOP("Make &current"), "select", "",
         QT_TR_NOOP("Go on with the variant that is chosen."), Needs::OtherVariant},
        {"next-variant", QT_TR_NOOP("Next &variant"), "", "Ctrl+PgDown",
         QT_TR_NOOP("Go on with the next variant of this part."), Needs::Variants},
        {"previous-variant", QT_TR_NOOP("Previous v&ariant"), "", "Ctrl+PgUp",
         QT_TR_NOOP("Go on with the variant before this one."), Needs::Variants},
        {"compare-variants", QT_TR_NOOP("C&ompare"), "compare", "Ctrl+Shift+D",
         QT_TR_NOOP("Show another variant beside the current one, and how far their casts are apart."),
         Needs::Comparable, true},
    };
}

std::vector<ActionSpec> ActionMenus::plane() {
    return {
        {"best-plane", QT_TR_NOOP("&Best plane"), "candidates", "Ctrl+B",
         QT_TR_NOOP("Search all planes for the one that leaves the least to deform."), Needs::IdlePart},
        {"next-plane", QT_TR_NOOP("&Next best plane"), "candidates", "Ctrl+Shift+B",
         QT_TR_NOOP("Take the next plane of the last search."), Needs::IdlePlane},
        {"suggested-plane", QT_TR_NOOP("Take the &suggested plane"), "candidates", "",
         QT_TR_NOOP("Part the part where nothing stands in the way of the mold."), Needs::SuggestedPlane},
        {"best-directions", QT_TR_NOOP("Best &directions"), "direction", "",
         QT_TR_NOOP("Tilt both directions to where the least is left to deform."), Needs::IdlePlane, false,
         true},
        {"normal-directions", QT_TR_NOOP("Directions along the &normal"), "direction", "",
         QT_TR_NOOP("Let both halves leave straight along the plane's normal."), Needs::EditablePlane},
        {"plane-x", QT_TR_NOOP("Square to &X"), "plane", "Shift+X",
         QT_TR_NOOP("Turn the plane square to the x axis; it stays where it is in the part."),
         Needs::EditablePlane, false, true},
        {"plane-y", QT_TR_NOOP("Square to &Y"), "plane", "Shift+Y",
         QT_TR_NOOP("Turn the plane square to the y axis; it stays where it is in the part."),
         Needs::EditablePlane},
        {"plane-z", QT_TR_NOOP("Square to &Z"), "plane", "Shift+Z",
         QT_TR_NOOP("Turn the plane square to the z axis; it stays where it is in the part."),
         Needs::EditablePlane},
        {"plane-by-points", QT_TR_NOOP("Through three &points"), "plane", "T",
         QT_TR_NOOP("Click three places that the plane shall run through. Esc leaves."), Needs::EditablePlane,
         true},
        {"plane-on-face", QT_TR_NOOP("On a &face"), "plane", "Shift+T",
         QT_TR_NOOP("Click the face that the plane shall lie in. Esc leaves."), Needs::EditablePlane, true},
    };
}

std::vector<ActionSpec> ActionMenus::guides() {
    return {
        {"pin", QT_TR_NOOP("&Pin a point"), "pin", "P",
         QT_TR_NOOP("Click points of the part that shall lie on the parting plane. Esc leaves."),
         Needs::EditablePart, true},
        {"pin-inside", QT_TR_NOOP("Pin a point &inside"), "pin-inside", "Shift+P",
         QT_TR_NOOP("Click to pin the point farthest inside below the pointer. Esc leaves."),
         Needs::EditablePart, true},
        {"suggest-pins", QT_TR_NOOP("&Suggest pins"), "candidates", "Ctrl+G",
         QT_TR_NOOP("Look for points worth pinning: ends of limbs, where limbs meet, along the body."),
         Needs::IdlePart, false, true},
        {"accept-tips", QT_TR_NOOP("Accept &tips"), "pin", "Ctrl+Shift+G",
         QT_TR_NOOP("Pin all suggested points that are ends of limbs."), Needs::SuggestedTips},
        {"accept-lasso", QT_TR_NOOP("Accept in a lass&o"), "lasso", "Ctrl+Alt+G",
         QT_TR_NOOP("Draw around suggested points: all inside are pinned. Esc leaves."), Needs::SuggestedPins,
         true},
        {"remove-guide", QT_TR_NOOP("&Remove what is chosen"), "close", "Del",
         QT_TR_NOOP("Remove the pin, the region, the variant or the part of the mold that is chosen."),
         Needs::ChosenGuide, false, true},
        {"clear-pins", QT_TR_NOOP("Remove &all pins"), "close", "",
         QT_TR_NOOP("Remove all pins; the suggested ones stay."), Needs::Pins},
        {"import-pins", QT_TR_NOOP("Pins from a &file…"), "open", "",
         QT_TR_NOOP("Read pins from a JSON file, as the command line takes it."), Needs::IdlePart, false,
         true},
        {"export-pins", QT_TR_NOOP("Pins &into a file…"), "export", "",
         QT_TR_NOOP("Write all pins as JSON for the command line or another project."), Needs::Pins},
        {"paint", QT_TR_NOOP("P&aint importance"), "brush", "B",
         QT_TR_NOOP("Draw over what is to keep its shape: each stroke doubles its weight. Esc leaves."),
         Needs::EditablePart, true, true},
        {"paint-crease", QT_TR_NOOP("Paint up to &creases"), "grow", "Shift+B",
         QT_TR_NOOP("Click a face: the stroke goes as far as the surface is smooth. Esc leaves."),
         Needs::EditablePart, true},
        {"paint-piece", QT_TR_NOOP("Paint a whole p&iece"), "part", "",
         QT_TR_NOOP("Click a face: the stroke takes all that is connected with it. Esc leaves."),
         Needs::EditablePart, true},
        {"paint-lasso", QT_TR_NOOP("Paint in a &lasso"), "lasso", "Alt+B",
         QT_TR_NOOP("Draw around what is to be painted: faces that are seen inside. Esc leaves."),
         Needs::IdlePart, true},
        {"paint-erase", QT_TR_NOOP("&Erase"), "erase", "E",
         QT_TR_NOOP("Let strokes halve weights instead of doubling them; Ctrl does the opposite."),
         Needs::Part, true},
        {"brush-smaller", QT_TR_NOOP("S&maller brush"), "", "[",
         QT_TR_NOOP("Make the brush smaller. Alt and the wheel do so too."), Needs::Part},
        {"brush-larger", QT_TR_NOOP("Lar&ger brush"), "", "]",
         QT_TR_NOOP("Make the brush larger. Alt and the wheel do so too."), Needs::Part},
        {"new-region", QT_TR_NOOP("&New region"), "region", "Shift+N",
         QT_TR_NOOP("Let the next stroke make a region of its own."), Needs::Part},
        {"clear-importance", QT_TR_NOOP("Remove all re&gions"), "close", "",
         QT_TR_NOOP("Nothing is more important than the rest then."), Needs::Regions},
        {"import-weights", QT_TR_NOOP("Regions from a file…"), "open", "",
         QT_TR_NOOP("Read important regions from a JSON file, as the command line takes it."),
         Needs::IdlePart},
        {"export-weights", QT_TR_NOOP("Regions into a file…"), "export", "",
         QT_TR_NOOP("Write all regions as JSON for the command line or another project."), Needs::Regions},
    };
}

std::vector<ActionSpec> ActionMenus::deform() {
    return {
        {"run", QT_TR_NOOP("&Run"), "play", "Ctrl+Return",
         QT_TR_NOOP("Bend the part until it leaves the mold, and prove it."), Needs::IdlePlane},
        {"fill-and-run", QT_TR_NOOP("Fi&ll and run"), "cavity", "",
         QT_TR_NOOP("Run, and fill the places that no bending frees."), Needs::IdlePlane},
        {"find-undercuts", QT_TR_NOOP("Find &undercuts"), "cavity", "Ctrl+Shift+U",
         QT_TR_NOOP("List the undercuts at this plane, to have each one bent or filled."), Needs::IdlePlane},
        {"fill-here", QT_TR_NOOP("Fill or &join here"), "cavity", "",
         QT_TR_NOOP("Have what the chosen obstruction spans filled; Run bends the rest."),
         Needs::FillableObstruction},
        {"finish", QT_TR_NOOP("&Finish"), "finish", "Ctrl+Shift+Return",
         QT_TR_NOOP("Bend no further: finish the shape from where it is, and prove it."), Needs::Bending},
        {"pause", QT_TR_NOOP("&Pause"), "pause", "Space",
         QT_TR_NOOP("Hold the shape where it is, or bend it further."), Needs::Running},
        {"step-once", QT_TR_NOOP("One s&tep"), "play", "N", QT_TR_NOOP("Bend a paused shape by one step."),
         Needs::Resting},
        {"earlier-frame", QT_TR_NOOP("&Earlier frame"), "", "Alt+,",
         QT_TR_NOOP("Look at the frame before; a run pauses."), Needs::EarlierFrame},
        {"later-frame", QT_TR_NOOP("&Later frame"), "", "Alt+.", QT_TR_NOOP("Look at the frame after."),
         Needs::LaterFrame},
        {"branch", QT_TR_NOOP("Go on from &here"), "play", "Ctrl+Alt+Return",
         QT_TR_NOOP("Run anew from the shape, plane and settings of the frame in view."), Needs::Branch},
        {"stop", QT_TR_NOOP("&Stop"), "stop", "Ctrl+.",
         QT_TR_NOOP("End the run; the shape it reached is kept."), Needs::Running},
        {"restore", QT_TR_NOOP("Restore original shape"), "restore", "",
         QT_TR_NOOP("Back to the undeformed part; the plane stays."), Needs::CastShape, false, true},
    };
}

std::vector<ActionSpec> ActionMenus::mold() {
    return {
        {"build-mold", QT_TR_NOOP("&Build mold"), "mold", "Ctrl+M",
         QT_TR_NOOP("Make both mold halves around the cast, and prove that they come off."),
         Needs::ProvedCast},
        {"open-mold", QT_TR_NOOP("&Open or close the mold"), "explode", "X",
         QT_TR_NOOP("Move the halves apart along their directions, or together."), Needs::MoldBuilt},
        {"add-part", QT_TR_NOOP("Add a &part to the mold…"), "part", "Ctrl+Shift+M",
         QT_TR_NOOP("Give the mold cavities of other finished casts, from their project files."),
         Needs::IdlePart},
        {"read-part-again", QT_TR_NOOP("Read the part a&gain"), "restore", "",
         QT_TR_NOOP("Take the chosen part of the mold from its project file as it is now."),
         Needs::FurtherPart},
        {"save-preset", QT_TR_NOOP("&Save as a preset…"), "", "",
         QT_TR_NOOP("Keep block, layout, features and machines under a name, for other parts."),
         Needs::IdlePart},
        {"remove-preset", QT_TR_NOOP("&Remove the preset"), "", "",
         QT_TR_NOOP("Forget it; the mold keeps its settings."), Needs::IdlePart},
        {"place-automatically", QT_TR_NOOP("Place &automatically"), "restore", "",
         QT_TR_NOOP("Give the chosen feature of the mold back to the program."), Needs::ChosenByHand, false,
         true},
        {"place-all-automatically", QT_TR_NOOP("Place a&ll automatically"), "restore", "",
         QT_TR_NOOP("Give all features of the mold back that a hand has placed."), Needs::AnyByHand},
    };
}

std::vector<ActionSpec> ActionMenus::report() {
    return {
        {"print-report", QT_TR_NOOP("&Print report…"), "print", "Ctrl+P",
         QT_TR_NOOP("Make a PDF with pictures, draft, volumes and the proof."), Needs::CastShape},
    };
}

} // namespace moldwright
