// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/analyze_command.h"

#include "castability/analysis.h"
#include "cli/load_part.h"
#include "cli/state_options.h"
#include "design/filling.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace moldwright::cli {

namespace {

struct AnalyzeOptions {
    std::string input;
    StateOptions state;
    LimitOptions limits;
    bool regions = false;
};

Json jsonOf(const DraftAnalysis& analysis, const MoldState& state) {
    Json json = {{"plane", cli::jsonOf(state.plane)},
                 {"d1", cli::jsonOf(state.directions.d1)},
                 {"d2", cli::jsonOf(state.directions.d2)},
                 {"energy", analysis.energy},
                 {"castable", analysis.castable()},
                 {"violating_area_fraction", analysis.violatingAreaFraction},
                 {"worst_draft_deg", analysis.worstDraftDegrees},
                 {"undercuts", Json::array()},
                 {"draft_histogram", Json::array()}};
    for (const Undercut& undercut : analysis.undercuts)
        json["undercuts"].push_back({{"side", undercut.side},
                                     {"area", undercut.area},
                                     {"depth", undercut.depth},
                                     {"place", cli::jsonOf(undercut.place)},
                                     {"faces", undercut.faces}});
    for (std::size_t i = 0; i < analysis.histogram.areaFraction.size(); ++i)
        json["draft_histogram"].push_back({{"from_deg", DraftHistogram::edges[i]},
                                           {"to_deg", DraftHistogram::edges[i + 1]},
                                           {"area_fraction", analysis.histogram.areaFraction[i]}});
    return json;
}

/// What could be filled there, region by region: told, and added to the JSON.
Result<void> addRegions(Json& json, const IndexedMesh& part, const MoldState& state, const Session& session) {
    const Result<std::vector<FillableUndercut>> regions = fillableUndercuts(part, state, session.task());
    if (!regions)
        return std::unexpected(regions.error());
    json["regions"] = Json::array();
    for (const FillableUndercut& region : *regions) {
        json["regions"].push_back({{"side", region.side},
                                   {"place", cli::jsonOf(region.place)},
                                   {"size", region.size},
                                   {"volume", region.volume},
                                   {"needed", region.needed},
                                   {"joins", region.joins},
                                   {"faces", region.faces.size()}});
        const Eigen::Vector3d& p = region.place;
        session.out() << "Region at " << readable(p.x()) << ' ' << readable(p.y()) << ' ' << readable(p.z())
                      << ": " << readable(region.volume / 1000, 3) << " cm³ to fill"
                      << (region.needed ? ", bending cannot free it" : "")
                      << (region.joins ? ", joins pieces that are apart" : "") << ".\n";
    }
    return {};
}

Result<ExitCode> analyze(const AnalyzeOptions& options, const Session& session) {
    if (const Result<MoldState> checked = options.state.moldState(); !checked)
        return std::unexpected(checked.error());
    const Result<IndexedMesh> part = loadPart(options.input, session);
    if (!part)
        return std::unexpected(part.error());
    const Result<MoldState> best = bestStateAt(options.state, options.limits, *part);
    if (!best)
        return std::unexpected(best.error());
    const MoldState& state = *best;
    const double draft = options.state.draft;
    const DraftAnalysis analysis = analyzeDraft(*part, state, draft);
    Json json = jsonOf(analysis, state);
    session.out() << readable(100 * analysis.violatingAreaFraction, 3) << " % of the surface below "
                  << readable(draft) << "°, worst draft " << readable(analysis.worstDraftDegrees, 3) << "°, "
                  << analysis.undercuts.size() << " undercuts.\n";
    if (options.regions)
        if (const Result<void> added = addRegions(json, *part, state, session); !added)
            return std::unexpected(added.error());
    if (const Result<void> written = session.writeJson(json); !written)
        return std::unexpected(written.error());
    return analysis.castable() ? ExitCode::Yes : ExitCode::No;
}

} // namespace

Command analyzeCommand() {
    return {"analyze", "Analyses draft and undercuts of a mesh at a plane",
            "Without --d1 and --d2 the directions are optimised. Exit code 0 says that every face has the "
            "draft, 1 that\n"
            "some do not. The JSON holds energy, castable, violating_area_fraction, worst_draft_deg, "
            "undercuts[] (side,\n"
            "area in mm², depth in mm, place, faces) and draft_histogram[]. With --regions also regions[] "
            "(side, place,\n"
            "size, volume in mm³, needed, joins, faces): give a place to design --fill-at or --bend-at.",
            [](CLI::App& app) -> Action {
                const auto options = std::make_shared<AnalyzeOptions>();
                app.add_option("IN", options->input, "Mesh file")->required();
                options->state.declare(app, true);
                options->limits.declare(app);
                app.add_flag("--regions", options->regions,
                             "Also list the regions that can be filled one by one");
                return [options](const Session& session) { return analyze(*options, session); };
            }};
}

} // namespace moldwright::cli
