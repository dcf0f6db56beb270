// SPDX-License-Identifier: AGPL-3.0-or-later
// The builder's first stages: the casts of the tray in the mold's frame, and the kinds of cavities.
#include "castability/placed_cast.h"
#include "mesh/measures.h"
#include "mold/circle_layout.h"
#include "mold/free_layout.h"
#include "mold/further_part.h"
#include "mold/mold_builder.h"
#include "mold/overflows.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;

/// A power of two that all coordinates of a mold of this half size are multiples of, as floats.
double gridFor(double halfSize) {
    return std::ldexp(1.0, static_cast<int>(std::ceil(std::log2(halfSize))) - 24);
}

/// How far the cavities of a mold reach from its middle, and its block beyond them, at most; mm.
struct Reach {
    double cavities = 0;
    double round = 0;
};
Reach farthestReach(const MoldSettings& settings, const SeatedLayout& seats, double castSize) {
    const LayoutSettings& layout = seats.layout;
    const double cell = castSize + 2 * spacingWithOverflows(settings) + 2 * settings.spout.diameter;
    double cavities = std::max(layout.rows, layout.columns) * cell / 2;
    if (layout.arrangement == Arrangement::Circle)
        cavities = (static_cast<double>(seats.partAt.size()) / 2 + 2) * (cell + settings.spout.funnel);
    if (layout.arrangement == Arrangement::Free) {
        Eigen::AlignedBox2d box;
        for (const CavityPlace& place : layout.places)
            box.extend(Vector2d(place.x, place.y));
        cavities = cell + (box.isEmpty() ? 0 : box.sizes().maxCoeff());
    }
    return {cavities, settings.wall + settings.floor + settings.ceiling + settings.step +
                          2 * settings.spout.funnel + 4 * settings.keys.diameter + 40};
}

Result<std::vector<CompensatedCast>> madeLarger(const Tray& tray, const ShrinkSettings& shrink) {
    std::vector<CompensatedCast> casts;
    for (const TrayPart& part : tray) {
        Result<CompensatedCast> larger = compensated(*part.cast->mesh, part.cast->state, shrink);
        if (!larger)
            return std::unexpected(larger.error());
        casts.push_back(*std::move(larger));
    }
    return casts;
}

} // namespace

Result<void> MoldBuilder::place(const Tray& tray) {
    const MoldSettings& settings = m_mold.settings;
    if (settings.vents.on && !settings.spout.on)
        return failure(ErrorCode::Usage,
                       MW_TEXT("Mold",
                               "Vents need a spout: without one nothing tells which way is up while the "
                               "mold is filled."));
    Result<SeatedLayout> seats = seated(tray, settings.layout);
    if (!seats)
        return std::unexpected(seats.error());
    m_seats = *std::move(seats);
    const Result<std::vector<CompensatedCast>> casts = madeLarger(tray, settings.shrink);
    if (!casts)
        return std::unexpected(casts.error());
    double size = 0;
    for (const CompensatedCast& cast : *casts)
        size = std::max(size, diagonal(cast.mesh));
    const Reach reach = farthestReach(settings, m_seats, size);
    m_grid = gridFor(reach.cavities + reach.round);
    m_farthest = reach.cavities + reach.round / 2;
    if (Result<void> done = placeFirst(casts->front(), tray.front().cast->labels); !done)
        return done;
    for (std::size_t part = 1; part < tray.size(); ++part) {
        const CompensatedCast& larger = (*casts)[part];
        const SideLabels& labels = tray[part].cast->labels;
        const PlacedCast placed = placeCast(larger.mesh, labels, larger.state, m_mold.draftDegrees, m_grid);
        Result<StandingPart> stands = furtherPart(placed, labels, quartersUp(placed.mesh, labels),
                                                  cavityRules(), nameAndSource(tray, part));
        if (!stands)
            return std::unexpected(stands.error());
        m_parts.push_back(std::move(stands->upright));
        m_parts.back().part = part;
        m_mold.parts.emplace_back().toMold = stands->fromPart;
    }
    for (std::size_t part = 0; part < tray.size(); ++part)
        m_mold.parts[part].name = tray.size() > 1 ? partName(tray, part) : tray[part].name;
    return {};
}

Result<void> MoldBuilder::placeFirst(const CompensatedCast& cast, const SideLabels& labels) {
    m_mold.shrinkFactors = cast.factors;
    const PlacedCast placed = placeCast(cast.mesh, labels, cast.state, m_mold.draftDegrees, m_grid);
    m_mold.castCertificate = certify(placed.mesh, labels, placed.state, m_mold.draftDegrees);
    const Certificate& proof = m_mold.castCertificate;
    if (!proof.closedAndOutward || !proof.curvesSimpleAndNested)
        return failure(ErrorCode::BadInput,
                       MW_TEXT("Mold", "No mold can be built round this cast. {0} Finish the cast first."),
                       {proof.reason});
    if (cast.factors.minCoeff() != cast.factors.maxCoeff() && !proof.draftHolds)
        m_mold.notes.push_back(
            {MW_TEXT("Mold",
                     "Shrinking differently along the axes turns faces: the draft falls to {0}°. Design the "
                     "cast with {1}°."),
             {readable(proof.worstDraftDegrees),
              readable(2 * m_mold.draftDegrees - proof.worstDraftDegrees, 3)}});
    const int quarters = quartersUp(placed.mesh, labels);
    const auto turned = [&](const Vector3d& d) -> Vector3d {
        return quarterTurned({d.transpose(), {}}, quarters).point(0);
    };
    m_mold.directions = {turned(placed.state.directions.d1), turned(placed.state.directions.d2)};
    const Eigen::Quaterniond turn(Eigen::AngleAxisd(radians(90.0 * quarters), Vector3d::UnitZ()));
    m_mold.parts.emplace_back().toMold = turn * placed.fromPart;
    m_parts.push_back(cavityKind(quarterTurned(placed.mesh, quarters), labels));
    return {};
}

/// The turn of a placed cast with which +y is up while the mold is filled.
int MoldBuilder::quartersUp(const IndexedMesh& cast, const SideLabels& labels) const {
    if (!inPlane())
        return 0;
    return spout().pour == PourDirection::Automatic
               ? bestQuarterTurn(cast, labels, spout().gate, m_mold.settings.vents.smallestTrap)
               : static_cast<int>(spout().pour) - 1;
}

Result<std::vector<CavityKind>> MoldBuilder::kindsAsked() const {
    const LayoutSettings& layout = m_seats.layout;
    if ((star() || isFree()) && layout.alternation != Alternation::None)
        return failure(ErrorCode::Usage,
                       MW_TEXT("Mold",
                               "Every second cavity can be another one in rows only, not on a circle or "
                               "in a free layout."));
    if (m_parts.size() > 1 && layout.alternation != Alternation::None)
        return failure(ErrorCode::Usage,
                       MW_TEXT("Mold", "Every second cavity can be another one only where all are of one "
                                       "part."));
    if (isFree())
        return kindsAtPlaces(m_parts, m_seats.partAt, cavityRules(), layout.places);
    if (star())
        return kindsRound(m_parts, m_seats.partAt, cavityRules());
    if (m_parts.size() > 1)
        return m_parts;
    return withAlternate(m_parts.front(), cavityRules(), layout.alternation);
}

/// In rows and columns: which kind each place has.
std::vector<std::size_t> MoldBuilder::kindAt() const {
    if (m_mold.parts.size() > 1 || kinds().size() == 1)
        return m_seats.partAt;
    const auto columns = static_cast<std::size_t>(m_seats.layout.columns);
    std::vector<std::size_t> kinds;
    for (std::size_t place = 0; place < m_seats.partAt.size(); ++place)
        kinds.push_back((place / columns + place % columns) % 2);
    return kinds;
}

/// Where all cavities have depth; where no side is common to them, wherever one has.
std::array<bool, 2> MoldBuilder::sidesOfChannels() const {
    std::array<bool, 2> all{true, true};
    std::array<bool, 2> any{false, false};
    for (const CavityKind& kind : kinds()) {
        const double depth = onPlaneTolerance(kind.cast);
        const std::array<bool, 2> has{kind.cast.V.col(2).maxCoeff() > depth,
                                      kind.cast.V.col(2).minCoeff() < -depth};
        for (const std::size_t side : {0UL, 1UL}) {
            all[side] = all[side] && has[side];
            any[side] = any[side] || has[side];
        }
    }
    return all[0] || all[1] ? all : any;
}

Result<void> MoldBuilder::makeKinds() {
    const MoldSettings& settings = m_mold.settings;
    Result<std::vector<CavityKind>> kinds = kindsAsked();
    if (!kinds)
        return std::unexpected(kinds.error());
    m_parts.clear();
    if (star() && std::all_of(kinds->begin(), kinds->end(), [](const CavityKind& k) { return k.turn == 0; }))
        m_mold.notes.push_back(
            {MW_TEXT("Mold",
                     "The removal directions do not allow turned copies: on the circle they are only moved, "
                     "and each is filled on another of its sides."),
             {}});
    const LayoutSettings& layout = m_seats.layout;
    if (settings.layout.rows * settings.layout.columns > 1 && layout != settings.layout)
        m_mold.notes.push_back(
            {MW_TEXT("Mold", "The layout has {0} × {1} cavities instead of {2} × {3}, so "
                             "that each part has its number."),
             {std::to_string(layout.rows), std::to_string(layout.columns),
              std::to_string(settings.layout.rows), std::to_string(settings.layout.columns)}});
    for (std::size_t part = 0; part < m_mold.parts.size(); ++part)
        m_mold.parts[part].toMold.prerotate(
            Eigen::AngleAxisd(std::ranges::find(*kinds, part, &CavityKind::part)->turn, Vector3d::UnitZ()));
    const auto shapes = std::make_shared<CavityShapes>();
    shapes->kinds = *std::move(kinds);
    shapes->findGrounds(settings, m_mold.directions);
    m_shapes = shapes;
    m_rules = {m_mold.directions, std::max(spout().draft, m_mold.draftDegrees + 1), sidesOfChannels(),
               m_grid};
    return setPlaced(settings.placed);
}

} // namespace moldwright
