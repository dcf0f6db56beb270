// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/variant_option.h"

#include <CLI/CLI.hpp>

namespace moldwright::cli {

void addVariantOption(CLI::App& app, std::string& variant) {
    app.add_option("--variant", variant, "Name of one of the project's variants; else the current one")
        ->type_name("NAME");
}

} // namespace moldwright::cli
