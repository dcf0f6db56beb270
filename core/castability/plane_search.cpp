// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/plane_search.h"

#include "base/parallel.h"
#include "castability/analysis.h"
#include "castability/directions.h"
#include "castability/energy.h"
#include "castability/minimize.h"
#include "mesh/decimate.h"
#include "mesh/measures.h"

#include <algorithm>
#include <numeric>
#include <random>

namespace moldwright {

namespace {

constexpr int kProxyFaces = 2000;
constexpr double kDistinctShare = 0.06; ///< of the part's extent along the normal
constexpr int kAxisSteps = 20;          ///< planes square to each axis that are always tried
constexpr double kSmallSide = 0.15;     ///< below this share of the volume a side counts as too small

/// A candidate on the way: in the frame of the scaled mesh.
struct Trial {
    MoldState state;
    double score = 0;
};

struct Search {
    const IndexedMesh& mesh; ///< diagonal 1, centred
    double tau;
    double maxTiltDegrees;
    bool normalDirections;
    double wholeVolume;
};

/// Factor up to 2 where nearly all of the volume lies on one side, and its derivative with respect to the
/// share above. A factor, so that a plane at which the part already passes (energy 0) is never worse for it.
std::pair<double, double> oneSidedness(double shareAbove) {
    const double smaller = std::min(shareAbove, 1 - shareAbove);
    const double missing = std::max(0.0, (kSmallSide - smaller) / kSmallSide);
    const double slope = missing > 0 ? (shareAbove < 0.5 ? -1 : 1) / kSmallSide : 0.0;
    return {1 + missing, slope};
}

double score(const Search& s, const MoldState& state, double energy) {
    if (energy == 0)
        return 0;
    return energy * oneSidedness(volumeAbove(s.mesh, state.plane) / s.wholeVolume).first;
}

std::vector<MoldState> samplePlanes(const IndexedMesh& mesh, int count, unsigned seed) {
    std::mt19937 random(seed);
    // Plain arithmetic on the generator's words: the library's distributions differ between platforms.
    const auto uniform = [&] { return (random() + 0.5) / 4294967296.0; };
    std::vector<MoldState> states;
    // Made parts stand square to their axes, and their seams are often near an end.
    for (int axis = 0; axis < 3; ++axis)
        for (int step = 1; step < kAxisSteps; ++step) {
            const double low = mesh.V.col(axis).minCoeff();
            const double high = mesh.V.col(axis).maxCoeff();
            const PartingPlane plane{Eigen::Vector3d::Unit(axis), low + (high - low) * step / kAxisSteps};
            states.push_back({plane, Directions::normalTo(plane)});
        }
    while (static_cast<int>(states.size()) < count) {
        const double z = 2 * uniform() - 1;
        const double angle = 2 * std::numbers::pi * uniform();
        const double r = std::sqrt(1 - z * z);
        PartingPlane plane{{r * std::cos(angle), r * std::sin(angle), z}, 0};
        const Eigen::VectorXd heights = mesh.V * plane.normal;
        const double low = heights.minCoeff();
        const double high = heights.maxCoeff();
        plane.offset = low + (high - low) * (0.1 + 0.8 * uniform());
        states.push_back({plane, Directions::normalTo(plane)});
    }
    return states;
}

/// Plane and directions as free numbers about a start: two tilts of the normal, the offset, two a direction.
/// Every value is allowed: d = normalize(n + r(c)·P·T·c) with P the projection along n, r(c) = tan(tilt
/// cap)/√(1+|c|²), so that d·n > 0 and the cap hold by construction.
class StateCoordinates {
public:
    StateCoordinates(const MoldState& start, const Search& search) : m_start(start), m_search(search) {
        const auto [x, y] = planeAxes(start.plane.normal);
        m_tangents << x, y;
        m_reach = std::tan(radians(search.maxTiltDegrees));
    }

    /// The start's own numbers; it has normal directions.
    [[nodiscard]] Eigen::VectorXd origin() const {
        return Eigen::VectorXd::Zero(m_search.normalDirections ? 3 : 7);
    }

    [[nodiscard]] MoldState state(const Eigen::VectorXd& x) const {
        MoldState s;
        s.plane.normal = (m_start.plane.normal + m_tangents * x.head<2>()).normalized();
        s.plane.offset = m_start.plane.offset + x[2];
        s.directions = Directions::normalTo(s.plane);
        if (!m_search.normalDirections) {
            s.directions.d1 = leaning(s.plane.normal, x.segment<2>(3)).normalized();
            s.directions.d2 = -leaning(s.plane.normal, x.segment<2>(5)).normalized();
        }
        return s;
    }

    /// Energy times one-sidedness, and its gradient.
    [[nodiscard]] double value(const Eigen::VectorXd& x, Eigen::VectorXd& gradient) const {
        const MoldState s = state(x);
        StateGradient e;
        const double energy = castabilityEnergy(m_search.mesh, s, m_search.tau, e);
        VolumeGradient v;
        const double above = volumeAbove(m_search.mesh, s.plane, &v);
        const auto [factor, slope] = oneSidedness(above / m_search.wholeVolume);
        const double dVolume = energy * slope / m_search.wholeVolume;

        Eigen::Vector3d gNormal = factor * e.normal + dVolume * v.normal;
        gradient.resize(x.size());
        gradient[2] = factor * e.offset + dVolume * v.offset;
        if (m_search.normalDirections) {
            gNormal += factor * (e.d1 - e.d2);
        } else {
            gNormal += pullBack(s.plane.normal, x.segment<2>(3), factor * e.d1, gradient.segment<2>(3));
            gNormal += pullBack(s.plane.normal, x.segment<2>(5), -factor * e.d2, gradient.segment<2>(5));
        }
        const Eigen::Vector3d& n = s.plane.normal;
        const double length = (m_start.plane.normal + m_tangents * x.head<2>()).norm();
        gradient.head<2>() = m_tangents.transpose() * (gNormal - n * n.dot(gNormal)) / length;
        return energy * factor;
    }

private:
    [[nodiscard]] Eigen::Vector3d leaning(const Eigen::Vector3d& n, const Eigen::Vector2d& c) const {
        const Eigen::Vector3d w = m_tangents * c;
        return n + m_reach / std::sqrt(1 + c.squaredNorm()) * (w - n * n.dot(w));
    }

    /// From the gradient g with respect to normalize(leaning(n, c)): writes that with respect to c, returns
    /// that to n.
    Eigen::Vector3d pullBack(const Eigen::Vector3d& n, const Eigen::Vector2d& c, const Eigen::Vector3d& g,
                             Eigen::Ref<Eigen::VectorXd> gradientC) const {
        const Eigen::Vector3d u = leaning(n, c);
        const Eigen::Vector3d d = u.normalized();
        const Eigen::Vector3d gu = (g - d * d.dot(g)) / u.norm();
        const double root = std::sqrt(1 + c.squaredNorm());
        const double r = m_reach / root;
        const Eigen::Vector3d w = m_tangents * c;
        const Eigen::Vector2d gw = m_tangents.transpose() * (gu - n * n.dot(gu));
        gradientC = r * gw - c * (r / (root * root) * c.dot(gw));
        return gu * (1 - r * n.dot(w)) - r * w * n.dot(gu);
    }

    MoldState m_start;
    const Search& m_search;
    Eigen::Matrix<double, 3, 2> m_tangents;
    double m_reach = 0;
};

/// Planes are distinct when they lean differently or cut at clearly different heights of the part.
bool distinct(const IndexedMesh& mesh, const MoldState& a, const MoldState& b) {
    const double cosine = a.plane.normal.dot(b.plane.normal);
    if (std::abs(cosine) < std::cos(radians(12)))
        return true;
    const Eigen::VectorXd heights = mesh.V * a.plane.normal;
    const double offset = cosine > 0 ? b.plane.offset : -b.plane.offset;
    return std::abs(a.plane.offset - offset) > kDistinctShare * (heights.maxCoeff() - heights.minCoeff());
}

/// The best trials that are distinct from each other, best first.
std::vector<Trial> bestDistinct(const IndexedMesh& mesh, std::vector<Trial> trials, std::size_t count) {
    std::stable_sort(trials.begin(), trials.end(),
                     [](const Trial& a, const Trial& b) { return a.score < b.score; });
    std::vector<Trial> kept;
    for (const Trial& trial : trials) {
        const bool isNew = std::all_of(kept.begin(), kept.end(), [&](const Trial& other) {
            return distinct(mesh, trial.state, other.state);
        });
        if (isNew)
            kept.push_back(trial);
        if (kept.size() == count)
            break;
    }
    return kept;
}

Trial refine(const Search& search, const Trial& start) {
    const StateCoordinates coordinates(start.state, search);
    MinimizeOptions options;
    options.iterations = 30;
    options.relativeDecrease = 1e-3;
    const Minimum best = minimize(
        [&](const Eigen::VectorXd& x, Eigen::VectorXd& gradient) { return coordinates.value(x, gradient); },
        coordinates.origin(), options);
    return {coordinates.state(best.x), best.value};
}

PlaneCandidate describe(const Search& full, const MoldState& scaled, const Eigen::Vector3d& centre,
                        double scale, double draftDegrees) {
    const DraftAnalysis analysis = analyzeDraft(full.mesh, scaled, draftDegrees, false);
    const double above = volumeAbove(full.mesh, scaled.plane) / full.wholeVolume;
    PlaneCandidate candidate{scaled, analysis.energy, analysis.violatingAreaFraction,
                             analysis.worstDraftDegrees, std::max(0.0, std::min(above, 1 - above))};
    candidate.state.plane.offset = scaled.plane.offset * scale + scaled.plane.normal.dot(centre);
    return candidate;
}

} // namespace

std::vector<PlaneCandidate> findPlanes(const IndexedMesh& mesh, const PlaneSearch& wanted, const Task& task) {
    const Eigen::AlignedBox3d box = boundingBox(mesh);
    const Eigen::Vector3d centre = box.center();
    const double scale = box.diagonal().norm();
    IndexedMesh scaled = mesh;
    scaled.V = (mesh.V.rowwise() - centre.transpose()) / scale;
    const IndexedMesh proxy = decimate(scaled, kProxyFaces);
    const double tau = std::sin(radians(wanted.draftDegrees));
    const Search search{proxy, tau, wanted.maxTiltDegrees, wanted.normalDirections, volume(proxy)};
    const Search full{scaled, tau, wanted.maxTiltDegrees, wanted.normalDirections, volume(scaled)};

    task.progress(0, "plane");
    const std::vector<MoldState> states = samplePlanes(proxy, wanted.samples, wanted.seed);
    std::vector<Trial> trials(states.size());
    parallelFor(states.size(), 16, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            trials[i] = {states[i], score(search, states[i], castabilityEnergy(proxy, states[i], tau))};
    });
    trials = bestDistinct(proxy, std::move(trials), static_cast<std::size_t>(wanted.count) + 12);
    std::vector<Trial> refined(trials.size());
    parallelFor(trials.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end && !task.stopped(); ++i) {
            refined[i] = refine(search, trials[i]);
            task.progress(0.2 + 0.8 * static_cast<double>(i) / static_cast<double>(trials.size()), "plane");
        }
    });
    // Starts that refinement led elsewhere are candidates of their own: there may be more planes asked for
    // than minima.
    refined.insert(refined.end(), trials.begin(), trials.end());
    for (const PartingPlane& plane : flatBackPlanes(scaled)) {
        MoldState state{plane, Directions::normalTo(plane)};
        if (!wanted.normalDirections)
            state.directions = bestDirections(scaled, plane, wanted.draftDegrees, wanted.maxTiltDegrees);
        refined.push_back({state, score(full, state, castabilityEnergy(scaled, state, tau))});
    }

    std::vector<PlaneCandidate> candidates;
    for (const Trial& trial : bestDistinct(proxy, std::move(refined), static_cast<std::size_t>(wanted.count)))
        candidates.push_back(describe(full, trial.state, centre, scale, wanted.draftDegrees));
    return candidates;
}

std::vector<PartingPlane> flatBackPlanes(const IndexedMesh& mesh) {
    const double size = diagonal(mesh);
    const double area = surfaceArea(mesh);
    std::vector<PartingPlane> planes;
    std::vector<char> used(static_cast<std::size_t>(mesh.faceCount()), 0);
    std::vector<int> order(used.size());
    std::iota(order.begin(), order.end(), 0);
    std::vector<double> areas(used.size());
    for (int f = 0; f < mesh.faceCount(); ++f)
        areas[static_cast<std::size_t>(f)] = doubleAreaVector(mesh, f).norm() / 2;
    std::stable_sort(order.begin(), order.end(), [&](int a, int b) {
        return areas[static_cast<std::size_t>(a)] > areas[static_cast<std::size_t>(b)];
    });
    // A patch of 1 % holds a face of its own mean size at least; a few large ones decide.
    const std::size_t tries = std::min<std::size_t>(order.size(), 400);
    for (std::size_t i = 0; i < tries; ++i) {
        const int seed = order[i];
        if (used[static_cast<std::size_t>(seed)] || !(areas[static_cast<std::size_t>(seed)] > 0))
            continue;
        PartingPlane plane{-doubleAreaVector(mesh, seed).normalized(), 0};
        const Eigen::VectorXd heights = mesh.V * plane.normal;
        plane.offset = plane.normal.dot(mesh.corner(seed, 0));
        const double tolerance = 1e-6 * size;
        if (heights.minCoeff() < plane.offset - tolerance)
            continue;
        double patch = 0;
        double highest = plane.offset;
        for (int f = 0; f < mesh.faceCount(); ++f) {
            const Eigen::Vector3d s(heights[mesh.F(f, 0)], heights[mesh.F(f, 1)], heights[mesh.F(f, 2)]);
            if (s.maxCoeff() > plane.offset + tolerance)
                continue;
            used[static_cast<std::size_t>(f)] = 1;
            patch += areas[static_cast<std::size_t>(f)];
            highest = std::max(highest, s.maxCoeff());
        }
        // At the highest of the patch's points none of its faces lies on side 1.
        plane.offset = highest;
        if (patch > 0.01 * area)
            planes.push_back(plane);
    }
    return planes;
}

double volumeAbove(const IndexedMesh& mesh, const PartingPlane& plane, VolumeGradient* gradient) {
    // ∫ max(s, 0) N·n dA over the surface: the divergence theorem on the part above, the cap adds nothing.
    // The derivatives are the section's area and first moment, from its boundary segments p→q.
    double sum = 0;
    double area = 0;
    Eigen::Vector3d moment = Eigen::Vector3d::Zero();
    for (int f = 0; f < mesh.faceCount(); ++f) {
        Eigen::Vector3d s;
        for (int k = 0; k < 3; ++k)
            s[k] = plane.distance(mesh.corner(f, k));
        if (s.maxCoeff() <= 0)
            continue;
        const double projected = doubleAreaVector(mesh, f).dot(plane.normal) / 2;
        const double mean = s.mean();
        if (s.minCoeff() >= 0) {
            sum += projected * mean;
            continue;
        }
        const bool oneAbove = (s.array() > 0).count() == 1;
        int u = 0;
        oneAbove ? s.maxCoeff(&u) : s.minCoeff(&u);
        const int v = (u + 1) % 3;
        const int w = (u + 2) % 3;
        const double tv = s[u] / (s[u] - s[v]);
        const double tw = s[u] / (s[u] - s[w]);
        const double corner = tv * tw * s[u] / 3;
        sum += projected * (oneAbove ? corner : mean - corner);
        const Eigen::Vector3d p = mesh.corner(f, u) + tv * (mesh.corner(f, v) - mesh.corner(f, u));
        const Eigen::Vector3d q = mesh.corner(f, u) + tw * (mesh.corner(f, w) - mesh.corner(f, u));
        const double piece = (oneAbove ? 0.5 : -0.5) * plane.normal.dot(p.cross(q));
        area += piece;
        moment += piece * (p + q) / 3;
    }
    if (gradient) {
        // Segments run about the section one way or the other; its area is positive.
        const double sign = area < 0 ? -1 : 1;
        gradient->offset = -sign * area;
        gradient->normal = sign * moment;
        // The moment of triangles from the origin's foot lacks their third corner, the foot point n·o.
        gradient->normal += sign * area * plane.offset / 3 * plane.normal;
    }
    return sum;
}

} // namespace moldwright
