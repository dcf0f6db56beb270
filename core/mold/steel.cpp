// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/steel.h"

#include "base/parallel.h"
#include "base/stop_point.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <queue>
#include <set>
#include <tuple>
#include <utility>

namespace moldwright {

namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

class SteelMeasure {
public:
    SteelMeasure(const std::vector<Hollow>& hollows, const Block& block, double furthest,
                 const SteelTrees& trees)
        : m_hollows(hollows), m_block(block), m_furthest(furthest), m_trees(trees) {
        for (const Hollow& hollow : hollows) {
            AlignedBox3d box;
            for (const PointGroup& group : trees.groupsOf(hollow.mesh))
                box.extend(group.box);
            m_boxes.push_back(box.translated(shift(hollow)));
            m_groups.push_back(hollow.name + (hollow.each ? ' ' + std::to_string(hollow.number) : ""));
        }
    }

    std::vector<ThinSteel> measured() {
        for (std::size_t i = 0; i < m_hollows.size(); ++i)
            if (!m_hollows[i].opensOutside)
                towardsOutside(i);
        for (const auto& [apart, i, j] : pairsByBoxes())
            between(i, j, apart);
        std::vector<ThinSteel> all;
        for (const auto& [groups, steel] : m_thinnest)
            all.push_back(steel);
        std::stable_sort(all.begin(), all.end(),
                         [](const ThinSteel& a, const ThinSteel& b) { return a.thickness < b.thickness; });
        return all;
    }

private:
    static constexpr const char* outside = "outside";

    static Vector3d shift(const Hollow& hollow) { return {hollow.offset.x(), hollow.offset.y(), 0}; }
    static Vector3d pointOf(const Hollow& hollow, int v) { return hollow.mesh->point(v) + shift(hollow); }

    void note(const std::string& first, const std::string& second, ThinSteel steel) {
        const auto [at, isNew] = m_thinnest.try_emplace(std::minmax(first, second), steel);
        if (!isNew && steel.thickness < at->second.thickness)
            at->second = std::move(steel);
    }

    /// The block is convex and hollows have flat faces: the nearest place is a point. Of several the first.
    void towardsOutside(std::size_t i) {
        const Hollow& hollow = m_hollows[i];
        const std::vector<PointGroup>& groups = m_trees.groupsOf(hollow.mesh);
        std::vector<std::pair<double, const PointGroup*>> nearest;
        for (const PointGroup& group : groups)
            nearest.emplace_back(m_block.depthOf(group.box.translated(shift(hollow))), &group);
        std::sort(nearest.begin(), nearest.end());
        const double before = thinnestSoFar(m_groups[i], outside);
        std::pair<double, int> least{before, -1};
        for (const auto& [bound, group] : nearest)
            if (std::pair(bound, group->points.front()) < least)
                for (const int v : group->points)
                    least = std::min(least, {m_block.depthOf(pointOf(hollow, v)), v});
        if (least.first < before)
            note(m_groups[i], outside,
                 {least.first, pointOf(hollow, least.second), hollow.name, outside, hollow.number, 0});
    }

    /// Of two groups, or the furthest.
    [[nodiscard]] double thinnestSoFar(const std::string& first, const std::string& second) const {
        const auto known = m_thinnest.find(std::minmax(first, second));
        return known == m_thinnest.end() ? m_furthest : std::min(m_furthest, known->second.thickness);
    }

    /// All pairs to be compared, those first whose boxes are nearest: most others need no second look then.
    [[nodiscard]] std::vector<std::tuple<double, std::size_t, std::size_t>> pairsByBoxes() const {
        std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
        for (std::size_t i = 0; i < m_hollows.size(); ++i)
            for (std::size_t j = i + 1; j < m_hollows.size(); ++j) {
                const Hollow& a = m_hollows[i];
                const Hollow& b = m_hollows[j];
                const double apart = m_boxes[i].exteriorDistance(m_boxes[j]);
                if (!areJoined(a, b) && apart < m_furthest)
                    pairs.emplace_back(apart, i, j);
            }
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }

    void between(std::size_t i, std::size_t j, double apart) {
        const Hollow& a = m_hollows[i];
        const Hollow& b = m_hollows[j];
        ThinSteel least{thinnestSoFar(m_groups[i], m_groups[j]), {}, a.name, b.name, a.number, b.number};
        if (apart >= least.thickness)
            return;
        // Copies of the same two at the same distance have the same steel between them.
        const Eigen::Vector2d way = b.offset - a.offset;
        if (!m_done.insert({a.mesh.get(), b.mesh.get(), way.x(), way.y()}).second)
            return;
        const double before = least.thickness;
        if (apart == 0 && meet(a, b)) {
            least.thickness = 0;
            least.place = a.byHand ? m_boxes[i].center() : m_boxes[j].center();
        } else {
            fromPoints(a, b, m_boxes[j], least);
            fromPoints(b, a, m_boxes[i], least);
        }
        if (least.thickness < before)
            note(m_groups[i], m_groups[j], least);
    }

    /// Whether two solids have points in common.
    [[nodiscard]] bool meet(const Hollow& a, const Hollow& b) const {
        const bool aIsSmaller = a.mesh->faceCount() < b.mesh->faceCount();
        const Hollow& small = aIsSmaller ? a : b;
        const Hollow& large = aIsSmaller ? b : a;
        const Vector3d way = shift(small) - shift(large);
        const ClosestPoint& tree = m_trees.of(large.mesh);
        return tree.meets(*small.mesh, way) || tree.holds(small.mesh->point(0) + way) ||
               m_trees.of(small.mesh).holds(large.mesh->point(0) - way);
    }

    /// Points of one hollow against the faces of the other. Nearest to their box first: groups of points
    /// before their points, and most of both need no look once a few are known.
    void fromPoints(const Hollow& points, const Hollow& faces, const AlignedBox3d& box, ThinSteel& least) {
        const ClosestPoint& tree = m_trees.of(faces.mesh);
        const std::vector<PointGroup>& groups = m_trees.groupsOf(points.mesh);
        using Ahead = std::tuple<double, bool, int>; // least distance, whether a point, which point or group
        std::priority_queue<Ahead, std::vector<Ahead>, std::greater<>> ahead;
        const auto look = [&](double bound, bool isPoint, std::size_t which) {
            if (bound < least.thickness)
                ahead.emplace(bound, isPoint, static_cast<int>(which));
        };
        for (std::size_t g = 0; g < groups.size(); ++g)
            look(box.exteriorDistance(groups[g].box.translated(shift(points))), false, g);
        while (!ahead.empty() && std::get<double>(ahead.top()) < least.thickness) {
            stopPoint();
            const auto [bound, isPoint, which] = ahead.top();
            ahead.pop();
            if (!isPoint) {
                for (const int v : groups[static_cast<std::size_t>(which)].points)
                    look(box.exteriorDistance(pointOf(points, v)), true, static_cast<std::size_t>(v));
                continue;
            }
            const Vector3d p = pointOf(points, which);
            const double distance = tree.distance(p - shift(faces));
            if (distance < least.thickness) {
                least.thickness = distance;
                least.place = p;
            }
        }
    }

    const std::vector<Hollow>& m_hollows;
    const Block& m_block;
    double m_furthest;
    const SteelTrees& m_trees;
    std::vector<AlignedBox3d> m_boxes;
    std::vector<std::string> m_groups;
    std::map<std::pair<std::string, std::string>, ThinSteel> m_thinnest;
    std::set<std::tuple<const IndexedMesh*, const IndexedMesh*, double, double>> m_done;
};

} // namespace

bool areJoined(const Hollow& a, const Hollow& b) {
    return std::any_of(a.joints.begin(), a.joints.end(), [&](int joint) {
        return std::find(b.joints.begin(), b.joints.end(), joint) != b.joints.end();
    });
}

SteelTrees::SteelTrees() = default;
SteelTrees::~SteelTrees() = default;
SteelTrees::SteelTrees(SteelTrees&&) noexcept = default;
SteelTrees& SteelTrees::operator=(SteelTrees&&) noexcept = default;

void SteelTrees::prepare(const std::vector<Hollow>& hollows) {
    std::map<SharedMesh, std::unique_ptr<Known>> before = std::exchange(m_known, {});
    std::vector<SharedMesh> missing;
    for (const Hollow& hollow : hollows) {
        std::unique_ptr<Known>& known = m_known[hollow.mesh];
        if (known)
            continue;
        if (const auto kept = before.find(hollow.mesh); kept != before.end())
            known = std::move(kept->second);
        else if (std::find(missing.begin(), missing.end(), hollow.mesh) == missing.end())
            missing.push_back(hollow.mesh);
    }
    parallelFor(missing.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            m_known.at(missing[i]) =
                std::make_unique<Known>(Known{ClosestPoint(*missing[i]), groupsOfPoints(missing[i]->V)});
    });
}

std::vector<ThinSteel> thinnestSteel(const std::vector<Hollow>& hollows, const Block& block, double furthest,
                                     SteelTrees& trees) {
    trees.prepare(hollows);
    return SteelMeasure(hollows, block, furthest, trees).measured();
}

std::vector<ThinSteel> byNames(const std::vector<ThinSteel>& steel) {
    std::set<std::pair<std::string, std::string>> seen;
    std::vector<ThinSteel> thinnest;
    for (const ThinSteel& thin : steel)
        if (seen.insert(std::minmax(thin.first, thin.second)).second)
            thinnest.push_back(thin);
    return thinnest;
}

} // namespace moldwright
