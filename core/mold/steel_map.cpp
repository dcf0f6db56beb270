// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/steel_map.h"

#include "base/parallel.h"
#include "base/stop_point.h"
#include "castability/certificate.h"
#include "mesh/finer_faces.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <utility>

namespace moldwright {

namespace {

using Eigen::AlignedBox3d;
using Eigen::Vector3d;

constexpr int noHollow = -1;

/// The hollows of a mold, each where it stands.
class Hollows {
public:
    explicit Hollows(const Mold& mold) : m_mold(mold) {
        m_trees.prepare(mold.hollows);
        for (const Hollow& hollow : mold.hollows)
            m_boxes.push_back(boundingBox(*hollow.mesh).translated(shift(hollow)));
    }

    /// The hollow whose surface is nearest to a place, and nearer than `limit` mm.
    [[nodiscard]] int nearest(const Vector3d& p, double limit) const {
        int best = noHollow;
        double least = limit;
        for (std::size_t i = 0; i < m_boxes.size(); ++i)
            if (const auto closer = distanceBelow(i, p, least)) {
                least = *closer;
                best = static_cast<int>(i);
            }
        return best;
    }

    /// Steel about a place on the wall of a hollow, `furthest` mm at most.
    [[nodiscard]] double steelAt(const Vector3d& p, int hollow, double furthest) const {
        const Hollow& own = m_mold.hollows[static_cast<std::size_t>(hollow)];
        double least = furthest;
        if (!own.opensOutside)
            least = std::clamp(m_mold.block.depthOf(p), 0.0, furthest);
        for (std::size_t i = 0; i < m_boxes.size(); ++i)
            if (static_cast<int>(i) != hollow && !areJoined(own, m_mold.hollows[i]))
                if (const auto closer = distanceBelow(i, p, least))
                    least = *closer;
        return least;
    }

private:
    static Vector3d shift(const Hollow& hollow) { return {hollow.offset.x(), hollow.offset.y(), 0}; }

    [[nodiscard]] std::optional<double> distanceBelow(std::size_t i, const Vector3d& p, double limit) const {
        if (m_boxes[i].exteriorDistance(p) >= limit)
            return std::nullopt;
        const Hollow& hollow = m_mold.hollows[i];
        const double distance = m_trees.of(hollow.mesh).distance(p - shift(hollow));
        return distance < limit ? std::optional(distance) : std::nullopt;
    }

    const Mold& m_mold;
    SteelTrees m_trees;
    std::vector<AlignedBox3d> m_boxes;
};

Vector3d middleOf(const IndexedMesh& mesh, int f) {
    return (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
}

/// The hollow that a face is a wall of. None is one of the outside, of a key, which stands beyond the plane,
/// and in the plane what does not close a hollow of the other half.
int hollowOf(const Mold& mold, const Hollows& hollows, const Vector3d& middle, int side, double touching) {
    const double height = side == 1 ? middle.z() : -middle.z();
    if (height < 0 || mold.block.depthOf(middle) <= touching)
        return noHollow;
    return hollows.nearest(middle, height > 0 ? std::numeric_limits<double>::infinity() : touching);
}

constexpr std::size_t grain = 1024;

/// Of each face of the half the hollow that it is a wall of.
std::vector<int> hollowsOf(const Mold& mold, const Hollows& hollows, const IndexedMesh& half, int side) {
    const double touching = 16 * onPlaneTolerance(half);
    std::vector<int> owner(static_cast<std::size_t>(half.faceCount()), noHollow);
    parallelFor(owner.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            owner[f] = hollowOf(mold, hollows, middleOf(half, static_cast<int>(f)), side, touching);
    });
    return owner;
}

/// Half a class, or as fine as a bounded number of faces allows.
double longestEdge(const IndexedMesh& half, const std::vector<int>& owner, double step) {
    constexpr double mostFaces = 200000;
    double area = 0;
    for (int f = 0; f < half.faceCount(); ++f)
        if (owner[static_cast<std::size_t>(f)] != noHollow)
            area += doubleAreaVector(half, f).norm() / 2;
    return std::max(step / 2, std::sqrt(area / mostFaces));
}

/// A corner of a face as a place on the wall of one hollow; faces beside each other share most.
using WallPlace = std::pair<int, int>; // point, hollow

std::vector<double> steelOfFaces(const Hollows& hollows, const IndexedMesh& surface,
                                 const std::vector<int>& owner, double furthest, const Task& task) {
    std::vector<WallPlace> places;
    for (int f = 0; f < surface.faceCount(); ++f)
        if (const int hollow = owner[static_cast<std::size_t>(f)]; hollow != noHollow)
            for (int k = 0; k < 3; ++k)
                places.emplace_back(surface.F(f, k), hollow);
    std::sort(places.begin(), places.end());
    places.erase(std::unique(places.begin(), places.end()), places.end());
    std::vector<double> steel(places.size(), furthest);
    parallelFor(places.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && !task.stopped(); ++i)
            steel[i] = hollows.steelAt(surface.point(places[i].first), places[i].second, furthest);
    });
    std::vector<double> ofFaces(owner.size(), -1);
    for (int f = 0; f < surface.faceCount(); ++f) {
        const int hollow = owner[static_cast<std::size_t>(f)];
        if (hollow == noHollow)
            continue;
        double least = furthest;
        for (int k = 0; k < 3; ++k) {
            const WallPlace place(surface.F(f, k), hollow);
            const auto at = std::lower_bound(places.begin(), places.end(), place) - places.begin();
            least = std::min(least, steel[static_cast<std::size_t>(at)]);
        }
        ofFaces[static_cast<std::size_t>(f)] = least;
    }
    return ofFaces;
}

void sumUp(SteelMap& map) {
    map.least = map.beyond();
    for (int f = 0; f < map.surface->faceCount(); ++f) {
        const double thickness = map.thickness[static_cast<std::size_t>(f)];
        if (thickness < 0)
            continue;
        map.areas.at(static_cast<std::size_t>(map.scale.classOf(thickness))) +=
            doubleAreaVector(*map.surface, f).norm() / 2;
        if (thickness < map.least) {
            map.least = thickness;
            map.leastPlace = middleOf(*map.surface, f);
        }
    }
}

} // namespace

int SteelScale::classOf(double thickness) const {
    if (thickness < limit)
        return 0;
    return static_cast<int>(std::clamp(1 + std::floor((thickness - limit) / step()), 1.0, classes - 1.0));
}

namespace {

SteelMap measuredMap(const Mold& mold, int side, const Task& task) {
    const IndexedMesh& half = *(side == 1 ? mold.half1 : mold.half2).mesh;
    SteelMap map;
    map.scale.limit = mold.settings.leastSteel;
    const Hollows hollows(mold);
    const std::vector<int> owner = hollowsOf(mold, hollows, half, side);
    std::vector<char> isWall;
    for (const int hollow : owner)
        isWall.push_back(hollow != noHollow ? 1 : 0);
    FinerMesh finer = withFinerFaces(half, isWall, longestEdge(half, owner, map.scale.step()));
    std::vector<int> ownerOfPart;
    for (const int f : finer.from)
        ownerOfPart.push_back(owner[static_cast<std::size_t>(f)]);
    map.surface = std::make_shared<const IndexedMesh>(std::move(finer.mesh));
    map.thickness = steelOfFaces(hollows, *map.surface, ownerOfPart, map.beyond(), task);
    stopPoint();
    sumUp(map);
    return map;
}

} // namespace

Result<SteelMap> steelMap(const Mold& mold, int side, const Task& task) {
    std::optional<SteelMap> map = unlessStopped(task, [&] { return measuredMap(mold, side, task); });
    if (!map)
        return failure(ErrorCode::Cancelled, MW_TEXT("Mold", "Measuring the steel was cancelled."));
    return *std::move(map);
}

} // namespace moldwright
