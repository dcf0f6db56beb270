// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <CLI/CLI.hpp>

#include <cmath>
#include <optional>
#include <sstream>
#include <string>
#include <type_traits>

namespace moldwright::cli {

/// The value becomes what was given, if anything was.
template <class T>
void take(T& value, const std::optional<T>& given) {
    if (given)
        value = *given;
}

/// A check that a value is a number for which `holds`; else the sentence ends with `wanted`.
template <class Holds>
CLI::Validator numberThat(Holds holds, const std::string& wanted) {
    return CLI::Validator(
        [holds, wanted](std::string& given) {
            double value = 0;
            const bool isNumber = CLI::detail::lexical_cast(given, value);
            return isNumber && holds(value) ? std::string() : given + " is not " + wanted + ".";
        },
        "");
}

/// Above 0.
inline CLI::Validator above0() {
    return numberThat([](double x) { return x > 0; }, "a number above 0");
}

/// 0 or more.
inline CLI::Validator atLeast0() {
    return numberThat([](double x) { return x >= 0; }, "a number of 0 or more");
}

/// From `low` to `high`; the help tells the range.
template <class T>
CLI::Validator fromTo(T low, T high) {
    std::ostringstream range;
    range << low << " to " << high;
    std::ostringstream shown;
    shown << "in [" << low << " - " << high << "]";
    return numberThat(
               [low, high](double x) {
                   return x >= low && x <= high && (!std::is_integral_v<T> || x == std::floor(x));
               },
               (std::is_integral_v<T> ? "a whole number from " : "a number from ") + range.str())
        .description(shown.str());
}

/// An option that takes a length above 0, mm.
inline CLI::Option* length(CLI::App& app, const std::string& name, std::optional<double>& value,
                           const std::string& help) {
    return app.add_option(name, value, help)->type_name("MM")->check(above0());
}

} // namespace moldwright::cli
