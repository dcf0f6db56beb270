// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/bore_places.h"

#include "castability/overhang.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace moldwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double flatForPins = 35;   // degrees from square to the hole
constexpr double flatForSpouts = 70; // a neck only has to end in the cavity
constexpr int samples = 16;

std::vector<int> facesOf(const SideLabels& labels, int side) {
    std::vector<int> faces;
    for (std::size_t f = 0; f < labels.size(); ++f)
        if (labels[f] == side)
            faces.push_back(static_cast<int>(f));
    return faces;
}

class BorePlacer {
public:
    /// `wanted`: how many, how wide, in which half; `faces`: of the cavity in that half.
    BorePlacer(const CavityKind& kind, const std::vector<int>& faces, const Directions& directions,
               const EjectorSettings& wanted, double steel, double steepest)
        : m_kind(kind), m_d(directions.of(wanted.side)), m_wanted(wanted), m_steel(steel),
          m_steepest(steepest), m_over(kind.cast, faces, m_d) {}

    std::vector<BorePlace> places(const std::vector<std::pair<Vector2d, double>>& keepOff) {
        std::vector<BorePlace> candidates = candidatePlaces();
        std::erase_if(candidates, [&](const BorePlace& place) {
            return std::any_of(keepOff.begin(), keepOff.end(), [&](const auto& circle) {
                return (place.axis - circle.first).norm() < circle.second + m_wanted.diameter / 2 + m_steel;
            });
        });
        std::vector<BorePlace> chosen;
        while (static_cast<int>(chosen.size()) < m_wanted.count) {
            const BorePlace* best = bestBeside(chosen, candidates);
            if (best == nullptr)
                break;
            chosen.push_back(*best);
        }
        return chosen;
    }

    /// Where the cast is highest under the whole circle; of equals the one nearest to their middle.
    [[nodiscard]] std::optional<BorePlace> highest() const {
        const std::vector<BorePlace> candidates = candidatePlaces();
        double most = 0;
        for (const BorePlace& place : candidates)
            most = std::max(most, place.inside);
        constexpr double equal = 0.99;
        Eigen::AlignedBox2d box;
        for (const BorePlace& place : candidates)
            if (place.inside >= equal * most)
                box.extend(place.axis);
        std::optional<BorePlace> best;
        for (const BorePlace& place : candidates)
            if (place.inside >= equal * most &&
                (!best || (place.axis - box.center()).norm() < (best->axis - box.center()).norm()))
                best = place;
        return best;
    }

private:
    /// Height of the cast over a point of the plane, along the normal; 0 outside.
    [[nodiscard]] double heightAt(const Vector2d& p) const {
        return m_over.above({p.x(), p.y(), 0}) * std::abs(m_d.z());
    }

    [[nodiscard]] std::vector<BorePlace> candidatePlaces() const {
        Eigen::AlignedBox2d box;
        for (const Vector2d& p : m_kind.hull)
            box.extend(p);
        constexpr int most = 60; // along either side
        const double step = std::max(m_wanted.diameter / 3, box.sizes().maxCoeff() / most);
        std::vector<BorePlace> candidates;
        for (double x = box.min().x(); x <= box.max().x(); x += step)
            for (double y = box.min().y(); y <= box.max().y(); y += step)
                if (const std::optional<BorePlace> place = placeAt({x, y}))
                    candidates.push_back(*place);
        return candidates;
    }

    [[nodiscard]] std::optional<BorePlace> placeAt(const Vector2d& p) const {
        const double radius = m_wanted.diameter / 2;
        double low = heightAt(p);
        double high = low;
        if (low <= 0)
            return std::nullopt;
        for (int k = 0; k < samples; ++k) {
            const double angle = 2 * std::numbers::pi * k / samples;
            const Vector2d way(std::cos(angle), std::sin(angle));
            if (heightAt(p + (radius + m_steel) * way) <= 0)
                return std::nullopt;
            for (const double part : {0.5, 1.1}) {
                const double height = heightAt(p + part * radius * way);
                low = std::min(low, height);
                high = std::max(high, height);
            }
        }
        const double flat = 2.2 * radius * std::tan(radians(m_steepest));
        if (low <= 0 || high - low > flat)
            return std::nullopt;
        return BorePlace{p, heightAt(p), low / 2};
    }

    /// Deep, and as far from the others as the cast is wide for so many.
    [[nodiscard]] const BorePlace* bestBeside(const std::vector<BorePlace>& chosen,
                                              const std::vector<BorePlace>& candidates) const {
        Eigen::AlignedBox2d box;
        double deepest = 0;
        for (const BorePlace& place : candidates) {
            box.extend(place.axis);
            deepest = std::max(deepest, place.tip);
        }
        const BorePlace* best = nullptr;
        double most = 0;
        for (const BorePlace& place : candidates) {
            double nearest = box.diagonal().norm();
            for (const BorePlace& other : chosen)
                nearest = std::min(nearest, (place.axis - other.axis).norm());
            if (nearest < m_wanted.diameter + m_steel)
                continue;
            const double spread = std::min(1.0, nearest * m_wanted.count / (1e-9 + box.diagonal().norm()));
            const double worth = spread * (0.5 + place.tip / deepest);
            if (worth > most) {
                most = worth;
                best = &place;
            }
        }
        return best;
    }

    const CavityKind& m_kind;
    Vector3d m_d;
    EjectorSettings m_wanted;
    double m_steel;
    double m_steepest;
    Overhang m_over;
};

} // namespace

Result<std::vector<BorePlace>> ejectorPlaces(const CavityKind& kind, const Directions& directions,
                                             const EjectorSettings& ejectors, double steel,
                                             const std::vector<std::pair<Vector2d, double>>& keepOff) {
    std::vector<BorePlace> places =
        BorePlacer(kind, facesOf(kind.labels, ejectors.side), directions, ejectors, steel, flatForPins)
            .places(keepOff);
    if (static_cast<int>(places.size()) < ejectors.count)
        return failure(ErrorCode::Impossible,
                       MW_TEXT("Mold",
                               "Only {0} of {1} ejector pins find a place in half {2}: a pin of {3} mm needs "
                               "ground that is flat within 35°, away from the parting line and the gate. Ask "
                               "for fewer or thinner pins, or the other half."),
                       {std::to_string(places.size()), std::to_string(ejectors.count),
                        std::to_string(ejectors.side), readable(ejectors.diameter)});
    return places;
}

Result<std::vector<BorePlace>> spoutPlaces(const CavityKind& kind, const Directions& directions,
                                           double width) {
    const Components solids = connectedComponents(kind.cast);
    std::vector<BorePlace> all;
    for (int solid = 0; solid < solids.count; ++solid) {
        std::vector<int> faces = facesOf(kind.labels, 1);
        std::erase_if(faces, [&](int f) { return solids.ofFace[static_cast<std::size_t>(f)] != solid; });
        constexpr double margin = 0.2; // mm from the parting line
        const std::optional<BorePlace> highest =
            BorePlacer(kind, faces, directions, {1, width, 1}, margin, flatForSpouts).highest();
        if (!highest)
            return failure(ErrorCode::Impossible,
                           MW_TEXT("Mold",
                                   "A spout through half 1 finds no place: its neck of {0} mm has no room "
                                   "on the cavity there. Take a thinner neck, or let the mold stand."),
                           {readable(width)});
        all.push_back(*highest);
    }
    return all;
}

} // namespace moldwright
