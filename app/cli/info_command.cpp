// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/info_command.h"

#include "cli/state_options.h"
#include "cli/variant_option.h"
#include "project/project_file.h"
#include "project/variant_figures.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace moldwright::cli {

namespace {

struct InfoOptions {
    std::string file;
    std::string variant;
};

Json described(const VariantFigures& figures) {
    const auto known = [](const std::optional<double>& value) { return value ? Json(*value) : Json(); };
    return {{"castable", figures.castable},
            {"worst_draft_deg", figures.worstDraftDegrees},
            {"strain_rms", known(figures.strain)},
            {"max_distance", figures.largestDistance},
            {"rms_distance", known(figures.rmsDistance)},
            {"filled_volume", figures.filledVolume},
            {"block", figures.blockSize ? jsonOf(*figures.blockSize) : Json()},
            {"steps", figures.steps}};
}

/// What a variant is made with, and how it came out.
Json described(const Project& project) {
    Json json = {{"name", project.variantName},
                 {"pins", project.pins.size()},
                 {"regions", project.importance.size()},
                 {"draft_deg", project.design.draftDegrees},
                 {"designed", project.cast != nullptr}};
    for (const TrayPart& part : project.furtherParts)
        json["further_parts"].push_back(
            {{"name", part.name}, {"source", part.source}, {"count", part.count}});
    if (project.state) {
        json["plane"] = jsonOf(project.state->plane);
        json["d1"] = jsonOf(project.state->directions.d1);
        json["d2"] = jsonOf(project.state->directions.d2);
    }
    if (project.part && project.cast)
        json["figures"] = described(variantFigures(*project.part, project));
    return json;
}

Result<ExitCode> info(const InfoOptions& options, const Session& session) {
    const Result<std::string> text = projectManifest(options.file);
    if (!text)
        return std::unexpected(text.error());
    Json manifest = Json::parse(*text);
    if (!options.variant.empty()) {
        const Result<Project> project = projectAt(options.file, options.variant);
        if (!project)
            return std::unexpected(project.error());
        manifest["variant"] = described(*project);
    }
    session.out() << (options.variant.empty() ? *text : manifest.dump(2) + "\n");
    if (const Result<void> written = session.writeJson(manifest); !written)
        return std::unexpected(written.error());
    return ExitCode::Yes;
}

constexpr const char* manual =
    "JSON: the project's manifest: format, version, minReader, name, part and cast\n"
    "(points, faces), parts[]; with several variants variants[]: name, current, cast; with further\n"
    "parts in its mold further_parts[]: name, count. With --variant also variant: name, pins, regions,\n"
    "draft_deg, designed, further_parts[] with their source, plane[4], d1, d2, and once it is designed\n"
    "figures: castable, worst_draft_deg, strain_rms, max_distance, rms_distance (mm), filled_volume\n"
    "(mm³), block[3] (mm), steps.\n"
    "\n"
    "Examples:\n"
    "  moldwright-cli info rabbit.moldwright --json -\n"
    "  moldwright-cli info rabbit.moldwright --variant B --json -";

} // namespace

Command infoCommand() {
    return {
        "info", "Say what a project file holds", manual, [](CLI::App& app) {
            auto options = std::make_shared<InfoOptions>();
            app.add_option("IN", options->file, "Project file (.moldwright)")->type_name("FILE")->required();
            addVariantOption(app, options->variant);
            return Action([options](const Session& session) { return info(*options, session); });
        }};
}

} // namespace moldwright::cli
