// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/report_command.h"

#include "cli/render_client.h"
#include "cli/variant_option.h"

#include <CLI/CLI.hpp>

#include <memory>

namespace moldwright::cli {

namespace {

struct ReportOptions {
    std::string input;
    std::string output;
    std::string variant;
    std::string language;
};

Result<ExitCode> report(const ReportOptions& options, const Session& session) {
    session.task().progress(0, "Writing the report");
    const Result<RenderedReport> rendered =
        renderReport({options.input, options.output, options.variant, options.language}, session.task());
    if (!rendered)
        return std::unexpected(rendered.error());
    session.task().progress(1, "Writing the report");
    session.out() << options.output << ": " << rendered->pages << " pages.\n";
    if (!rendered->missingPictures.empty())
        session.tell({MW_TEXT("cli", "The report has no pictures. {0}"), {rendered->missingPictures}});
    const Json json = {{"pages", rendered->pages},
                       {"file", options.output},
                       {"missing_pictures", rendered->missingPictures}};
    if (const Result<void> written = session.writeJson(json); !written)
        return std::unexpected(written.error());
    return ExitCode::Yes;
}

constexpr const char* manual =
    "Two A4 pages: part, cast and draft map, plane and directions, draft by area, volumes, the\n"
    "mold, and the certificate; one more for the mold's features, and with several variants one with\n"
    "their figures side by side. Needs no display; moldwright-render draws it.\n"
    "\n"
    "JSON: pages, file, missing_pictures (why, or empty).\n"
    "\n"
    "Example:\n"
    "  moldwright-cli report rabbit.moldwright --out rabbit.pdf";

} // namespace

Command reportCommand() {
    return {
        "report", "Write the printable report of a project", manual, [](CLI::App& app) {
            auto options = std::make_shared<ReportOptions>();
            app.add_option("IN", options->input, "Project file (.moldwright)")->type_name("FILE")->required();
            app.add_option("--out", options->output, "The PDF to write")->type_name("FILE")->required();
            addVariantOption(app, options->variant);
            app.add_option("--language", options->language, "en, de or zh_CN; the default is English")
                ->check(CLI::IsMember({"en", "de", "zh_CN"}));
            return Action([options](const Session& session) { return report(*options, session); });
        }};
}

} // namespace moldwright::cli
