// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/info_command.h"

#include "project/project_file.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace moldwright::cli {

namespace {

Result<ExitCode> info(const std::string& file, const Session& session) {
    const Result<std::string> manifest = projectManifest(file);
    if (!manifest)
        return std::unexpected(manifest.error());
    session.out() << *manifest;
    if (const Result<void> written = session.writeJson(Json::parse(*manifest)); !written)
        return std::unexpected(written.error());
    return ExitCode::Yes;
}

constexpr const char* manual =
    "JSON: the project's manifest: format, version, minReader, name, part and cast\n"
    "(points, faces), parts[].\n"
    "\n"
    "Example:\n"
    "  moldwright-cli info rabbit.moldwright --json -";

} // namespace

Command infoCommand() {
    return {"info", "Say what a project file holds", manual, [](CLI::App& app) {
                auto file = std::make_shared<std::string>();
                app.add_option("IN", *file, "Project file (.moldwright)")->type_name("FILE")->required();
                return Action([file](const Session& session) { return info(*file, session); });
            }};
}

} // namespace moldwright::cli
