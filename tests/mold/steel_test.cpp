// SPDX-License-Identifier: AGPL-3.0-or-later
// Steel is measured from few points; it is what all of them would tell, to the bit.
#include "mold/steel.h"

#include "mesh/closest_point.h"
#include "mold/block.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace moldwright;
using namespace moldwright::test;
using Eigen::Vector2d;
using Eigen::Vector3d;

namespace {

constexpr double furthest = 1000;

Block blockWith(double outerDraft) {
    MoldSettings settings;
    settings.outerDraft = outerDraft;
    BlockContent content;
    content.cavities = {Vector3d(-60, -45, -12), Vector3d(60, 45, 12)};
    return blockAround(content, settings, {{Vector3d(0.1, 0, 1).normalized(), -Vector3d::UnitZ()}, 0})
        .value();
}

/// Balls, dented so that none is like the other, copies of the first, and boxes, whose points are all as near
/// to a wall as each other.
std::vector<Hollow> someHollows(std::mt19937& random) {
    std::uniform_real_distribution<double> at(-40, 40);
    std::uniform_real_distribution<double> dent(-0.4, 0.4);
    std::vector<Hollow> hollows;
    SharedMesh first;
    for (int i = 0; i < 6; ++i) {
        IndexedMesh mesh =
            i % 3 == 2 ? splitInFour(splitInFour(box({-4, -3, -6}, {4, 3, 6}))) : sphere({0, 0, 0}, 5, 3);
        if (i % 3 != 2)
            for (int v = 0; v < mesh.vertexCount(); ++v)
                mesh.V.row(v) *= 1 + dent(random);
        auto shared = std::make_shared<const IndexedMesh>(std::move(mesh));
        if (!first)
            first = shared;
        hollows.push_back({i % 2 == 0 ? "Cavity" : "Key",
                           i == 3 ? first : shared,
                           {at(random), at(random) / 2},
                           {i / 5},
                           false,
                           i + 1,
                           i % 2 == 1,
                           false});
    }
    return hollows;
}

/// Whether two have points in common: surfaces that cross, or one within the other.
bool meet(const Hollow& a, const Hollow& b) {
    const Vector3d way(b.offset.x() - a.offset.x(), b.offset.y() - a.offset.y(), 0);
    const ClosestPoint tree(*a.mesh);
    return tree.meets(*b.mesh, way) || tree.holds(b.mesh->point(0) + way) ||
           ClosestPoint(*b.mesh).holds(a.mesh->point(0) - way);
}

/// By all points of both, one after the other.
std::vector<ThinSteel> plainly(const std::vector<Hollow>& hollows, const Block& block) {
    std::vector<ThinSteel> all;
    const auto groupOf = [](const Hollow& hollow) {
        return hollow.each ? hollow.name + std::to_string(hollow.number) : hollow.name;
    };
    std::vector<std::pair<std::string, std::string>> groups;
    const auto note = [&](const std::string& a, const std::string& b, const ThinSteel& steel) {
        const std::pair<std::string, std::string> pair = std::minmax(a, b);
        const auto known = std::find(groups.begin(), groups.end(), pair);
        if (known == groups.end()) {
            groups.push_back(pair);
            all.push_back(steel);
        } else if (ThinSteel& least = all[static_cast<std::size_t>(known - groups.begin())];
                   steel.thickness < least.thickness)
            least = steel;
    };
    for (const Hollow& hollow : hollows)
        for (int v = 0; v < hollow.mesh->vertexCount(); ++v) {
            const Vector3d p = hollow.mesh->point(v) + Vector3d(hollow.offset.x(), hollow.offset.y(), 0);
            note(groupOf(hollow), "outside", {block.depthOf(p), p, hollow.name, "outside", hollow.number, 0});
        }
    for (std::size_t i = 0; i < hollows.size(); ++i)
        for (std::size_t j = i + 1; j < hollows.size(); ++j) {
            const Hollow& a = hollows[i];
            const Hollow& b = hollows[j];
            if (areJoined(a, b))
                continue;
            if (meet(a, b))
                note(groupOf(a), groupOf(b), {0, Vector3d::Zero(), a.name, b.name, a.number, b.number});
            for (const bool swapped : {false, true}) {
                const Hollow& points = swapped ? b : a;
                const Hollow& faces = swapped ? a : b;
                const ClosestPoint tree(*faces.mesh);
                for (int v = 0; v < points.mesh->vertexCount(); ++v) {
                    const Vector3d p =
                        points.mesh->point(v) + Vector3d(points.offset.x(), points.offset.y(), 0);
                    const double distance =
                        tree.distance(p - Vector3d(faces.offset.x(), faces.offset.y(), 0));
                    note(groupOf(a), groupOf(b), {distance, p, a.name, b.name, a.number, b.number});
                }
            }
        }
    std::stable_sort(all.begin(), all.end(),
                     [](const ThinSteel& a, const ThinSteel& b) { return a.thickness < b.thickness; });
    return all;
}

} // namespace

TEST(Steel, IsWhatAllPointsTell) {
    std::mt19937 random(3);
    for (int round = 0; round < 12; ++round) {
        const Block block = blockWith(4.0 * (round % 3 - 1));
        const std::vector<Hollow> hollows = someHollows(random);
        SteelTrees trees;
        const std::vector<ThinSteel> quick = thinnestSteel(hollows, block, furthest, trees);
        const std::vector<ThinSteel> plain = plainly(hollows, block);
        ASSERT_EQ(quick.size(), plain.size());
        for (const ThinSteel& expected : plain) {
            const auto same = std::find_if(quick.begin(), quick.end(), [&](const ThinSteel& thin) {
                return thin.thickness == expected.thickness && thin.first == expected.first &&
                       thin.second == expected.second && thin.firstNumber == expected.firstNumber &&
                       thin.secondNumber == expected.secondNumber;
            });
            ASSERT_NE(same, quick.end()) << expected.first << expected.firstNumber << ' ' << expected.second
                                         << ' ' << expected.thickness;
            // Of the places that are nearest to the outside it is the first.
            if (expected.second == "outside") {
                EXPECT_EQ(same->place, expected.place);
            }
        }
        // What is kept for the next measuring tells the same.
        EXPECT_EQ(thinnestSteel(hollows, block, furthest, trees), quick);
    }
}

TEST(Steel, OfABoxIsTheLeastOfItsPlacesToTheBit) {
    std::mt19937 random(4);
    std::uniform_real_distribution<double> at(-70, 70);
    for (int round = 0; round < 3000; ++round) {
        const Block block = blockWith(5.0 * (round % 3 - 1));
        const Eigen::AlignedBox3d box = [&] {
            Eigen::AlignedBox3d two(Vector3d(at(random), at(random), at(random) / 6));
            return two.extend(Vector3d(at(random), at(random), at(random) / 6));
        }();
        const double bound = block.depthOf(box);
        double corners = furthest;
        for (int k = 0; k < 8; ++k) {
            const Vector3d p = box.corner(static_cast<Eigen::AlignedBox3d::CornerType>(k));
            corners = std::min(corners, block.depthOf(p));
            const Vector3d inside = box.sample();
            EXPECT_LE(bound, block.depthOf(inside));
        }
        EXPECT_LE(bound, corners);
        // On one side of the plane the depth is least at a corner.
        if (box.min().z() >= 0 || box.max().z() < 0) {
            EXPECT_EQ(bound, corners);
        }
    }
}
