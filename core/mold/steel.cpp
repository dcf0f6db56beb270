// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/steel.h"

#include "base/parallel.h"
#include "mesh/measures.h"

#include <algorithm>
#include <array>
#include <functional>
#include <map>
#include <memory>
#include <set>
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
        std::map<const IndexedMesh*, AlignedBox3d> boxes; // copies share their mesh
        for (const Hollow& hollow : hollows) {
            const auto [box, isNew] = boxes.try_emplace(hollow.mesh.get());
            if (isNew)
                box->second = boundingBox(*hollow.mesh);
            m_boxes.push_back(box->second.translated(shift(hollow)));
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
    static Vector3d shift(const Hollow& hollow) { return {hollow.offset.x(), hollow.offset.y(), 0}; }

    void note(const std::string& first, const std::string& second, ThinSteel steel) {
        const auto [at, isNew] = m_thinnest.try_emplace(std::minmax(first, second), steel);
        if (!isNew && steel.thickness < at->second.thickness)
            at->second = std::move(steel);
    }

    /// The block is convex and hollows have flat faces: the nearest place is a point.
    void towardsOutside(std::size_t i) {
        const Hollow& hollow = m_hollows[i];
        ThinSteel least{m_furthest, {}, hollow.name, "outside", hollow.number, 0};
        for (int v = 0; v < hollow.mesh->vertexCount(); ++v) {
            const Vector3d p = hollow.mesh->point(v) + shift(hollow);
            const double wall = m_block.depthOf(p);
            if (wall < least.thickness) {
                least.thickness = wall;
                least.place = p;
            }
        }
        if (least.thickness < m_furthest)
            note(m_groups[i], "outside", least);
    }

    /// Of their two groups, or the furthest.
    [[nodiscard]] double thinnestSoFar(std::size_t i, std::size_t j) const {
        const auto known = m_thinnest.find(std::minmax(m_groups[i], m_groups[j]));
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
        ThinSteel least{thinnestSoFar(i, j), {}, a.name, b.name, a.number, b.number};
        if (apart >= least.thickness)
            return;
        // Copies of the same two at the same distance have the same steel between them.
        const Eigen::Vector2d way = b.offset - a.offset;
        if (!m_done.insert({a.mesh.get(), b.mesh.get(), way.x(), way.y()}).second)
            return;
        const double before = least.thickness;
        if (apart == 0 && (a.byHand || b.byHand) && meet(a, b)) {
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

    /// Points of one hollow against the faces of the other.
    void fromPoints(const Hollow& points, const Hollow& faces, const AlignedBox3d& box, ThinSteel& least) {
        const ClosestPoint& tree = m_trees.of(faces.mesh);
        std::vector<std::pair<double, int>> near;
        for (int v = 0; v < points.mesh->vertexCount(); ++v) {
            const double bound = box.exteriorDistance(Vector3d(points.mesh->point(v) + shift(points)));
            if (bound < least.thickness)
                near.emplace_back(bound, v);
        }
        // Nearest first, and most need no look once a few are known.
        std::make_heap(near.begin(), near.end(), std::greater());
        for (auto end = near.end(); end != near.begin(); --end) {
            const auto [bound, v] = near.front();
            if (bound >= least.thickness)
                break;
            std::pop_heap(near.begin(), end, std::greater());
            const Vector3d p = points.mesh->point(v) + shift(points);
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
    std::map<SharedMesh, std::unique_ptr<ClosestPoint>> before = std::exchange(m_trees, {});
    std::vector<SharedMesh> missing;
    for (const Hollow& hollow : hollows) {
        std::unique_ptr<ClosestPoint>& tree = m_trees[hollow.mesh];
        if (tree)
            continue;
        if (const auto kept = before.find(hollow.mesh); kept != before.end())
            tree = std::move(kept->second);
        else if (std::find(missing.begin(), missing.end(), hollow.mesh) == missing.end())
            missing.push_back(hollow.mesh);
    }
    parallelFor(missing.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            m_trees.at(missing[i]) = std::make_unique<ClosestPoint>(*missing[i]);
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
