// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/design_command.h"

#include "cli/auto_pins.h"
#include "cli/design_files.h"
#include "cli/frame_writer.h"
#include "cli/load_part.h"
#include "cli/mold_options.h"
#include "cli/option_values.h"
#include "cli/render_client.h"
#include "cli/size_options.h"
#include "cli/state_options.h"
#include "design/stopwatch.h"
#include "mesh/measures.h"
#include "mold/mold_files.h"
#include "project/edits.h"
#include "project/guide_files.h"
#include "project/project_file.h"
#include "project/title.h"
#include "report/figures.h"

#include <CLI/CLI.hpp>

#include <map>
#include <memory>

namespace moldwright::cli {

namespace {

constexpr double kSmallPart = 5;    ///< mm: below, default walls and drafts hardly suit
constexpr double kLargePart = 2000; ///< mm: above, the file's unit was probably another

struct DesignOptions {
    std::string input;
    std::string output;
    StateOptions state;
    std::string directions = "auto";
    std::string pins = "none";
    std::string weights;
    std::string fill = "auto";
    bool merge = false;
    std::string method = "default";
    double smoothing = 0.1; ///< γ
    SizeOptions size;
    LimitOptions limits;
    std::vector<double> fillAt; ///< three numbers a place
    std::vector<double> bendAt;
    bool mold = false;
    bool report = false;
    bool frames = false; ///< keep the shapes on the way
    MoldSettings block;  ///< the options' values, once they are read
    MoldOptions moldOptions;
    std::string number, revision; ///< of the part

    [[nodiscard]] std::string partName() const { return std::filesystem::path(input).stem().string(); }
};

std::vector<Message> warningsFor(const IndexedMesh& part, const DesignResult& result) {
    std::vector<Message> warnings;
    const double size = boundingBox(part).sizes().maxCoeff();
    if (size < kSmallPart || size > kLargePart)
        warnings.push_back(
            {MW_TEXT(
                 "cli",
                 "The part is {0} mm long: the defaults for walls and draft hardly suit it. Give --units, "
                 "--scale or --size if this is not its size."),
             {readable(size)}});
    if (result.cutShort)
        warnings.push_back({MW_TEXT("cli", "The design was stopped before its end. What it had reached was "
                                           "written; it is not finished."),
                            {}});
    return warnings;
}

/// What files of guides hold, with all names.
struct Guides {
    std::vector<NamedPin> pins;
    std::vector<ImportantRegion> importance;
};

/// Pins and importance from their files.
Result<void> takeGuides(const DesignOptions& options, DesignRequest& request, Guides& guides) {
    if (options.pins != "none" && options.pins != "auto") {
        Result<std::vector<NamedPin>> pins = readPins(options.pins, *request.part);
        if (!pins)
            return std::unexpected(pins.error());
        guides.pins = std::move(*pins);
        request.pins.assign(guides.pins.begin(), guides.pins.end());
    }
    if (!options.weights.empty()) {
        Result<std::vector<ImportantRegion>> regions = readWeights(options.weights, *request.part);
        if (!regions)
            return std::unexpected(regions.error());
        guides.importance = std::move(*regions);
        request.faceWeights = faceWeights(guides.importance, request.part->faceCount());
        request.regions = keptRegions(guides.importance);
    }
    return {};
}

std::vector<UndercutChoice> undercutChoices(const DesignOptions& options) {
    std::vector<UndercutChoice> choices;
    const auto add = [&](const std::vector<double>& numbers, UndercutChoice::Treatment treatment) {
        for (std::size_t i = 0; i + 2 < numbers.size(); i += 3)
            choices.push_back({{numbers[i], numbers[i + 1], numbers[i + 2]}, treatment});
    };
    add(options.fillAt, UndercutChoice::Treatment::Fill);
    add(options.bendAt, UndercutChoice::Treatment::Bend);
    return choices;
}

/// What is asked of a run; `guides` receives what their files hold.
Result<DesignRequest> requestFor(const DesignOptions& options, SharedMesh part, const Session& session,
                                 Guides& guides) {
    DesignRequest request;
    request.part = std::move(part);
    const Result<std::optional<PartingPlane>> plane = options.state.givenPlane();
    if (!plane)
        return std::unexpected(plane.error());
    const Result<std::optional<Directions>> directions = options.state.givenDirections(*plane);
    if (!directions)
        return std::unexpected(directions.error());
    request.plane = *plane;
    if (*directions) {
        request.directions = **directions;
        request.directionsChoice = DirectionsChoice::Given;
    } else if (options.directions == "normal") {
        request.directionsChoice = DirectionsChoice::Normal;
    }
    if (const Result<void> taken = takeGuides(options, request, guides); !taken)
        return std::unexpected(taken.error());
    request.draftDegrees = options.state.draft;
    const Result<DirectionLimits> limits = options.limits.limits();
    if (!limits)
        return std::unexpected(limits.error());
    request.limits = *limits;
    request.undercuts = undercutChoices(options);
    request.method = options.method == "paper" ? DeformationMethod::Paper : DeformationMethod::Default;
    request.smoothing = options.smoothing;
    request.fill = options.fill == "auto" ? FillChoice::Auto : FillChoice::None;
    request.mergePieces = options.merge;
    request.keepUnfinished = true;
    request.seed = session.seed();
    return request;
}

Project projectOf(const DesignOptions& options, const IndexedMesh& source, const Placement& placement,
                  const DesignRequest& request, const Guides& guides, const DesignResult& result) {
    Project project;
    project.design = {request.draftDegrees, request.limits, request.directionsChoice,
                      request.method,       request.fill,   request.seed};
    project.mold = options.block;
    project = withPart(std::move(project), options.partName(),
                       std::filesystem::path(options.input).filename().string(),
                       std::make_shared<const IndexedMesh>(source), placement);
    project = withTitle(std::move(project), {options.partName(), options.number, options.revision});
    project.pins = named(request.pins, guides.pins);
    project.importance = guides.importance;
    project = withState(std::move(project), result.state, request.plane.has_value());
    project.undercuts = request.undercuts;
    return result.castable ? withCast(std::move(project), result, request.draftDegrees) : project;
}

Result<void> writeMoldOf(const DesignOptions& options, const DesignRequest& request, DesignResult& result,
                         const Task& task) {
    const Stopwatch watch(result.seconds, "mold");
    MoldSettings settings = options.block;
    settings.plaque.text =
        plaqueText(settings.plaque.text, {options.partName(), options.number, options.revision});
    const Result<Mold> mold =
        buildMold(trayOf({result.cast, result.labels, result.state}, options.partName()),
                  request.draftDegrees, settings, task);
    if (!mold)
        return std::unexpected(mold.error());
    if (!mold->verified())
        return failure(ErrorCode::Internal, MW_TEXT("cli", "The mold could not be proved: {0}"),
                       {mold->problems.empty() ? mold->castCertificate.reason : mold->problems.front()});
    return writeMold(*mold, options.partName(), options.output, {}, task);
}

Result<void> writeReportOf(const std::filesystem::path& folder, const Session& session) {
    const Result<RenderedReport> report =
        renderReport({folder / "project.moldwright", folder / "report.pdf"}, session.task());
    if (!report)
        return std::unexpected(report.error());
    if (!report->missingPictures.empty())
        session.tell({MW_TEXT("cli", "The report has no pictures. {0}"), {report->missingPictures}});
    return {};
}

void tell(const DesignResult& result, const Session& session) {
    for (const Obstruction& obstruction : result.obstructions) {
        session.tell(obstruction.message);
        for (const Remedy& remedy : obstruction.remedies)
            session.tell(remedy.message);
    }
    for (const Message& warning : result.warnings)
        session.tell(warning);
    if (!result.cast)
        return;
    if (result.castable)
        session.out() << "Castable: every face proved at "
                      << figureRoundedDown(result.certificate.worstDraftDegrees, 2) << "° or more.\n";
    else
        session.out() << "Not castable: " << result.certificate.reason << '\n';
    for (const RegionMeasure& region : result.regions)
        if (!region.kept)
            session.tell(
                {MW_TEXT("cli", "The region {0} changed its shape by {1} mm, more than allowed. Give "
                                "it more weight, or another plane."),
                 {region.name, readable(region.maxDistance, 3)}});
    if (const double filled = result.change.filledVolumeFraction; filled > 0)
        session.out() << "Filled in: " << readable(100 * filled, 2) << " % of the part's volume.\n";
    session.out() << "Mean change " << readable(100 * result.change.meanDistance, 2)
                  << " % of the diagonal, volume " << readable(100 * result.change.volumeRatio, 3) << " %.\n";
}

/// Writes all that was made: cast, mold, project, report, JSON.
Result<void> writeAll(const DesignOptions& options, const DesignRequest& request, const DesignResult& result,
                      const StoredProject& project, const Session& session) {
    const std::filesystem::path folder(options.output);
    const std::string name = std::filesystem::path(options.input).filename().string();
    if (auto done = writeDesign(folder, name, request, result); !done)
        return done;
    if (auto done = saveProject(folder / "project.moldwright", project); !done)
        return done;
    if (options.report && !result.cutShort)
        if (auto done = writeReportOf(folder, session); !done)
            return done;
    return session.writeJson(designJson(name, request, result));
}

ExitCode answerOf(const DesignResult& result) {
    if (result.cutShort)
        return ExitCode::Stopped;
    if (result.castable)
        return ExitCode::Yes;
    return result.obstructions.empty() ? ExitCode::No : ExitCode::Impossible;
}

/// Runs the design; where pins are the program's to choose, `request` then has them.
Result<DesignResult> designed(const DesignOptions& options, DesignRequest& request, FrameWriter& frames,
                              const Session& session) {
    const Task task = session.task().part(0.05, options.mold ? 0.85 : 1);
    const FrameSink sink = options.frames ? frames.sink() : FrameSink{};
    if (options.pins != "auto")
        return design(request, task, sink);
    Result<AutoPinned> pinned = designWithTips(request, task, sink);
    if (!pinned)
        return std::unexpected(pinned.error());
    request = std::move(pinned->request);
    return std::move(pinned->result);
}

Result<ExitCode> runDesign(const DesignOptions& options, const Session& session) {
    std::map<std::string, double> seconds;
    auto whole = std::make_unique<Stopwatch>(seconds, "total");
    Result<IndexedMesh> source = [&] {
        const Stopwatch watch(seconds, "load");
        return loadPart(options.input, session);
    }();
    if (!source)
        return std::unexpected(source.error());
    const Placement placement = options.size.placementFor(*source);
    const auto part = std::make_shared<const IndexedMesh>(placed(*source, placement));
    Guides guides;
    Result<DesignRequest> request = requestFor(options, part, session, guides);
    if (!request)
        return std::unexpected(request.error());
    FrameWriter frames(std::filesystem::path(options.output) / "frames");
    Result<DesignResult> result = designed(options, *request, frames, session);
    if (!result)
        return std::unexpected(result.error());
    if (const Result<void> done = frames.finish(); !done)
        return std::unexpected(done.error());
    result->warnings = warningsFor(*part, *result);
    // Whatever becomes of the mold, a cast that is made is written.
    Result<void> mold;
    if (options.mold && result->castable && !result->cutShort)
        mold = writeMoldOf(options, *request, *result, session.task().part(0.85, 1));
    whole.reset();
    result->seconds.insert(seconds.begin(), seconds.end());
    const StoredProject project{projectOf(options, *source, placement, *request, guides, *result), "", ""};
    if (const Result<void> done = writeAll(options, *request, *result, project, session); !done)
        return std::unexpected(done.error());
    tell(*result, session);
    return mold ? Result<ExitCode>(answerOf(*result)) : std::unexpected(mold.error());
}

void declareOptions(CLI::App& app, DesignOptions& o) {
    app.add_option("IN", o.input, "Mesh file")->required();
    app.add_option("--out", o.output, "Folder for the results")->required();
    o.state.declare(app, false);
    app.add_option("--directions", o.directions, "auto or normal; --d1 and --d2 fix them")
        ->check(CLI::IsMember({"auto", "normal"}))
        ->capture_default_str();
    o.limits.declare(app);
    app.add_option("--method", o.method, "default, or paper: the published method as described")
        ->check(CLI::IsMember({"default", "paper"}))
        ->capture_default_str();
    app.add_option("--smoothing", o.smoothing, "How much neighbours turn alike in --method paper: 0 to 1")
        ->check(fromTo(0.0, 1.0))
        ->capture_default_str();
    app.add_option("--pins", o.pins,
                   "none; auto: suggested ends of limbs, where that helps; or a JSON file of points to draw "
                   "into the plane")
        ->capture_default_str();
    app.add_option("--weights", o.weights, "JSON file of regions that are to keep their shape");
    app.add_option("--fill", o.fill, "auto: what no bending frees is filled; none: it is named")
        ->check(CLI::IsMember({"auto", "none"}))
        ->capture_default_str();
    const auto placeOption = [&](const char* name, std::vector<double>& places, const char* help) {
        app.add_option(name, places, help)->type_size(3)->type_name("X Y Z")->expected(1, -1);
    };
    placeOption("--fill-at", o.fillAt, "Fill the undercut here, whatever --fill says; may be repeated");
    placeOption("--bend-at", o.bendAt, "Leave the undercut here to bending, whatever --fill says");
    app.add_flag("--merge", o.merge, "Filling may join pieces of the part that are apart");
    o.size.declare(app);
    app.add_option("--part-number", o.number, "Of the part, for report and plaque")->type_name("TEXT");
    app.add_option("--revision", o.revision, "Of the part, for report and plaque")->type_name("TEXT");
    app.add_flag("--mold", o.mold, "Also build, prove and write the mold halves");
    app.add_flag("--report", o.report, "Also write the printable report, report.pdf");
    app.add_flag("--frames", o.frames, "Also write the shape after every step, into the folder frames");
    o.moldOptions.declare(app);
}

} // namespace

Command designCommand() {
    return {"design", "Bends a mesh until it is castable, proves it, and writes cast and mold",
            "Writes cast.ply, cast.stl, project.moldwright, design.json and timings.json into the folder; "
            "with --mold also\n"
            "the mold halves, with the options of the command mold. Exit code 0: castable and proved. 1: not "
            "castable, no obstruction found. 4: an "
            "obstruction\n"
            "stands in the way, named with its place.\n\n"
            "Example: moldwright-cli design rabbit.ply --out rabbit --size 80 --draft 1 --mold",
            [](CLI::App& app) -> Action {
                const auto options = std::make_shared<DesignOptions>();
                declareOptions(app, *options);
                const auto draftGiven = [&app] { return app.count("--draft") > 0; };
                return [options, draftGiven](const Session& session) -> Result<ExitCode> {
                    DesignOptions run = *options;
                    const Result<MoldSettings> block = run.moldOptions.applied({});
                    if (!block)
                        return std::unexpected(block.error());
                    run.block = *block;
                    if (block->material && !draftGiven())
                        run.state.draft = block->material->draftDegrees.value;
                    return runDesign(run, session);
                };
            }};
}

} // namespace moldwright::cli
