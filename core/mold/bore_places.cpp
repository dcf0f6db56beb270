// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/bore_places.h"

#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace moldwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double flatForPins = 35;   // degrees from square to the hole
constexpr double flatForSpouts = 70; // a neck only has to end in the cavity
constexpr int samples = 16;

std::vector<int> facesOf(const CavityKind& kind, int side, std::optional<int> solid) {
    const std::vector<int> ofFace =
        solid ? connectedComponents(kind.cast).ofFace : std::vector<int>(kind.labels.size(), 0);
    std::vector<int> faces;
    for (std::size_t f = 0; f < kind.labels.size(); ++f)
        if (kind.labels[f] == side && ofFace[f] == solid.value_or(0))
            faces.push_back(static_cast<int>(f));
    return faces;
}

/// Deep, and as far from those chosen as the cast is wide for so many.
const BorePlace* bestBeside(const std::vector<BorePlace>& chosen, const std::vector<BorePlace>& candidates,
                            double apart, std::size_t wanted) {
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
        if (nearest < apart)
            continue;
        const double spread =
            std::min(1.0, nearest * static_cast<double>(wanted) / (1e-9 + box.diagonal().norm()));
        const double worth = spread * (0.5 + place.tip / deepest);
        if (worth > most) {
            most = worth;
            best = &place;
        }
    }
    return best;
}

} // namespace

BoreGround::BoreGround(const CavityKind& kind, const Directions& directions, const BoreNeeds& needs,
                       std::optional<int> solid)
    : m_needs(needs), m_dz(std::abs(directions.of(needs.side).z())),
      m_over(kind.cast, facesOf(kind, needs.side, solid), directions.of(needs.side)) {
    Eigen::AlignedBox2d box;
    for (const Vector2d& p : kind.hull)
        box.extend(p);
    constexpr int most = 60; // along either side
    const double step = std::max(needs.diameter / 3, box.sizes().maxCoeff() / most);
    for (double x = box.min().x(); x <= box.max().x(); x += step)
        for (double y = box.min().y(); y <= box.max().y(); y += step)
            if (const std::optional<BorePlace> place = at({x, y}))
                m_candidates.push_back(*place);
}

/// Height of the cast over a point of the plane, along the normal; 0 outside.
double BoreGround::heightAt(const Vector2d& p) const {
    return m_over.above({p.x(), p.y(), 0}) * m_dz;
}

std::optional<BorePlace> BoreGround::at(const Vector2d& axis) const {
    const double radius = m_needs.diameter / 2;
    double low = heightAt(axis);
    double high = low;
    if (low <= 0)
        return std::nullopt;
    for (int k = 0; k < samples; ++k) {
        const double angle = 2 * std::numbers::pi * k / samples;
        const Vector2d way(std::cos(angle), std::sin(angle));
        if (heightAt(axis + (radius + m_needs.margin) * way) <= 0)
            return std::nullopt;
        for (const double part : {0.5, 1.1}) {
            const double height = heightAt(axis + part * radius * way);
            low = std::min(low, height);
            high = std::max(high, height);
        }
    }
    const double flat = 2.2 * radius * std::tan(radians(m_needs.steepest));
    if (low <= 0 || high - low > flat)
        return std::nullopt;
    return BorePlace{axis, heightAt(axis), low / 2};
}

std::optional<BorePlace> BoreGround::highest() const {
    double most = 0;
    for (const BorePlace& place : m_candidates)
        most = std::max(most, place.inside);
    constexpr double equal = 0.99;
    Eigen::AlignedBox2d box;
    for (const BorePlace& place : m_candidates)
        if (place.inside >= equal * most)
            box.extend(place.axis);
    std::optional<BorePlace> best;
    for (const BorePlace& place : m_candidates)
        if (place.inside >= equal * most &&
            (!best || (place.axis - box.center()).norm() < (best->axis - box.center()).norm()))
            best = place;
    return best;
}

BoreGround ejectorGround(const CavityKind& kind, const Directions& directions,
                         const EjectorSettings& ejectors, double steel) {
    return {kind, directions, {ejectors.side, ejectors.diameter, steel, flatForPins}};
}

std::vector<BoreGround> spoutGrounds(const CavityKind& kind, const Directions& directions, double neck) {
    constexpr double margin = 0.2; // mm from the parting line
    std::vector<BoreGround> grounds;
    const int solids = connectedComponents(kind.cast).count;
    for (int solid = 0; solid < solids; ++solid)
        grounds.emplace_back(kind, directions, BoreNeeds{1, neck, margin, flatForSpouts}, solid);
    return grounds;
}

namespace {

using MaybePlaces = std::vector<std::optional<BorePlace>>;

Result<MaybePlaces> pinsByHand(const BoreGround& ground, const Wishes& wishes) {
    const BoreNeeds& needs = ground.needs();
    MaybePlaces places(wishes.size());
    for (std::size_t i = 0; i < wishes.size(); ++i) {
        if (!wishes[i])
            continue;
        places[i] = ground.at(*wishes[i]);
        if (!places[i])
            return failure(ErrorCode::Impossible,
                           MW_TEXT("Mold",
                                   "Ejector hole {0} cannot enter the cavity of half {1} there: a pin "
                                   "of {2} mm needs ground that is flat within 35°, {3} mm from the "
                                   "parting line."),
                           {std::to_string(i + 1), std::to_string(needs.side), readable(needs.diameter),
                            readable(needs.margin)});
    }
    return places;
}

std::unexpected<Error> tooFewPins(std::size_t found, std::size_t wanted, const BoreNeeds& needs) {
    return failure(ErrorCode::Impossible,
                   MW_TEXT("Mold",
                           "Only {0} of {1} ejector pins find a place in half {2}: a pin of {3} mm needs "
                           "ground that is flat within 35°, away from the parting line and the gate. Ask "
                           "for fewer or thinner pins, or the other half."),
                   {std::to_string(found), std::to_string(wanted), std::to_string(needs.side),
                    readable(needs.diameter)});
}

} // namespace

Result<std::vector<BorePlace>> ejectorPlaces(const BoreGround& ground, double steel,
                                             const std::vector<std::pair<Vector2d, double>>& keepOff,
                                             const Wishes& wishes) {
    Result<MaybePlaces> places = pinsByHand(ground, wishes);
    if (!places)
        return std::unexpected(places.error());
    std::vector<BorePlace> chosen;
    for (const std::optional<BorePlace>& place : *places)
        if (place)
            chosen.push_back(*place);
    const double diameter = ground.needs().diameter;
    std::vector<BorePlace> candidates = ground.candidates();
    std::erase_if(candidates, [&](const BorePlace& place) {
        return std::any_of(keepOff.begin(), keepOff.end(), [&](const auto& circle) {
            return (place.axis - circle.first).norm() < circle.second + diameter / 2 + steel;
        });
    });
    for (std::optional<BorePlace>& place : *places) {
        if (place)
            continue;
        const BorePlace* best = bestBeside(chosen, candidates, diameter + steel, wishes.size());
        if (best == nullptr)
            return tooFewPins(chosen.size(), wishes.size(), ground.needs());
        chosen.push_back(*best);
        place = *best;
    }
    std::vector<BorePlace> all;
    for (const std::optional<BorePlace>& place : *places)
        all.push_back(*place);
    return all;
}

Result<std::vector<BorePlace>> spoutPlaces(const std::vector<BoreGround>& grounds, const Wishes& wishes) {
    std::vector<BorePlace> all;
    for (std::size_t i = 0; i < grounds.size(); ++i) {
        const std::optional<BorePlace> place = wishes[i] ? grounds[i].at(*wishes[i]) : grounds[i].highest();
        if (!place && wishes[i])
            return failure(ErrorCode::Impossible,
                           MW_TEXT("Mold", "Spout {0} cannot enter its cavity there: its neck of {1} mm has "
                                           "no room, or the ground is steeper than 70°."),
                           {std::to_string(i + 1), readable(grounds[i].needs().diameter)});
        if (!place)
            return failure(ErrorCode::Impossible,
                           MW_TEXT("Mold",
                                   "A spout through half 1 finds no place: its neck of {0} mm has no room "
                                   "on the cavity there. Take a thinner neck, or let the mold stand."),
                           {readable(grounds[i].needs().diameter)});
        all.push_back(*place);
    }
    return all;
}

} // namespace moldwright
