// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include <optional>
#include <string>

namespace moldwright::cli {

/// The value becomes what was given, if anything was.
template <class T>
void take(T& value, const std::optional<T>& given) {
    if (given)
        value = *given;
}

/// An option that takes a length above 0, mm.
inline CLI::Option* length(CLI::App& app, const std::string& name, std::optional<double>& value,
                           const std::string& help) {
    return app.add_option(name, value, help)->type_name("MM")->check(CLI::PositiveNumber.description(""));
}

} // namespace moldwright::cli
