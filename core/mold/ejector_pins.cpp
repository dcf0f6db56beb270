// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/ejector_pins.h"

#include "castability/overhang.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace moldwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double steepest = 35; // degrees from square to the pin
constexpr int samples = 16;

std::vector<int> facesOf(const SideLabels& labels, int side) {
    std::vector<int> faces;
    for (std::size_t f = 0; f < labels.size(); ++f)
        if (labels[f] == side)
            faces.push_back(static_cast<int>(f));
    return faces;
}

class PinPlacer {
public:
    PinPlacer(const CavityKind& kind, const Directions& directions, const EjectorSettings& ejectors,
              double steel)
        : m_kind(kind), m_d(directions.of(ejectors.side)), m_ejectors(ejectors), m_steel(steel),
          m_over(kind.cast, facesOf(kind.labels, ejectors.side), m_d) {}

    std::vector<EjectorPlace> places(const std::vector<std::pair<Vector2d, double>>& keepOff) {
        std::vector<EjectorPlace> candidates = candidatePlaces();
        std::erase_if(candidates, [&](const EjectorPlace& place) {
            return std::any_of(keepOff.begin(), keepOff.end(), [&](const auto& circle) {
                return (place.axis - circle.first).norm() < circle.second + m_ejectors.diameter / 2 + m_steel;
            });
        });
        std::vector<EjectorPlace> chosen;
        while (static_cast<int>(chosen.size()) < m_ejectors.count) {
            const EjectorPlace* best = bestBeside(chosen, candidates);
            if (best == nullptr)
                break;
            chosen.push_back(*best);
        }
        return chosen;
    }

private:
    /// Height of the cast over a point of the plane, along the normal; 0 outside.
    [[nodiscard]] double heightAt(const Vector2d& p) const {
        return m_over.above({p.x(), p.y(), 0}) * std::abs(m_d.z());
    }

    [[nodiscard]] std::vector<EjectorPlace> candidatePlaces() const {
        Eigen::AlignedBox2d box;
        for (const Vector2d& p : m_kind.hull)
            box.extend(p);
        constexpr int most = 60; // along either side
        const double step = std::max(m_ejectors.diameter / 3, box.sizes().maxCoeff() / most);
        std::vector<EjectorPlace> candidates;
        for (double x = box.min().x(); x <= box.max().x(); x += step)
            for (double y = box.min().y(); y <= box.max().y(); y += step)
                if (const std::optional<EjectorPlace> place = placeAt({x, y}))
                    candidates.push_back(*place);
        return candidates;
    }

    [[nodiscard]] std::optional<EjectorPlace> placeAt(const Vector2d& p) const {
        const double radius = m_ejectors.diameter / 2;
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
        const double flat = 2.2 * radius * std::tan(radians(steepest));
        if (low <= 0 || high - low > flat)
            return std::nullopt;
        return EjectorPlace{p, heightAt(p), low / 2};
    }

    /// Deep, and as far from the others as the cast is wide for so many.
    [[nodiscard]] const EjectorPlace* bestBeside(const std::vector<EjectorPlace>& chosen,
                                                 const std::vector<EjectorPlace>& candidates) const {
        Eigen::AlignedBox2d box;
        double deepest = 0;
        for (const EjectorPlace& place : candidates) {
            box.extend(place.axis);
            deepest = std::max(deepest, place.tip);
        }
        const EjectorPlace* best = nullptr;
        double most = 0;
        for (const EjectorPlace& place : candidates) {
            double nearest = box.diagonal().norm();
            for (const EjectorPlace& other : chosen)
                nearest = std::min(nearest, (place.axis - other.axis).norm());
            if (nearest < m_ejectors.diameter + m_steel)
                continue;
            const double spread = std::min(1.0, nearest * m_ejectors.count / (1e-9 + box.diagonal().norm()));
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
    const EjectorSettings& m_ejectors;
    double m_steel;
    Overhang m_over;
};

} // namespace

Result<std::vector<EjectorPlace>> ejectorPlaces(const CavityKind& kind, const Directions& directions,
                                                const EjectorSettings& ejectors, double steel,
                                                const std::vector<std::pair<Vector2d, double>>& keepOff) {
    std::vector<EjectorPlace> places = PinPlacer(kind, directions, ejectors, steel).places(keepOff);
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

} // namespace moldwright
