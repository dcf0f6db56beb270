// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/mold_command.h"

#include "cli/material_table.h"
#include "cli/mold_options.h"
#include "cli/tray_parts.h"
#include "cli/variant_option.h"
#include "exchange/user_folder.h"
#include "mold/mold_files.h"
#include "mold/plaque.h"
#include "project/presets.h"
#include "project/project_file.h"
#include "project/variants.h"
#include "report/figures.h"

#include <CLI/CLI.hpp>

#include <algorithm>
#include <iterator>
#include <memory>

namespace moldwright::cli {

namespace {

struct MoldJob {
    std::string input;
    std::string folder;
    MoldOptions mold;
    std::vector<std::string> also;
    std::string material;
    std::string savePreset;
    std::string variant;
    std::vector<std::string> with;
};

/// What a material's value is, and where it comes from.
std::string cited(const char* what, const MaterialValue& value, const char* unit) {
    return std::string(what) + " " + readable(value.value) + unit + " (" + value.source +
           (value.status == "sourced" ? "" : "; " + value.status) + ")";
}

/// Shrink and density of the material, and a sentence that says so; one more where the cast has less draft.
Result<MoldSettings> withMaterial(MoldSettings settings, const std::string& name, double draftDegrees,
                                  std::vector<std::string>& notes) {
    const Result<std::vector<Material>> table = materialTable();
    if (!table)
        return std::unexpected(table.error());
    const Result<Material> material = materialNamed(*table, name);
    if (!material)
        return std::unexpected(material.error());
    settings.shrink.percent.setConstant(material->shrinkPercent.value);
    settings.shrink.formula = material->divide ? ShrinkFormula::Divide : ShrinkFormula::Plus;
    settings.density = material->density.value;
    notes.push_back(material->name + ": " + cited("shrink", material->shrinkPercent, " %") + ", " +
                    cited("density", material->density, " g/cm³") + ".");
    if (material->ventDepth) {
        settings.vents.depth = material->ventDepth->value;
        notes.push_back("Vents in the parting plane as an injection mold for it has them: " +
                        cited("depth", *material->ventDepth, " mm") + ".");
    }
    if (!material->preparation.empty())
        notes.push_back("Preparation for " + material->name + ": " + material->preparation);
    if (material->draftDegrees.value > draftDegrees)
        notes.push_back("The cast was designed with " + readable(draftDegrees) + "° of draft; " +
                        material->name + " usually asks for " +
                        cited("", material->draftDegrees, "°").substr(1) + ".");
    return settings;
}

MoldFormats formatsOf(const std::vector<std::string>& names) {
    const auto given = [&](const char* name) {
        return std::find(names.begin(), names.end(), name) != names.end();
    };
    return {given("obj"), given("ply"), given("svg"), given("dxf")};
}

void describe(const Mold& mold, std::ostream& out) {
    if (mold.verified())
        out << "The mold opens: both halves are proved at "
            << figureRoundedDown(mold.castCertificate.worstDraftDegrees, 2) << "°.\n";
    else
        out << "The mold was written, but it is not proved to open.\n";
    const Eigen::Vector3d size = mold.blockSize;
    out << "Block " << readable(size.x()) << " x " << readable(size.y()) << " x " << readable(size.z())
        << " mm, " << mold.cavities << (mold.cavities == 1 ? " cavity" : " cavities")
        << (mold.parts.size() > 1 ? " (" + partsInWords(mold.parts) + ")" : "") << ", "
        << readable((mold.cavityVolume + mold.channelVolume) / 1000) << " cm³ a shot, smallest wall "
        << readable(mold.minWall) << " mm.\n";
    if (mold.savedVolume > 0)
        out << "The shell has " << readable(mold.savedVolume / 1000) << " cm³ less than its box, "
            << readable(100 * mold.savedVolume / (mold.savedVolume + mold.blockVolume), 2) << " %.\n";
}

/// What came of it, on the terminal and as JSON.
Result<ExitCode> told(const Mold& mold, const Session& session) {
    describe(mold, session.out());
    for (const Message& note : mold.notes)
        session.tell(note);
    for (const std::string& problem : mold.problems)
        session.tell({problem, {}});
    if (const Result<void> written = session.writeJson(Json::parse(moldJson(mold))); !written)
        return std::unexpected(written.error());
    return mold.verified() ? ExitCode::Yes : ExitCode::No;
}

Result<ExitCode> build(const MoldJob& job, const Session& session) {
    session.task().progress(0, "Reading");
    Result<Project> opened = projectAt(job.input, job.variant);
    if (!opened)
        return std::unexpected(opened.error());
    Project& project = *opened;
    if (!project.cast)
        return failure(ErrorCode::BadInput, MW_TEXT("cli", "{0} holds no finished cast. Run design first."),
                       {job.input});
    const CastResult& cast = *project.cast;
    std::vector<std::string> notes;
    if (!job.material.empty()) {
        Result<MoldSettings> chosen = withMaterial(project.mold, job.material, cast.draftDegrees, notes);
        if (!chosen)
            return std::unexpected(chosen.error());
        project.mold = *std::move(chosen);
    }
    Result<MoldSettings> settings = job.mold.applied(project.mold);
    if (!settings)
        return std::unexpected(settings.error());
    if (!job.savePreset.empty())
        if (const Result<void> saved =
                savePreset(userFolder("presets").value_or(""), job.savePreset, *settings);
            !saved)
            return std::unexpected(saved.error());
    settings->plaque.text = plaqueText(settings->plaque.text, project.name);
    const Result<Tray> tray = withParts(trayOf(project, project.name), job.with);
    if (!tray)
        return std::unexpected(tray.error());
    Result<Mold> mold = buildMold(*tray, cast.draftDegrees, *settings, session.task().part(0.1, 0.9));
    if (!mold)
        return std::unexpected(mold.error());
    std::ranges::transform(notes, std::inserter(mold->notes, mold->notes.begin()),
                           [](const std::string& note) { return Message{note, {}}; });
    if (const Result<void> written = writeMold(*mold, namesOf(*tray), job.folder, formatsOf(job.also));
        !written)
        return std::unexpected(written.error());
    session.task().progress(1, "Done");
    return told(*mold, session);
}

constexpr const char* manual =
    "IN is a project file that holds a cast, or the folder that design wrote. Writes mold-half-1.stl,\n"
    "mold-half-2.stl and mold-cast.stl in the mold's frame (parting plane z = 0, side 1 up), mold.3mf\n"
    "with all three on a plate, and mold.json. What is written is what was proved. The spout leaves\n"
    "through the face at +y; --pour says which turn of the cast that is up for.\n"
    "\n"
    "--with puts other finished casts into the same mold, each one cavity or as many as its :N says,\n"
    "besides the parts that the project's mold has already; the other places of --cavities or\n"
    "--cavity-places are IN's, which come first: row by row, the lowest row first. Rows that are too short\n"
    "get more columns. All leave along the removal directions of IN: a part that cannot, turned about the\n"
    "normal as may be, is refused with the draft that it would have.\n"
    "\n"
    "--places takes {\"features\": [{\"kind\": \"key\", \"number\": 1, \"at\": [x, y]}, ...]}, mm, as "
    "mold.json lists\n"
    "them: these stand there, all others find their own places.\n"
    "\n"
    "JSON: as mold.json: verified, d1, d2, part_to_mold[16] (row-major), parts[] (name, cavities, volume,\n"
    "part_to_mold), half1, half2 (volume, size, faces), cavity_volume, channel_volume, parting_area,\n"
    "clamp_force (kN), min_wall, features[], steel[], shot, shrink, path_lengths[], trapped_air, notes[],\n"
    "problems[].\n"
    "\n"
    "Example:\n"
    "  moldwright-cli mold rabbit.moldwright --out rabbit-mold --cavities 2x2 --spout auto --vents auto\n"
    "      --keys 4 --slits 2 --material polyurethane\n"
    "  moldwright-cli mold fish --with rabbit:3 --out tray --cavities 1x5 --spout auto";

} // namespace

Command moldCommand() {
    return {
        "mold", "Build, prove and write the two mold halves of a cast", manual, [](CLI::App& app) {
            auto job = std::make_shared<MoldJob>();
            app.add_option("IN", job->input, "Project file, or folder written by design")
                ->type_name("FILE|DIR")
                ->required();
            app.add_option("--out", job->folder, "Folder for the mold's files")->type_name("DIR")->required();
            app.add_option("--also", job->also, "Further files: obj, ply, svg, dxf; comma between")
                ->delimiter(',')
                ->check(CLI::IsMember({"obj", "ply", "svg", "dxf"}));
            app.add_option("--material", job->material,
                           "Takes shrink, formula, density and depth of vents from the table of materials; "
                           "options given go "
                           "first")
                ->type_name("NAME");
            app.add_option("--save-preset", job->savePreset,
                           "Saves block, layout, features and machines under this name, for --preset")
                ->type_name("NAME");
            addVariantOption(app, job->variant);
            addTrayOption(app, job->with);
            job->mold.declare(app);
            return Action([job](const Session& session) { return build(*job, session); });
        }};
}

} // namespace moldwright::cli
