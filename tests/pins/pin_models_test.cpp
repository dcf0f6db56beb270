// SPDX-License-Identifier: AGPL-3.0-or-later
// The ends of limbs of real models, told by hand in tips.json of the models' folder.
#include "exchange/mesh_file.h"
#include "mesh/check.h"
#include "mesh/measures.h"
#include "pins/cgal/inside_test.h"
#include "pins/suggested_pins.h"
#include "support/folders.h"

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include <algorithm>
#include <fstream>

using namespace moldwright;

namespace {

constexpr double kRecalled = 0.06; ///< of the diagonal: a pin within stands for the tip

struct Limbs {
    const char* model;
    int missing; ///< tips that may go without a pin
};

class PinModels : public testing::TestWithParam<Limbs> {};

IndexedMesh modelNamed(const std::string& name) {
    return prepare(readMesh(*test::models() / name).value().mesh, name).value().mesh;
}

std::vector<Eigen::Vector3d> tipsOf(const std::string& model) {
    std::ifstream file(*test::models() / "tips.json");
    const nlohmann::json all = nlohmann::json::parse(file);
    std::vector<Eigen::Vector3d> tips;
    for (const auto& tip : all.at(model))
        tips.emplace_back(tip.at(0), tip.at(1), tip.at(2));
    return tips;
}

} // namespace

TEST_P(PinModels, TheEndsOfLimbsAreAmongTheSuggestedPins) {
    if (!test::models() || !std::filesystem::exists(*test::models() / "tips.json"))
        GTEST_SKIP() << "MOLDWRIGHT_MODELS is not set or has no tips.json";
    const IndexedMesh mesh = modelNamed(GetParam().model);
    const PinSuggestions found = suggestPins(mesh, {40, 1}).value();
    const InsideTest solid(mesh);
    for (const SuggestedPin& pin : found.pins)
        EXPECT_TRUE(solid.inside(pin.point));
    const double near = kRecalled * diagonal(mesh);
    int missing = 0;
    const std::vector<Eigen::Vector3d> tips = tipsOf(GetParam().model);
    for (const Eigen::Vector3d& tip : tips)
        missing += std::none_of(found.pins.begin(), found.pins.end(),
                                [&](const SuggestedPin& pin) { return (pin.point - tip).norm() <= near; });
    EXPECT_GE(tips.size(), 3u);
    EXPECT_LE(missing, GetParam().missing);
}

INSTANTIATE_TEST_SUITE_P(Models, PinModels,
                         testing::Values(Limbs{"hand.stl", 0}, Limbs{"cow.ply", 0}, Limbs{"bunny.stl", 0},
                                         Limbs{"fish.off", 0}, Limbs{"spot.obj", 1}, Limbs{"goathead.stl", 1},
                                         Limbs{"armadillo_5k.ply", 1}),
                         [](const testing::TestParamInfo<Limbs>& limbs) {
                             const std::string name = limbs.param.model;
                             return name.substr(0, name.find('.'));
                         });
