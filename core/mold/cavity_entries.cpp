// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/cavity_entries.h"

#include "mesh/measures.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// The point of the cast nearest to a place seen along the normal, on the side that `like` is on.
int nearestInPlan(const IndexedMesh& cast, const Vector2d& place, double like) {
    int nearest = -1;
    double least = 0;
    for (int v = 0; v < cast.vertexCount(); ++v) {
        if ((cast.V(v, 2) >= 0) != (like >= 0))
            continue;
        const double away = (cast.V.row(v).head<2>().transpose() - place).squaredNorm();
        if (nearest < 0 || away < least) {
            nearest = v;
            least = away;
        }
    }
    return nearest;
}

/// Finds the entries of one kind after the other; numbers go on from kind to kind.
class EntryFinder {
public:
    EntryFinder(const CavityShapes& shapes, const EntryPlan& plan)
        : m_shapes(shapes), m_plan(plan), m_settings(*plan.settings) {}

    Result<CavityFeatures> ofKind(std::size_t kind) {
        m_found = {};
        const CavityKind& cavity = m_shapes.kinds[kind];
        std::vector<int> drains;
        if (m_settings.spout.on) {
            Result<std::vector<int>> found = m_settings.spout.resting == Resting::Standing
                                                 ? findGates(kind)
                                                 : findSpouts(cavity, m_shapes.spoutGrounds[kind]);
            if (!found)
                return std::unexpected(found.error());
            drains = *std::move(found);
        }
        if (m_settings.vents.on) {
            if (Result<void> done = findTraps(cavity, drains); !done)
                return std::unexpected(done.error());
        } else if (m_settings.overflows.count > 0 || m_plan.tellsAir)
            m_found.unvented = trapsOf(cavity.cast, drains, m_plan.up, m_settings.vents.smallestTrap);
        if (m_settings.ejectors.count > 0)
            if (Result<void> done = findPins(kind); !done)
                return std::unexpected(done.error());
        return std::move(m_found);
    }

private:
    /// `number`: of the kind.
    Result<std::vector<int>> findGates(std::size_t number) {
        const CavityKind& kind = m_shapes.kinds[number];
        m_found.gates = gatesAtInlet(kind, m_plan.gate);
        const bool spouts = !m_plan.cavityAt.empty();
        for (std::size_t i = 0; i < m_found.gates.size(); ++i) {
            const int spout = m_found.gates[i].number = spouts ? m_spouts++ : static_cast<int>(i);
            if (!spouts)
                continue;
            const auto wish = placeByHand(m_settings.placed, Placeable::Spout, spout);
            if (!wish)
                continue;
            Result<Gate> gate = gateAt(kind.outlines, static_cast<int>(i),
                                       wish->x() - m_plan.cavityAt[number].x(), m_plan.gate);
            if (!gate)
                return std::unexpected(gate.error());
            m_found.gates[i] = *std::move(gate);
            m_found.gates[i].number = spout;
        }
        return drainsOf(m_found.gates);
    }

    Result<std::vector<int>> findSpouts(const CavityKind& kind, const std::vector<BoreGround>& grounds) {
        Wishes wishes;
        for (std::size_t i = 0; i < grounds.size(); ++i)
            wishes.push_back(
                placeByHand(m_settings.placed, Placeable::Spout, m_spouts + static_cast<int>(i)));
        const Result<std::vector<BorePlace>> places = spoutPlaces(grounds, wishes);
        if (!places)
            return std::unexpected(places.error());
        std::vector<int> drains;
        for (const BorePlace& place : *places) {
            HalfBore bore = spoutThrough(place);
            const Vector3d entry = bore.at(place.tip, m_plan.directions.d1);
            Eigen::Index nearest = 0;
            (kind.cast.V.rowwise() - entry.transpose()).rowwise().squaredNorm().minCoeff(&nearest);
            drains.push_back(static_cast<int>(nearest));
            m_found.bores.push_back(std::move(bore));
        }
        return drains;
    }

    /// Thinnest where it meets the cavity; from there on it widens, so that it can be pushed out.
    HalfBore spoutThrough(const BorePlace& place) {
        const SpoutSettings& spout = m_settings.spout;
        const double neck = spout.neck / 2;
        const double full = std::max(spout.diameter / 2, neck + 0.5);
        constexpr double neckLength = 1; // mm
        HalfBore bore{HalfBore::Use::Spout,
                      1,
                      place.axis,
                      {},
                      std::tan(radians(m_plan.channelDraft)),
                      place.tip,
                      m_spouts++};
        bore.stations = {{place.inside, 0.8 * neck},
                         {place.tip, neck},
                         {place.tip + neckLength, neck + 0.2},
                         {place.tip + neckLength + full - neck, full},
                         {0, full}};
        return bore;
    }

    Result<void> findTraps(const CavityKind& kind, const std::vector<int>& drains) {
        for (AirTrap& trap : trapsOf(kind.cast, drains, m_plan.up, m_settings.vents.smallestTrap)) {
            VentedTrap vented{std::move(trap), {}, m_traps++, false};
            vented.top = kind.cast.point(vented.trap.point);
            if (const auto wish = placeByHand(m_settings.placed, Placeable::Vent, vented.number))
                if (Result<void> done = move(vented, kind.cast, *wish); !done)
                    return done;
            m_found.traps.push_back(std::move(vented));
        }
        return {};
    }

    static Result<void> move(VentedTrap& vented, const IndexedMesh& cast, const Vector2d& wish) {
        const int nearest = nearestInPlan(cast, wish, vented.top.z());
        const std::vector<int>& own = vented.trap.points;
        if (nearest < 0 || std::find(own.begin(), own.end(), nearest) == own.end())
            return failure(ErrorCode::Impossible,
                           MW_TEXT("Mold", "Vent {0} would stand beside the {1} mm³ of air that it is to let "
                                           "out. Keep it over them, or have it placed automatically."),
                           {std::to_string(vented.number + 1), readable(vented.trap.volume)});
        vented.top = {wish.x(), wish.y(), cast.V(nearest, 2)};
        vented.byHand = true;
        return {};
    }

    /// `number`: of the kind.
    Result<void> findPins(std::size_t number) {
        const EjectorSettings& pins = m_settings.ejectors;
        std::vector<std::pair<Vector2d, double>> keepOff;
        for (const Gate& gate : m_found.gates)
            keepOff.emplace_back(gate.tip, gate.drop + m_plan.gate / 2);
        for (const VentedTrap& vented : m_found.traps)
            keepOff.emplace_back(vented.top.head<2>(), 2 * m_settings.vents.diameter);
        for (const HalfBore& bore : m_found.bores)
            if (bore.side == pins.side)
                keepOff.emplace_back(bore.axis, m_settings.spout.diameter);
        Wishes wishes;
        const int first = static_cast<int>(number) * pins.count;
        for (int i = 0; i < pins.count; ++i)
            wishes.push_back(placeByHand(m_settings.placed, Placeable::Ejector, first + i));
        const Result<std::vector<BorePlace>> places =
            ejectorPlaces(m_shapes.pinGrounds[number], m_settings.leastSteel, keepOff, wishes);
        if (!places)
            return std::unexpected(places.error());
        for (int i = 0; i < pins.count; ++i) {
            const BorePlace& place = (*places)[static_cast<std::size_t>(i)];
            const double radius = pins.diameter / 2;
            m_found.bores.push_back({HalfBore::Use::Pin,
                                     pins.side,
                                     place.axis,
                                     {{place.inside, radius}, {0, radius}},
                                     0,
                                     place.tip,
                                     first + i});
        }
        return {};
    }

    const CavityShapes& m_shapes;
    const EntryPlan& m_plan;
    const MoldSettings& m_settings;
    CavityFeatures m_found;
    int m_spouts = 0;
    int m_traps = 0;
};

} // namespace

void CavityShapes::findGrounds(const MoldSettings& settings, const Directions& directions) {
    for (const CavityKind& kind : kinds) {
        if (settings.spout.on && settings.spout.resting == Resting::Lying)
            spoutGrounds.push_back(moldwright::spoutGrounds(kind, directions, settings.spout.neck));
        if (settings.ejectors.count > 0)
            pinGrounds.push_back(ejectorGround(kind, directions, settings.ejectors, settings.leastSteel));
    }
}

Result<std::vector<CavityFeatures>> entriesOf(const CavityShapes& shapes, const EntryPlan& plan) {
    EntryFinder finder(shapes, plan);
    std::vector<CavityFeatures> all;
    for (std::size_t kind = 0; kind < shapes.kinds.size(); ++kind) {
        Result<CavityFeatures> entries = finder.ofKind(kind);
        if (!entries)
            return std::unexpected(entries.error());
        all.push_back(*std::move(entries));
    }
    return all;
}

} // namespace moldwright
