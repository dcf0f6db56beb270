// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/size_options.h"

#include "cli/option_values.h"
#include "mesh/measures.h"

#include <CLI/CLI.hpp>

#include <map>

namespace moldwright::cli {

namespace {

const std::map<std::string, Unit> kUnits = {
    {"mm", Unit::Millimetre}, {"cm", Unit::Centimetre}, {"m", Unit::Metre}, {"in", Unit::Inch}};
const std::map<std::string, double> kMillimetres = {{"mm", 1.0}, {"cm", 10.0}, {"m", 1000.0}, {"in", 25.4}};

} // namespace

void SizeOptions::declare(CLI::App& app) {
    app.add_option("--units", units, "Unit of the file's numbers")
        ->check(CLI::IsMember({"mm", "cm", "m", "in"}))
        ->capture_default_str();
    CLI::Option* factor = app.add_option("--scale", scale, "Factor on the file's size")->check(above0());
    app.add_option("--size", size, "Longest side of the part, mm")->check(above0())->excludes(factor);
}

Placement SizeOptions::placementFor(const IndexedMesh& source) const {
    Placement placement;
    placement.unit = kUnits.at(units);
    placement.scale = kMillimetres.at(units) * scale;
    if (size > 0)
        placement.scale = size / boundingBox(source).sizes().maxCoeff();
    return placement;
}

} // namespace moldwright::cli
