// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/pins_command.h"

#include "castability/directions.h"
#include "castability/plane_search.h"
#include "cli/load_part.h"
#include "cli/option_values.h"
#include "cli/size_options.h"
#include "cli/state_options.h"
#include "pins/suggested_pins.h"
#include "project/edits.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <memory>

namespace moldwright::cli {

namespace {

struct PinsOptions {
    std::string input;
    StateOptions state;
    SizeOptions size;
    PinSearch search;
    LimitOptions limits;
};

const char* nameOf(PinKind kind) {
    switch (kind) {
    case PinKind::Tip:
        return "tip";
    case PinKind::Junction:
        return "junction";
    default:
        return "body";
    }
}

Json jsonOf(const SuggestedPin& pin, bool ranked) {
    Json json = {{"point", cli::jsonOf(pin.point)},
                 {"radius", pin.radius},
                 {"kind", nameOf(pin.kind)},
                 {"rank", pin.rank},
                 {"area_share", pin.areaShare}};
    if (ranked)
        json["gain"] = pin.gain;
    return json;
}

Json jsonOf(const PinSuggestions& found, const std::optional<MoldState>& state) {
    Json json = {{"pins", Json::array()}};
    if (state) {
        json["plane"] = cli::jsonOf(state->plane);
        json["d1"] = cli::jsonOf(state->directions.d1);
        json["d2"] = cli::jsonOf(state->directions.d2);
    }
    for (const SuggestedPin& pin : found.pins)
        json["pins"].push_back(jsonOf(pin, state.has_value()));
    return json;
}

/// The state that the options name or ask to be searched; none where they name no plane.
Result<std::optional<MoldState>> stateFor(const PinsOptions& options, const IndexedMesh& part,
                                          const Session& session) {
    const Result<std::optional<PartingPlane>> plane = options.state.givenPlane();
    if (!plane)
        return std::unexpected(plane.error());
    if (*plane) {
        const Result<MoldState> best = bestStateAt(options.state, options.limits, part);
        return best ? Result<std::optional<MoldState>>(*best) : std::unexpected(best.error());
    }
    const Result<DirectionLimits> limits = options.limits.limits();
    if (!limits)
        return std::unexpected(limits.error());
    if (options.state.plane.empty())
        return std::nullopt;
    PlaneSearch search;
    search.count = 1;
    search.draftDegrees = options.state.draft;
    search.limits = *limits;
    search.seed = session.seed();
    const std::vector<PlaneCandidate> best = findPlanes(part, search, session.task().part(0, 0.5));
    if (best.empty())
        return failure(ErrorCode::Cancelled,
                       MW_TEXT("cli", "The search for planes was stopped before its end."));
    return best.front().state;
}

void tell(const PinSuggestions& found, bool ranked, const Session& session) {
    for (const SuggestedPin& pin : found.pins) {
        session.out() << nameOf(pin.kind) << " at " << readable(pin.point.x()) << ' '
                      << readable(pin.point.y()) << ' ' << readable(pin.point.z()) << ": radius "
                      << readable(pin.radius, 3) << ", rank " << readable(pin.rank, 2);
        if (ranked)
            session.out() << ", gain " << readable(100 * pin.gain, 2) << " % of the energy";
        session.out() << '\n';
    }
}

Result<ExitCode> findPins(PinsOptions options, const Session& session) {
    const Result<IndexedMesh> source = loadPart(options.input, session);
    if (!source)
        return std::unexpected(source.error());
    const IndexedMesh part = placed(*source, options.size.placementFor(*source));
    const Result<std::optional<MoldState>> state = stateFor(options, part, session);
    if (!state)
        return std::unexpected(state.error());
    options.search.seed = session.seed();
    Result<PinSuggestions> found = suggestPins(part, options.search, session.task().part(0.5, 1));
    if (!found)
        return std::unexpected(found.error());
    if (*state) {
        rankPins(*found, part, **state, options.state.draft);
        std::stable_sort(found->pins.begin(), found->pins.end(),
                         [](const SuggestedPin& a, const SuggestedPin& b) { return a.rank > b.rank; });
    }
    tell(*found, state->has_value(), session);
    if (const Result<void> written = session.writeJson(jsonOf(*found, *state)); !written)
        return std::unexpected(written.error());
    return ExitCode::Yes;
}

} // namespace

Command pinsCommand() {
    return {
        "pins", "Suggests points to pin to the parting plane",
        "Lists ends of limbs, where limbs meet, and points along the body, highest rank first. With a "
        "plane (or auto:\n"
        "the best one) the rank also counts how much would be gained by moving what lies about the pin "
        "onto the plane.\n"
        "The JSON holds pins[] with point, radius, kind (tip, junction, body), rank, area_share and, with "
        "a plane, gain.\n"
        "design --pins takes such a file: leave in it what is to be pinned.",
        [](CLI::App& app) -> Action {
            const auto options = std::make_shared<PinsOptions>();
            app.add_option("IN", options->input, "Mesh file")->required();
            options->state.declare(app, false);
            app.add_option("--count", options->search.count, "How many pins at most")
                ->check(fromTo(1, 200))
                ->capture_default_str();
            options->limits.declare(app);
            options->size.declare(app);
            return [options](const Session& session) { return findPins(*options, session); };
        }};
}

} // namespace moldwright::cli
