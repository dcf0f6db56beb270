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
        for (const Hollow& hollow : hollows) {
            if (!m_trees.contains(hollow.mesh.get()))
                m_trees.emplace(hollow.mesh.get(), std::make_unique<ClosestPoint>(*hollow.mesh));
            m_boxes.push_back(boundingBox(*hollow.mesh).translated(shift(hollow)));
        }
    }

    std::vector<ThinSteel> measured() {
        for (std::size_t i = 0; i < m_hollows.size(); ++i) {
            if (!m_hollows[i].opensOutside)
                towardsOutside(m_hollows[i]);
            for (std::size_t j = i + 1; j < m_hollows.size(); ++j)
                between(i, j);
        }
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

    void between(std::size_t i, std::size_t j) {
        const Hollow& a = m_hollows[i];
        const Hollow& b = m_hollows[j];
        const bool joined = std::any_of(a.joints.begin(), a.joints.end(), [&](int joint) {
            return std::find(b.joints.begin(), b.joints.end(), joint) != b.joints.end();
        });
        if (joined || m_boxes[i].exteriorDistance(m_boxes[j]) >= m_furthest)
            return;
        // Copies of the same two at the same distance have the same steel between them.
        const Eigen::Vector2d apart = b.offset - a.offset;
        if (!m_done.insert({a.mesh.get(), b.mesh.get(), apart.x(), apart.y()}).second)
            return;
        ThinSteel least{m_furthest, {}, {}, {}};
        fromPoints(a, b, m_boxes[j], least);
        fromPoints(b, a, m_boxes[i], least);
        if (least.thickness < m_furthest)
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
