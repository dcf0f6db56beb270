// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/mold_options.h"

#include "cli/option_values.h"
#include "exchange/user_folder.h"
#include "materials/material_table.h"
#include "mold/material_choice.h"
#include "project/cavity_places.h"
#include "project/guide_files.h"
#include "project/presets.h"

#include <CLI/CLI.hpp>

#include <charconv>
#include <map>

namespace moldwright::cli {

namespace {

CLI::Option* angle(CLI::App& app, const std::string& name, std::optional<double>& value,
                   const std::string& help) {
    return app.add_option(name, value, help)->type_name("DEG")->check(fromTo(0.0, 45.0));
}

constexpr std::size_t mostCavities = 400;

std::unexpected<Error> tooMany() {
    return failure(ErrorCode::Usage,
                   MW_TEXT("cli", "--cavities takes rows x columns, as 2x3, with at most {0} cavities."),
                   {std::to_string(mostCavities)});
}

} // namespace

void MoldOptions::declare(CLI::App& app) {
    declareBlock(app);
    declareLayout(app);
    declareChannels(app);
    declareRegistration(app);
    declareHoles(app);
    declarePouring(app);
    inserts.declare(app);
}

void MoldOptions::declareBlock(CLI::App& app) {
    app.add_option("--preset", preset, "What was saved under this name; options given go first")
        ->type_name("NAME");
    app.add_option("--material", materialName,
                   "Takes shrink, formula, density and depth of vents from the table of materials; options "
                   "given go first. none: of no material of the table")
        ->type_name("NAME");
    length(app, "--wall", wall, "Steel round the cavities on all sides; the default is the project's");
    length(app, "--side-wall", side, "Steel at the sides alone");
    length(app, "--floor", floor, "Steel under the cavities of half 2");
    length(app, "--ceiling", ceiling, "Steel over the cavities of half 1");
    app.add_option("--size-step", step, "Block sizes round up to a multiple of this, mm; 0: not rounded")
        ->type_name("MM")
        ->check(atLeast0());
    app.add_option("--block", block, "A box, or a shell: its corners cut away where nothing stands in them")
        ->check(CLI::IsMember({"box", "shell"}));
    app.add_option("--outer-draft", outerDraft,
                   "The outer faces widen to the back by this, so that a half that is cast leaves its form; "
                   "below 0 they narrow")
        ->type_name("DEG")
        ->check(fromTo(-15.0, 15.0));
    app.add_option("--stock", stock, "Lengths and widths of blocks that are to be had; comma between")
        ->type_name("MM,...")
        ->delimiter(',')
        ->check(above0());
    app.add_option("--bed", bed, "What the printer can make: halves that are larger are told")
        ->type_name("X,Y,Z")
        ->delimiter(',')
        ->expected(3)
        ->check(above0());
    app.add_option("--press", press, "What the press closes with: a mold that needs more is told")
        ->type_name("KN")
        ->check(above0());
    length(app, "--hollow", hollow, "Cast hollow with a wall of this: its volume and mass are told");
    length(app, "--least-steel", leastSteel, "Kept between features that are placed automatically");
    app.add_option("--pressure", pressure, "In the cavity while it fills, for the clamp force")
        ->type_name("BAR")
        ->check(above0());
    app.add_option("--density", density, "Of what is cast, for its mass")
        ->type_name("G/CM3")
        ->check(above0());
    app.add_option("--block-density", blockDensity, "Of the block, for its mass")
        ->type_name("G/CM3")
        ->check(above0());
}

void MoldOptions::declareLayout(CLI::App& app) {
    app.add_option("--cavities", cavities, "Rows x columns of cavities, or their number")->type_name("RxC");
    app.add_option("--layout", arrangement, "How they stand")
        ->check(CLI::IsMember({"grid", "staggered", "packed", "circle", "free"}));
    app.add_option(
           "--cavity-places", cavityPlaces,
           "Where cavities stand and how far each is turned, mm and degrees: \"0,0; 40,5,90\"; a free "
           "layout")
        ->type_name("X,Y[,DEG];...");
    app.add_option("--alternate", alternate, "Every second cavity turned, turned over, or mirrored")
        ->check(CLI::IsMember({"none", "turn", "flip", "mirror"}));
    length(app, "--spacing", spacing, "Steel between cavities, and between them and channels");

    app.add_option("--shrink", shrink,
                   "Linear shrink to make up for, in percent: one number, or x y z of the part")
        ->type_name("PERCENT")
        ->expected(1, 3);
    app.add_option("--shrink-formula", shrinkFormula, "plus: 1+S, divide: 1/(1-S)")
        ->check(CLI::IsMember({"plus", "divide"}));
    app.add_option("--shrink-origin", shrinkOrigin, "The point of the part that stays, mm")
        ->type_name("X Y Z")
        ->expected(3);
}

void MoldOptions::declareChannels(CLI::App& app) {
    app.add_option(
           "--spout", spout,
           "In the parting plane, with runners to all cavities (auto, parting), or one through half 1 into "
           "each cavity of a mold that lies flat (through)")
        ->check(CLI::IsMember({"auto", "parting", "through", "none"}));
    length(app, "--neck", neck, "Width at which a spout through a half breaks off");
    app.add_option("--pour", pour, "Which way is up while filling, as a turn of the cast in degrees")
        ->check(CLI::IsMember({"auto", "0", "90", "180", "270"}));
    app.add_option("--runners", runners,
                   "From the spout to cavities in rows and columns: the shortest, or all ways equally long")
        ->check(CLI::IsMember({"shortest", "balanced"}));
    length(app, "--spout-diameter", spoutDiameter, "Width of spout and main runner");
    length(app, "--funnel", funnel, "Width of the spout at the block's face");
    length(app, "--gate", gate, "Width where it meets the cavity");
    angle(app, "--spout-draft", spoutDraft, "Draft of the channels' walls");
    app.add_option("--vents", vents, "Vents where air would stay")->check(CLI::IsMember({"auto", "none"}));
    length(app, "--vent-diameter", ventDiameter, "At the narrowest");
    length(app, "--vent-depth", ventDepth,
           "Of vents in the parting plane, both halves together; by itself as deep as their width asks");
    app.add_option("--smallest-trap", smallestTrap, "Air that may stay")->type_name("MM3")->check(atLeast0());
}

void MoldOptions::declareRegistration(CLI::App& app) {
    app.add_option("--keys", keys, "Registration keys")->type_name("N")->check(fromTo(0, 12));
    length(app, "--key-diameter", keyDiameter, "At the parting plane; one is larger");
    length(app, "--key-height", keyHeight, "Of the keys");
    length(app, "--key-clearance", keyClearance, "Between key and socket");
    angle(app, "--key-lean", keyLean, "Draft of the keys");
    app.add_option("--slits", slits, "Wedge slits at the sides")->type_name("N")->check(fromTo(0, 8));
    length(app, "--slit-depth", slitDepth, "Into the block");
    length(app, "--slit-width", slitWidth, "Along its face");
    length(app, "--slit-height", slitHeight, "In each half");
}

void MoldOptions::declareHoles(CLI::App& app) {
    app.add_option("--bolts", bolts, "Straight holes through both halves")
        ->type_name("N")
        ->check(fromTo(0, 12));
    length(app, "--bolt-diameter", boltDiameter, "Of the holes");
    // Shop practice: 1 mm of steel at least.
    app.add_option("--bolt-wall", boltWall, "Steel between bolt holes and the block's faces, 1 or more")
        ->type_name("MM")
        ->check(fromTo(1.0, 1000.0));
    app.add_option("--bolt-clear", boltClear, "Steel between bolt holes and everything else, 1 or more")
        ->type_name("MM")
        ->check(fromTo(1.0, 1000.0));
    app.add_option("--ejectors", ejectors, "Holes for ejector pins, for each cavity")
        ->type_name("N")
        ->check(fromTo(0, 12));
    length(app, "--ejector-diameter", ejectorDiameter, "Of the pins");
    app.add_option("--places", places,
                   "JSON file of features that are placed by hand, as mold.json lists them; auto: none")
        ->type_name("FILE|auto");
    app.add_option("--ejector-half", ejectorSide, "The half that the pins pass through")->check(fromTo(1, 2));
}

Result<MoldSettings> MoldOptions::afterPreset(MoldSettings settings) const {
    if (preset.empty())
        return settings;
    const std::optional<std::filesystem::path> folder = userFolder("presets");
    return withPreset(settings, folder.value_or(""), preset);
}

Result<std::optional<Material>> MoldOptions::material() const {
    if (materialName.empty() || materialName == "none")
        return std::nullopt;
    const Result<std::vector<Material>> table = materialTable(MaterialPlaces::usual());
    if (!table)
        return std::unexpected(table.error());
    Result<Material> named = materialNamed(*table, materialName);
    if (!named)
        return std::unexpected(named.error());
    return *std::move(named);
}

Result<MoldSettings> MoldOptions::afterMaterial(MoldSettings settings) const {
    const Result<std::optional<Material>> chosen = material();
    if (!chosen)
        return std::unexpected(chosen.error());
    if (*chosen)
        return withMaterial(std::move(settings), **chosen);
    return materialName.empty() ? std::move(settings) : withoutMaterial(std::move(settings));
}

Result<MoldSettings> MoldOptions::applied(MoldSettings given) const {
    Result<MoldSettings> taken = afterPreset(std::move(given));
    if (taken)
        taken = afterMaterial(*std::move(taken));
    if (!taken)
        return taken;
    MoldSettings settings = *std::move(taken);
    applyBlock(settings);
    if (Result<void> done = applyLayout(settings.layout); !done)
        return std::unexpected(done.error());
    if (Result<void> done = applyShrink(settings.shrink); !done)
        return std::unexpected(done.error());
    if (Result<void> done = applyChannels(settings); !done)
        return std::unexpected(done.error());
    applyRegistration(settings);
    applyHoles(settings);
    inserts.apply(settings);
    if (Result<void> done = applyPlaces(settings.placed); !done)
        return std::unexpected(done.error());
    return settings;
}

void MoldOptions::applyBlock(MoldSettings& settings) const {
    if (wall)
        settings.wall = settings.floor = settings.ceiling = *wall;
    take(settings.wall, side);
    take(settings.floor, floor);
    take(settings.ceiling, ceiling);
    take(settings.step, step);
    if (!block.empty())
        settings.shape = block == "shell" ? BlockShape::Shell : BlockShape::Box;
    take(settings.outerDraft, outerDraft);
    take(settings.pressure, pressure);
    take(settings.leastSteel, leastSteel);
    take(settings.hollow.wall, hollow);
    if (!stock.empty())
        settings.stock = stock;
    if (!bed.empty())
        settings.machines.bed = {bed[0], bed[1], bed[2]};
    take(settings.machines.clamp, press);
    take(settings.density, density);
    take(settings.blockDensity, blockDensity);
}

Result<void> MoldOptions::applyLayout(LayoutSettings& layout) const {
    static const std::map<std::string, Arrangement> arrangements = {{"grid", Arrangement::Grid},
                                                                    {"staggered", Arrangement::Staggered},
                                                                    {"packed", Arrangement::Packed},
                                                                    {"circle", Arrangement::Circle},
                                                                    {"free", Arrangement::Free}};
    static const std::map<std::string, Alternation> alternations = {{"none", Alternation::None},
                                                                    {"turn", Alternation::Turn},
                                                                    {"flip", Alternation::Flip},
                                                                    {"mirror", Alternation::Mirror}};
    if (!arrangement.empty())
        layout.arrangement = arrangements.at(arrangement);
    if (!alternate.empty())
        layout.alternation = alternations.at(alternate);
    take(layout.spacing, spacing);
    if (Result<void> done = applyCavityPlaces(layout); !done)
        return done;
    return cavities.empty() ? Result<void>() : applyCavities(layout);
}

Result<void> MoldOptions::applyCavityPlaces(LayoutSettings& layout) const {
    if (!cavityPlaces.empty()) {
        Result<std::vector<CavityPlace>> read = cavityPlacesOf(cavityPlaces);
        if (!read)
            return failure(ErrorCode::Usage, read.error().message.text, read.error().message.arguments);
        layout.places = *std::move(read);
        if (arrangement.empty())
            layout.arrangement = Arrangement::Free;
    }
    if (layout.places.size() > mostCavities)
        return tooMany();
    if (layout.arrangement == Arrangement::Free && !cavities.empty())
        return failure(ErrorCode::Usage,
                       MW_TEXT("cli", "In a free layout there are as many cavities as --cavity-places has; "
                                      "--cavities does not go with it."));
    return {};
}

Result<void> MoldOptions::applyCavities(LayoutSettings& layout) const {
    int rows = 1;
    int columns = 0;
    const char* end = cavities.data() + cavities.size();
    auto read = std::from_chars(cavities.data(), end, columns);
    if (read.ec == std::errc() && read.ptr != end && (*read.ptr == 'x' || *read.ptr == 'X')) {
        rows = columns;
        read = std::from_chars(read.ptr + 1, end, columns);
    }
    if (read.ec != std::errc() || read.ptr != end || rows < 1 || columns < 1 ||
        rows > static_cast<int>(mostCavities) / columns)
        return tooMany();
    layout.rows = rows;
    layout.columns = columns;
    return {};
}

Result<void> MoldOptions::applyShrink(ShrinkSettings& settings) const {
    if (shrink.size() == 2)
        return failure(ErrorCode::Usage,
                       MW_TEXT("cli", "--shrink takes one number, or three: along x, y and z."));
    if (shrink.size() == 1)
        settings.percent.setConstant(shrink[0]);
    if (shrink.size() == 3)
        settings.percent = Eigen::Vector3d(shrink[0], shrink[1], shrink[2]);
    if (!shrinkFormula.empty())
        settings.formula = shrinkFormula == "plus" ? ShrinkFormula::Plus : ShrinkFormula::Divide;
    if (!shrinkOrigin.empty())
        settings.origin = Eigen::Vector3d(shrinkOrigin[0], shrinkOrigin[1], shrinkOrigin[2]);
    return {};
}

Result<void> MoldOptions::applyChannels(MoldSettings& settings) const {
    static const std::map<std::string, PourDirection> pours = {{"auto", PourDirection::Automatic},
                                                               {"0", PourDirection::Turn0},
                                                               {"90", PourDirection::Turn90},
                                                               {"180", PourDirection::Turn180},
                                                               {"270", PourDirection::Turn270}};
    if (!spout.empty())
        settings.spout.on = spout != "none";
    if (spout == "parting" || spout == "through")
        settings.spout.resting = spout == "through" ? Resting::Lying : Resting::Standing;
    if (!pour.empty())
        settings.spout.pour = pours.at(pour);
    if (!runners.empty())
        settings.spout.runners = runners == "balanced" ? Runners::Balanced : Runners::Shortest;
    if (spoutDiameter) {
        // Gate and funnel keep their proportion unless they are given.
        settings.spout.gate *= *spoutDiameter / settings.spout.diameter;
        settings.spout.funnel *= *spoutDiameter / settings.spout.diameter;
        settings.spout.diameter = *spoutDiameter;
    }
    take(settings.spout.funnel, funnel);
    take(settings.spout.gate, gate);
    take(settings.spout.draft, spoutDraft);
    take(settings.spout.neck, neck);
    if (!vents.empty())
        settings.vents.on = vents == "auto";
    take(settings.vents.diameter, ventDiameter);
    take(settings.vents.depth, ventDepth);
    take(settings.vents.smallestTrap, smallestTrap);
    return applyPouring(settings);
}

Result<void> MoldOptions::applyPlaces(PlacedFeatures& placed) const {
    if (places.empty())
        return {};
    Result<PlacedFeatures> read = places == "auto" ? PlacedFeatures() : readPlaces(places);
    if (!read)
        return std::unexpected(read.error());
    placed = *std::move(read);
    return {};
}

void MoldOptions::applyRegistration(MoldSettings& settings) const {
    take(settings.keys.count, keys);
    take(settings.keys.diameter, keyDiameter);
    take(settings.keys.height, keyHeight);
    take(settings.keys.clearance, keyClearance);
    take(settings.keys.draft, keyLean);
    take(settings.slits.count, slits);
    take(settings.slits.depth, slitDepth);
    take(settings.slits.width, slitWidth);
    take(settings.slits.height, slitHeight);
}

void MoldOptions::applyHoles(MoldSettings& settings) const {
    take(settings.bolts.count, bolts);
    take(settings.bolts.diameter, boltDiameter);
    take(settings.bolts.wall, boltWall);
    take(settings.bolts.clear, boltClear);
    take(settings.ejectors.count, ejectors);
    take(settings.ejectors.diameter, ejectorDiameter);
    take(settings.ejectors.side, ejectorSide);
}

} // namespace moldwright::cli
