// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/plane_command.h"

#include "castability/plane_search.h"
#include "cli/load_part.h"
#include "cli/option_values.h"
#include "cli/state_options.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace moldwright::cli {

namespace {

struct PlaneOptions {
    std::string input;
    PlaneSearch search;
    LimitOptions limits;
};

Json jsonOf(const PlaneCandidate& c) {
    return {{"plane", cli::jsonOf(c.state.plane)},
            {"d1", cli::jsonOf(c.state.directions.d1)},
            {"d2", cli::jsonOf(c.state.directions.d2)},
            {"energy", c.energy},
            {"violating_area_fraction", c.violatingAreaFraction},
            {"worst_draft_deg", c.worstDraftDegrees},
            {"smaller_volume_fraction", c.smallerVolumeFraction}};
}

Result<ExitCode> findBest(PlaneOptions options, const Session& session) {
    const Result<IndexedMesh> part = loadPart(options.input, session);
    if (!part)
        return std::unexpected(part.error());
    const Result<DirectionLimits> limits = options.limits.limits();
    if (!limits)
        return std::unexpected(limits.error());
    options.search.limits = *limits;
    options.search.seed = session.seed();
    const std::vector<PlaneCandidate> planes = findPlanes(*part, options.search, session.task());
    if (session.task().stopped())
        return failure(ErrorCode::Cancelled,
                       MW_TEXT("cli", "The search for planes was stopped before its end."));
    Json json = {{"planes", Json::array()}};
    for (const PlaneCandidate& candidate : planes) {
        json["planes"].push_back(jsonOf(candidate));
        const PartingPlane& p = candidate.state.plane;
        session.out() << "plane " << readable(p.normal.x()) << ' ' << readable(p.normal.y()) << ' '
                      << readable(p.normal.z()) << ' ' << readable(p.offset) << ": "
                      << readable(100 * candidate.violatingAreaFraction, 3) << " % of the surface below "
                      << readable(options.search.draftDegrees) << "°, worst "
                      << readable(candidate.worstDraftDegrees, 3) << "°\n";
    }
    if (const Result<void> written = session.writeJson(json); !written)
        return std::unexpected(written.error());
    return ExitCode::Yes;
}

} // namespace

Command planeCommand() {
    return {"plane", "Finds the best parting planes of a mesh",
            "Samples planes at random, refines the best of them together with both removal directions, and "
            "lists\n"
            "distinct ones, best first. The JSON holds planes[] with plane, d1, d2, energy, "
            "violating_area_fraction and\n"
            "worst_draft_deg.",
            [](CLI::App& app) -> Action {
                const auto options = std::make_shared<PlaneOptions>();
                app.add_option("IN", options->input, "Mesh file")->required();
                app.add_option("--count", options->search.count, "How many planes")
                    ->check(fromTo(1, 200))
                    ->capture_default_str();
                app.add_option("--draft", options->search.draftDegrees, "Draft angle, degrees")
                    ->check(fromTo(0.0, 45.0))
                    ->capture_default_str();
                options->limits.declare(app);
                return [options](const Session& session) { return findBest(*options, session); };
            }};
}

} // namespace moldwright::cli
