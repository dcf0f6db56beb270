// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/contact_ways.h"

#include "base/parallel.h"
#include "castability/faces_along.h"
#include "mesh/measures.h"

#include <algorithm>
#include <functional>
#include <numeric>
#include <utility>

namespace moldwright {

namespace {

using Stretches = std::vector<ContactWays::Stretch>;
using Eigen::Vector3d;

constexpr std::size_t grain = 2048;
constexpr double sameSurface = 1e-5; ///< of the size: surfaces nearer touch

/// A place where the line behind a point, against the way of the half, goes into or out of a solid.
struct Border {
    double way;
    bool inwards; ///< seen on the way backwards
};

/// A solid as it is met by lines against a direction.
class Solid {
public:
    Solid(const IndexedMesh& mesh, const Vector3d& d) : m_faces(mesh, all(mesh), d) {}

    /// The borders at more than `least` mm behind p, the farthest first.
    [[nodiscard]] std::vector<Border> behind(const Vector3d& p, double least) const {
        thread_local std::vector<FacesAlong::Crossing> found;
        m_faces.crossings(p, found);
        std::vector<Border> borders;
        for (const FacesAlong::Crossing& crossing : found)
            if (-crossing.way > least)
                borders.push_back({-crossing.way, crossing.along});
        std::ranges::sort(borders, std::greater(), &Border::way);
        // An edge is met once for each of its faces.
        const auto same = [&](const Border& a, const Border& b) {
            return a.inwards == b.inwards && a.way - b.way < 1e-3 * least;
        };
        borders.erase(std::unique(borders.begin(), borders.end(), same), borders.end());
        return borders;
    }

private:
    static std::vector<int> all(const IndexedMesh& mesh) {
        std::vector<int> faces(static_cast<std::size_t>(mesh.faceCount()));
        std::iota(faces.begin(), faces.end(), 0);
        return faces;
    }

    FacesAlong m_faces;
};

/// The stretches inside the solid of these borders. The line comes from outside, far behind.
Stretches insideOf(const std::vector<Border>& borders, double shortest) {
    Stretches found;
    int depth = 0; // counted, since borders that touch come in any order
    for (std::size_t i = 0; i < borders.size(); ++i) {
        depth += borders[i].inwards ? -1 : 1;
        const double to = borders[i].way;
        const double from = i + 1 < borders.size() ? borders[i + 1].way : 0;
        if (depth > 0 && to - from > shortest)
            found.push_back({from, to});
    }
    return found;
}

} // namespace

ContactWays::ContactWays(const std::vector<std::vector<Stretch>>& ofFaces) : m_first(1, 0) {
    for (const std::vector<Stretch>& stretches : ofFaces) {
        m_stretches.insert(m_stretches.end(), stretches.begin(), stretches.end());
        m_first.push_back(m_stretches.size());
    }
}

bool ContactWays::touches(std::size_t face, double way) const {
    if (face + 1 >= m_first.size())
        return false;
    const auto begin = m_stretches.begin();
    return std::any_of(begin + static_cast<std::ptrdiff_t>(m_first[face]),
                       begin + static_cast<std::ptrdiff_t>(m_first[face + 1]),
                       [&](const Stretch& stretch) { return stretch.from < way && way < stretch.to; });
}

ContactWays contactWays(const Points& middles, const IndexedMesh& half, const Vector3d& d) {
    const Solid solid(half, d);
    const double touching = sameSurface * diagonal(half);
    std::vector<Stretches> found(static_cast<std::size_t>(middles.rows()));
    parallelFor(found.size(), grain, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            const Vector3d middle = middles.row(static_cast<Eigen::Index>(f)).transpose();
            found[f] = insideOf(solid.behind(middle, touching), touching);
        }
    });
    return ContactWays(found);
}

} // namespace moldwright
