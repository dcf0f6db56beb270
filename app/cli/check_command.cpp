// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/check_command.h"

#include "cli/load_part.h"
#include "exchange/mesh_file.h"
#include "exchange/repair_mesh.h"
#include "mesh/measures.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace moldwright::cli {

namespace {

struct CheckOptions {
    std::string input;
    std::string output;
    bool repair = false;
};

/// What the JSON says of a file that could not even be read.
Json unreadable(const Error& error) {
    Json json = {{"usable", false}};
    for (const char* key : {"vertices", "faces", "closed", "manifold", "oriented", "self_intersections",
                            "components", "genus", "volume", "bbox"})
        json[key] = nullptr;
    json["repairs"] = Json::array();
    json["problems"] = {error.english()};
    return json;
}

Json jsonOf(const Examination& part) {
    const MeshDiagnosis& found = part.diagnosis;
    const bool solid = found.closed && found.manifold;
    std::vector<Message> problems;
    for (const Error& fault : part.faults)
        problems.push_back(fault.message);
    const Eigen::AlignedBox3d box = boundingBox(part.mesh);
    return {{"usable", part.faults.empty()},
            {"vertices", part.mesh.vertexCount()},
            {"faces", part.mesh.faceCount()},
            {"closed", found.closed},
            {"manifold", found.manifold},
            {"oriented", found.oriented},
            {"self_intersections", found.selfIntersections.size()},
            {"components", found.components},
            {"genus", solid ? Json(found.genus) : Json()},
            {"volume", found.closed ? Json(found.volume) : Json()},
            {"bbox", box.isEmpty() ? Json() : cli::jsonOf(box)},
            {"repairs", cli::jsonOf(part.repairs)},
            {"notes", cli::jsonOf(part.notes)},
            {"problems", cli::jsonOf(problems)}};
}

void describe(const Examination& part, const std::string& name, std::ostream& out) {
    for (const std::vector<Message>& messages : {part.repairs, part.notes})
        for (const Message& message : messages)
            out << message.english() << '\n';
    const Eigen::Vector3d size = boundingBox(part.mesh).sizes();
    out << name << (part.faults.empty() ? " can be used: " : " cannot be used: ") << part.mesh.vertexCount()
        << " points, " << part.mesh.faceCount() << " faces, size " << readable(size.x()) << " x "
        << readable(size.y()) << " x " << readable(size.z());
    if (part.faults.empty())
        out << ", volume " << readable(part.diagnosis.volume) << ", genus " << part.diagnosis.genus;
    out << ".\n";
}

/// What a mesh is after repair, with what was done to it.
Result<Examination> repaired(const IndexedMesh& mesh, const std::string& name, const CheckOptions& options,
                             const Session& session) {
    const std::optional<MeshFormat> format = formatFor(options.output);
    if (!format)
        return failure(ErrorCode::Usage,
                       MW_TEXT("cli", "--out takes a name that ends in .stl, .ply, .obj or .off."));
    Result<RepairedMesh> done = repairMesh(mesh, name, session.task().part(0.3, 0.9));
    if (!done)
        return std::unexpected(done.error());
    if (*format == MeshFormat::StlBinary)
        done->mesh = roundToFloat(done->mesh);
    // Of the coordinates as they are written.
    Examination part = examine(done->mesh, name);
    if (!part.faults.empty())
        return std::unexpected(part.faults.front());
    part.repairs = std::move(done->repairs);
    if (const Result<void> written = writeMesh(options.output, part.mesh, *format); !written)
        return std::unexpected(written.error());
    return part;
}

Result<ExitCode> check(const CheckOptions& options, const Session& session) {
    if (options.repair != !options.output.empty())
        return failure(
            ErrorCode::Usage,
            MW_TEXT("cli", "--repair and --out belong together: the repaired mesh goes to --out."));
    session.task().progress(0, "Reading");
    const Result<ReadMesh> read = readMesh(options.input, session.task());
    if (!read) {
        const Result<void> written = session.writeJson(unreadable(read.error()));
        return written ? std::unexpected(read.error()) : std::unexpected(written.error());
    }
    session.task().progress(0.3, "Checking");
    const std::string name = std::filesystem::path(options.input).filename().string();
    Examination part = examine(read->mesh, name);
    if (options.repair) {
        Result<Examination> better = repaired(read->mesh, name, options, session);
        if (better)
            part = *std::move(better);
        else if (better.error().code != ErrorCode::BadInput && better.error().code != ErrorCode::Worker)
            return std::unexpected(better.error());
        else
            part.faults.push_back(better.error());
    }
    part.notes.insert(part.notes.begin(), read->notes.begin(), read->notes.end());
    session.task().progress(1, "Done");
    describe(part, name, session.out());
    if (const Result<void> written = session.writeJson(jsonOf(part)); !written)
        return std::unexpected(written.error());
    for (const Error& fault : part.faults)
        session.tell(fault.message);
    return part.faults.empty() ? ExitCode::Yes : ExitCode::BadInput;
}

constexpr const char* manual =
    "IN is an STL, OBJ, PLY or OFF file. What can be mended without a choice is mended first and\n"
    "named: equal points are welded, repeated faces and unused points dropped, faces turned outward.\n"
    "A usable mesh is closed and manifold, encloses a volume, does not cross itself, and has no closed\n"
    "surface inside another; all else is refused with what is wrong, how many and where.\n"
    "With --repair faults are mended: faces and points that too many share are split, scraps dropped,\n"
    "holes filled, faces made anew where they cross. Where that is not enough a closed skin is made\n"
    "about the surface, and how far it may lie from it is said. What is written can be used.\n"
    "\n"
    "JSON: usable, vertices, faces, closed, manifold, oriented, self_intersections, components, genus,\n"
    "volume, bbox, repairs[], notes[], problems[]; of the mesh as mended, null where it has no meaning.\n"
    "\n"
    "Example:\n"
    "  moldwright-cli check scan.ply --repair --out scan-mended.ply";

} // namespace

Command checkCommand() {
    return {"check", "Read a mesh and say whether it can be designed with, or why not", manual,
            [](CLI::App& app) {
                auto options = std::make_shared<CheckOptions>();
                app.add_option("IN", options->input, "Mesh file")->type_name("FILE")->required();
                app.add_flag("--repair", options->repair, "Repair it, and write it to --out");
                app.add_option("--out", options->output, "The repaired mesh: .stl, .ply, .obj or .off")
                    ->type_name("FILE");
                return Action([options](const Session& session) { return check(*options, session); });
            }};
}

} // namespace moldwright::cli
