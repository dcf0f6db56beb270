// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>

namespace CLI {
class App;
}

namespace moldwright::cli {

/// The option that names a variant of a project.
void addVariantOption(CLI::App& app, std::string& variant);

} // namespace moldwright::cli
