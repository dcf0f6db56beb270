// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/insert_options.h"

#include "cli/option_values.h"

#include <map>

namespace moldwright::cli {

void InsertOptions::declare(CLI::App& app) {
    app.add_option("--pockets", pockets, "Pockets in the parting face for inserts")
        ->type_name("N")
        ->check(fromTo(0, 12));
    app.add_option("--pocket-shape", pocketShape, "Of the insert: a magnet or dowel, a nut, a block")
        ->check(CLI::IsMember({"round", "hexagon", "rectangle"}));
    length(app, "--pocket-width", pocketWidth, "Diameter, across flats, or the insert's side along y");
    length(app, "--pocket-length", pocketLength, "The insert's side along x, of a rectangle");
    length(app, "--pocket-depth", pocketDepth, "Into the half");
    app.add_option("--pocket-clearance", pocketClearance, "Round the insert at its floor")
        ->type_name("MM")
        ->check(atLeast0());
    app.add_option("--pocket-half", pocketHalf, "The half that they are in; both for dowels")
        ->check(CLI::IsMember({"1", "2", "both"}));
    app.add_option(
           "--plaque", plaque,
           "Letters engraved in the back of each half; | between lines; {part}, {number}, {revision}, "
           "{half} and {shrink} are replaced; auto: all there is of them; none")
        ->type_name("TEXT|auto|none");
    app.add_option("--plaque-height", plaqueHeight, "Of its capitals, 2.8 or more; 0: as there is room")
        ->type_name("MM")
        ->check(atLeast0());
    length(app, "--plaque-depth", plaqueDepth, "Of its grooves");
}

void InsertOptions::apply(MoldSettings& settings) const {
    static const std::map<std::string, PocketShape> shapes = {{"round", PocketShape::Round},
                                                              {"hexagon", PocketShape::Hexagon},
                                                              {"rectangle", PocketShape::Rectangle}};
    static const std::map<std::string, int> halves = {{"both", 0}, {"1", 1}, {"2", 2}};
    take(settings.pockets.count, pockets);
    if (!pocketShape.empty())
        settings.pockets.shape = shapes.at(pocketShape);
    take(settings.pockets.width, pocketWidth);
    take(settings.pockets.length, pocketLength);
    take(settings.pockets.depth, pocketDepth);
    take(settings.pockets.clearance, pocketClearance);
    if (!pocketHalf.empty())
        settings.pockets.side = halves.at(pocketHalf);
    if (!plaque.empty())
        settings.plaque.text = plaque == "none" ? "" : plaque;
    take(settings.plaque.height, plaqueHeight);
    take(settings.plaque.depth, plaqueDepth);
}

} // namespace moldwright::cli
