// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/verify_command.h"

#include "castability/certificate.h"
#include "cli/state_options.h"
#include "exchange/mesh_file.h"
#include "mold/release.h"
#include "report/figures.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace moldwright::cli {

namespace {

struct VerifyOptions {
    std::string cast;
    StateOptions state;
    std::string half1;
    std::string half2;
};

struct CheckedHalf {
    int side = 1;
    HalfRelease release;
};

Json jsonOf(const Certificate& proof) {
    return {{"castable", proof.holds()},
            {"worst_draft_deg", proof.worstDraftDegrees},
            {"violating_faces", proof.violatingFaces.size()},
            {"parting_curves_simple", proof.curvesSimpleAndNested},
            {"closed_and_outward", proof.closedAndOutward},
            {"directions_leave", proof.directionsLeave},
            {"faces_keep_their_side", proof.curvesOnPlane},
            {"self_intersection_free", proof.selfIntersectionFree},
            {"reason", proof.reason}};
}

Json jsonOf(const std::vector<CheckedHalf>& halves) {
    Json json = Json::array();
    for (const CheckedHalf& half : halves)
        json.push_back({{"side", half.side},
                        {"sound", half.release.sound},
                        {"free_to_move", half.release.freeToMove()},
                        {"violating_faces", half.release.stuckFaces.size()},
                        {"faces_that_collide", half.release.sweptFaces.size()}});
    return json;
}

/// Both halves against each other and the cast, all in the cast's frame; nothing without files.
Result<std::vector<CheckedHalf>> checkHalves(const VerifyOptions& options, const IndexedMesh& cast,
                                             const Directions& directions, const Task& task) {
    std::vector<CheckedHalf> halves;
    if (options.half1.empty())
        return halves;
    const Result<ReadMesh> first = readMesh(options.half1, task);
    if (!first)
        return std::unexpected(first.error());
    const Result<ReadMesh> second = readMesh(options.half2, task);
    if (!second)
        return std::unexpected(second.error());
    halves.push_back(
        {1, examineRelease(first->mesh, second->mesh, cast, directions.d1, options.state.draft)});
    halves.push_back(
        {2, examineRelease(second->mesh, first->mesh, cast, directions.d2, options.state.draft)});
    return halves;
}

void describe(const Certificate& proof, const std::vector<CheckedHalf>& halves, std::ostream& out) {
    if (proof.holds())
        out << "Castable: every face leaves with " << figureRoundedDown(proof.worstDraftDegrees, 2)
            << "° or more.\n";
    else
        out << "Not castable. " << proof.reason << "\n";
    for (const CheckedHalf& half : halves)
        out << "Half " << half.side << (half.release.sound ? " is sound and " : " is not sound and ")
            << (half.release.freeToMove() ? "free to move.\n" : "not free to move.\n");
}

Result<ExitCode> verify(const VerifyOptions& options, const Session& session) {
    const Result<MoldState> state = options.state.moldState();
    if (!state)
        return std::unexpected(state.error());
    session.task().progress(0, "Reading");
    // Read without mending: what is proved is the file.
    const Result<ReadMesh> cast = readMesh(options.cast, session.task());
    if (!cast)
        return std::unexpected(cast.error());
    session.task().progress(0.3, "Proving");
    const SideLabels labels = labelSides(cast->mesh, state->plane);
    const Certificate proof = certify(cast->mesh, labels, *state, options.state.draft);
    const Result<std::vector<CheckedHalf>> halves =
        checkHalves(options, cast->mesh, state->directions, session.task().part(0.5, 1));
    if (!halves)
        return std::unexpected(halves.error());
    session.task().progress(1, "Proving");
    describe(proof, *halves, session.out());
    Json json = jsonOf(proof);
    if (!halves->empty())
        json["halves"] = jsonOf(*halves);
    if (const Result<void> written = session.writeJson(json); !written)
        return std::unexpected(written.error());
    const bool free = std::all_of(halves->begin(), halves->end(), [](const CheckedHalf& half) {
        return half.release.sound && half.release.freeToMove();
    });
    return proof.holds() && free ? ExitCode::Yes : ExitCode::No;
}

constexpr const char* manual =
    "Proves in exact arithmetic, on the coordinates as they stand in the file, that CAST leaves both\n"
    "halves: every face of side i has N·d_i >= sin(draft), no face lies across the plane, the parting\n"
    "curves are simple and nested along both directions, the surface is closed and does not cross\n"
    "itself. With --half1 and --half2 (in CAST's frame; for written molds the mold's frame, plane\n"
    "0 0 1 0, and mold-cast.stl as CAST) both halves are examined too: closed, one piece, and free to\n"
    "move, by angles and by rays.\n"
    "\n"
    "JSON: castable, worst_draft_deg (rounded down), violating_faces, parting_curves_simple, reason, …,\n"
    "halves[] with side, sound, free_to_move.\n"
    "\n"
    "Example:\n"
    "  moldwright-cli verify cast.stl --plane 0 0 1 0 --d1 0 0 1 --d2 0 0 -1 --draft 1";

} // namespace

Command verifyCommand() {
    return {"verify", "Prove that a cast leaves its mold, on files as written", manual, [](CLI::App& app) {
                auto options = std::make_shared<VerifyOptions>();
                app.add_option("CAST", options->cast, "Mesh file of the cast")->type_name("FILE")->required();
                options->state.declare(app, true);
                CLI::Option* half1 = app.add_option("--half1", options->half1, "Mesh file of mold half 1");
                CLI::Option* half2 = app.add_option("--half2", options->half2, "Mesh file of mold half 2");
                half1->type_name("FILE")->needs(half2);
                half2->type_name("FILE")->needs(half1);
                return Action([options](const Session& session) { return verify(*options, session); });
            }};
}

} // namespace moldwright::cli
