// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/steel.h"

#include "base/parallel.h"
#include "mesh/closest_point.h"
#include "mesh/measures.h"

#include <algorithm>
#include <array>
#include <map>
#include <memory>
#include <set>

namespace moldwright {

namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

class SteelMeasure {
public:
    SteelMeasure(const std::vector<Hollow>& hollows, const Block& block, double furthest)
        : m_hollows(hollows), m_block(block), m_furthest(furthest) {
        std::vector<const IndexedMesh*> meshes;
        for (const Hollow& hollow : hollows) {
            if (m_trees.try_emplace(hollow.mesh.get()).second)
                meshes.push_back(hollow.mesh.get());
            m_boxes.push_back(boundingBox(*hollow.mesh).translated(shift(hollow)));
        }
        parallelFor(meshes.size(), 1, [&](std::size_t begin, std::size_t end) {
            for (std::size_t i = begin; i < end; ++i)
                m_trees.at(meshes[i]) = std::make_unique<ClosestPoint>(*meshes[i]);
        });
    }

    std::vector<ThinSteel> measured() {
        for (const Hollow& hollow : m_hollows)
            if (!hollow.opensOutside)
                towardsOutside(hollow);
        for (const auto& [apart, i, j] : pairsByBoxes())
            between(i, j, apart);
        std::vector<ThinSteel> all;
        for (const auto& [names, steel] : m_thinnest)
            all.push_back(steel);
        std::stable_sort(all.begin(), all.end(),
                         [](const ThinSteel& a, const ThinSteel& b) { return a.thickness < b.thickness; });
        return all;
    }

private:
    static Vector3d shift(const Hollow& hollow) { return {hollow.offset.x(), hollow.offset.y(), 0}; }

    void note(double thickness, const Vector3d& place, const std::string& first, const std::string& second) {
        const auto key = std::minmax(first, second);
        const auto [at, isNew] = m_thinnest.try_emplace(key, ThinSteel{thickness, place, first, second});
        if (!isNew && thickness < at->second.thickness)
            at->second = {thickness, place, first, second};
    }

    /// The block is convex and hollows have flat faces: the nearest place is a point.
    void towardsOutside(const Hollow& hollow) {
        ThinSteel least{m_furthest, {}, {}, {}};
        for (int v = 0; v < hollow.mesh->vertexCount(); ++v) {
            const Vector3d p = hollow.mesh->point(v) + shift(hollow);
            const double wall = std::min((p - m_block.min()).minCoeff(), (m_block.max() - p).minCoeff());
            if (wall < least.thickness)
                least = {wall, p, {}, {}};
        }
        if (least.thickness < m_furthest)
            note(least.thickness, least.place, hollow.name, "outside");
    }

    /// Of their two names, or the furthest.
    [[nodiscard]] double thinnestSoFar(const Hollow& a, const Hollow& b) const {
        const auto known = m_thinnest.find(std::minmax(a.name, b.name));
        return known == m_thinnest.end() ? m_furthest : std::min(m_furthest, known->second.thickness);
    }

    /// All pairs to be compared, those first whose boxes are nearest: most others need no second look then.
    [[nodiscard]] std::vector<std::tuple<double, std::size_t, std::size_t>> pairsByBoxes() const {
        std::vector<std::tuple<double, std::size_t, std::size_t>> pairs;
        for (std::size_t i = 0; i < m_hollows.size(); ++i)
            for (std::size_t j = i + 1; j < m_hollows.size(); ++j) {
                const Hollow& a = m_hollows[i];
                const Hollow& b = m_hollows[j];
                const bool joined = std::any_of(a.joints.begin(), a.joints.end(), [&](int joint) {
                    return std::find(b.joints.begin(), b.joints.end(), joint) != b.joints.end();
                });
                const double apart = m_boxes[i].exteriorDistance(m_boxes[j]);
                if (!joined && apart < m_furthest)
                    pairs.emplace_back(apart, i, j);
            }
        std::sort(pairs.begin(), pairs.end());
        return pairs;
    }

    void between(std::size_t i, std::size_t j, double apart) {
        const Hollow& a = m_hollows[i];
        const Hollow& b = m_hollows[j];
        ThinSteel least{thinnestSoFar(a, b), {}, {}, {}};
        if (apart >= least.thickness)
            return;
        // Copies of the same two at the same distance have the same steel between them.
        const Eigen::Vector2d way = b.offset - a.offset;
        if (!m_done.insert({a.mesh.get(), b.mesh.get(), way.x(), way.y()}).second)
            return;
        const double before = least.thickness;
        fromPoints(a, b, m_boxes[j], least);
        fromPoints(b, a, m_boxes[i], least);
        if (least.thickness < before)
            note(least.thickness, least.place, a.name, b.name);
    }

    /// Points of one hollow against the faces of the other.
    void fromPoints(const Hollow& points, const Hollow& faces, const AlignedBox3d& box, ThinSteel& least) {
        const ClosestPoint& tree = *m_trees.at(faces.mesh.get());
        std::vector<std::pair<double, int>> near;
        for (int v = 0; v < points.mesh->vertexCount(); ++v) {
            const double bound = box.exteriorDistance(Vector3d(points.mesh->point(v) + shift(points)));
            if (bound < least.thickness)
                near.emplace_back(bound, v);
        }
        std::sort(near.begin(), near.end());
        for (const auto& [bound, v] : near) {
            if (bound >= least.thickness)
                break;
            const Vector3d p = points.mesh->point(v) + shift(points);
            const double distance = tree.distance(p - shift(faces));
            if (distance < least.thickness)
                least = {distance, p, {}, {}};
        }
    }

    const std::vector<Hollow>& m_hollows;
    const Block& m_block;
    double m_furthest;
    std::map<const IndexedMesh*, std::unique_ptr<ClosestPoint>> m_trees;
    std::vector<AlignedBox3d> m_boxes;
    std::map<std::pair<std::string, std::string>, ThinSteel> m_thinnest;
    std::set<std::tuple<const IndexedMesh*, const IndexedMesh*, double, double>> m_done;
};

} // namespace

std::vector<ThinSteel> thinnestSteel(const std::vector<Hollow>& hollows, const Block& block,
                                     double furthest) {
    return SteelMeasure(hollows, block, furthest).measured();
}

} // namespace moldwright
