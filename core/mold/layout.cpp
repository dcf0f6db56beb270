// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/layout.h"

#include "castability/certificate.h"
#include "castability/float_rounding.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <tuple>

namespace moldwright {

namespace {

using Eigen::AlignedBox2d;
using Eigen::Vector2d;
using Eigen::Vector3d;

constexpr double sixteenth = 1.0 / 16;

AlignedBox2d boxOf(const PlanShape& shape) {
    AlignedBox2d box;
    for (const Vector2d& p : shape)
        box.extend(p);
    return box;
}

/// Half a turn about z; about x, which swaps the sides; or a reflection in x. All exact.
Vector3d signsOf(Alternation alternation) {
    switch (alternation) {
    case Alternation::Turn:
        return {-1, -1, 1};
    case Alternation::Flip:
        return {1, -1, -1};
    case Alternation::Mirror:
        return {-1, 1, 1};
    case Alternation::None:
        break;
    }
    return {1, 1, 1};
}

const char* refusalOf(Alternation alternation) {
    switch (alternation) {
    case Alternation::Turn:
        return MW_TEXT("Mold",
                       "Every second cavity cannot be turned: its faces would leave with {0}°, {1}° are "
                       "required. Turned copies need removal directions normal to the plane.");
    case Alternation::Flip:
        return MW_TEXT("Mold",
                       "Every second cavity cannot be turned over: its faces would leave with {0}°, {1}° "
                       "are required. That needs removal directions that the half-turn exchanges.");
    default:
        return MW_TEXT("Mold",
                       "Every second cavity cannot be mirrored: its faces would leave with {0}°, {1}° are "
                       "required. That needs removal directions in the mirror's plane.");
    }
}

/// A cast that was put another way, on the grid, or the draft in degrees that it would have.
std::expected<CavityKind, double> certifiedKind(const IndexedMesh& placed, const SideLabels& labels,
                                                const CavityRules& rules) {
    IndexedMesh cast = roundKeepingDraft(placed, labels, rules.directions, rules.draftDegrees, rules.grid);
    const Certificate certificate = certify(cast, labels, {{}, rules.directions}, rules.draftDegrees);
    if (!certificate.holds())
        return std::unexpected(certificate.worstDraftDegrees);
    return cavityKind(std::move(cast), labels);
}

Result<CavityKind> alternateKind(const CavityKind& first, const CavityRules& rules, Alternation alternation) {
    const Vector3d signs = signsOf(alternation);
    IndexedMesh cast{first.cast.V * signs.asDiagonal(), first.cast.F};
    if (signs.prod() < 0)
        cast.F.col(1).swap(cast.F.col(2));
    std::expected<CavityKind, double> kind = certifiedKind(cast, labelSides(cast, {}), rules);
    if (!kind)
        return failure(ErrorCode::Impossible, refusalOf(alternation),
                       {readable(kind.error()), readable(rules.draftDegrees)});
    kind->mirrored = alternation == Alternation::Mirror;
    return *std::move(kind);
}

/// The least multiple of 1/16 by which `b` must stand further along `way` to keep `spacing` from `a`.
double pitchBetween(const PlanShape& a, const PlanShape& b, const Vector2d& way, double most,
                    double spacing) {
    double low = 0;
    double high = most;
    while (high - low > sixteenth / 2) {
        const double middle = (low + high) / 2;
        (planDistance(a, movedPlan(b, middle * way)) >= spacing ? high : low) = middle;
    }
    return upToSixteenth(high);
}

class Arranger {
public:
    Arranger(const std::vector<CavityKind>& kinds, const std::vector<std::size_t>& kindAt,
             const LayoutSettings& settings, const RunnerRoom& room)
        : m_kinds(kinds), m_kindAt(kindAt), m_settings(settings), m_room(room) {
        for (const CavityKind& kind : kinds)
            m_box.extend(boxOf(kind.hull));
        for (const CavityKind& kind : kinds) {
            const double below = m_box.max().y() - boxOf(kind.hull).max().y();
            m_lift.push_back(room.row > 0 ? std::floor(below / sixteenth) * sixteenth : 0);
            m_hulls.push_back(movedPlan(kind.hull, {0, m_lift.back()}));
        }
    }

    Layout arranged() {
        const bool staggered = m_settings.arrangement == Arrangement::Staggered;
        m_shift = staggered ? upToSixteenth(columnPitch() / 2) : 0;
        Layout layout;
        // With shifted rows the main runner has no straight way between columns.
        layout.mainColumn = staggered ? m_settings.columns : m_settings.columns / 2;
        const bool packed = m_settings.arrangement == Arrangement::Packed;
        const std::vector<double> columns =
            packed ? packedColumns(layout.mainColumn) : evenColumns(layout.mainColumn);
        const std::vector<double> rows = packed ? packedRows(columns) : evenRows();
        for (int r = 0; r < m_settings.rows; ++r)
            for (int c = 0; c < m_settings.columns; ++c) {
                CavityCopy copy;
                copy.kind = kindAt(r, c);
                copy.row = r;
                copy.column = c;
                copy.offset = {columns[static_cast<std::size_t>(c)] + (r % 2) * m_shift,
                               rows[static_cast<std::size_t>(r)] + m_lift[copy.kind]};
                layout.copies.push_back(copy);
            }
        const double runner = upToSixteenth(m_box.max().y() + m_settings.spacing + m_room.row / 2);
        for (const double lift : m_lift)
            layout.runnerOverKind.push_back(runner - lift);
        layout.mainAxis = mainAxis(layout);
        centre(layout);
        return layout;
    }

private:
    [[nodiscard]] std::size_t kindAt(int row, int column) const {
        return m_kindAt[static_cast<std::size_t>(row * m_settings.columns + column)];
    }
    [[nodiscard]] bool hasMainRunner() const {
        return m_room.main > 0 && m_settings.rows * m_settings.columns > 1;
    }

    [[nodiscard]] std::vector<double> evenColumns(int mainColumn) const {
        std::vector<double> places;
        for (int c = 0; c < m_settings.columns; ++c)
            places.push_back(c * columnPitch() + (c >= mainColumn ? gap() : 0));
        return places;
    }
    [[nodiscard]] std::vector<double> evenRows() const {
        std::vector<double> places;
        for (int r = 0; r < m_settings.rows; ++r)
            places.push_back(r * rowPitch());
        return places;
    }

    /// Each column as near to those before it as what stands in its rows allows, but for the main runner.
    [[nodiscard]] std::vector<double> packedColumns(int mainColumn) {
        std::vector<double> places;
        for (int c = 0; c < m_settings.columns; ++c) {
            double place = 0;
            for (int before = 0; before < c; ++before)
                for (int r = 0; r < m_settings.rows; ++r)
                    place = std::max(place, places[static_cast<std::size_t>(before)] +
                                                pitch(kindAt(r, before), kindAt(r, c), Vector2d::UnitX(), 0));
            if (c >= mainColumn && hasMainRunner())
                for (int r = 0; r < m_settings.rows; ++r)
                    place = std::max(place, upToSixteenth(rightBefore(mainColumn, places) + m_room.main +
                                                          2 * m_settings.spacing -
                                                          boxOf(m_hulls[kindAt(r, c)]).min().x()));
            places.push_back(place);
        }
        return places;
    }
    /// How far the columns before one reach.
    [[nodiscard]] double rightBefore(int column, const std::vector<double>& places) const {
        double right = -std::numeric_limits<double>::infinity();
        for (int c = 0; c < column; ++c)
            for (int r = 0; r < m_settings.rows; ++r)
                right = std::max(right, places[static_cast<std::size_t>(c)] +
                                            boxOf(m_hulls[kindAt(r, c)]).max().x());
        return column > 0 ? right : boxOf(m_hulls[kindAt(0, 0)]).min().x() - m_settings.spacing;
    }
    /// Each row as near to those below it as its cavities allow, or the runner between them.
    [[nodiscard]] std::vector<double> packedRows(const std::vector<double>& columns) {
        std::vector<double> places{0};
        for (int r = 1; r < m_settings.rows; ++r) {
            double place = places.back();
            for (int c = 0; c < m_settings.columns; ++c) {
                const std::size_t kind = kindAt(r, c);
                if (m_room.row > 0)
                    place = std::max(place, places.back() + upToSixteenth(m_box.max().y() + m_room.row +
                                                                          2 * m_settings.spacing -
                                                                          boxOf(m_hulls[kind]).min().y()));
                for (int below = 0; below < r; ++below)
                    for (int k = 0; k < m_settings.columns; ++k)
                        place = std::max(place, places[static_cast<std::size_t>(below)] +
                                                    pitch(kindAt(below, k), kind, Vector2d::UnitY(),
                                                          columns[static_cast<std::size_t>(c)] -
                                                              columns[static_cast<std::size_t>(k)]));
            }
            places.push_back(place);
        }
        return places;
    }
    /// Of kind `b` after kind `a` along an axis, with `aside` mm between them across it.
    [[nodiscard]] double pitch(std::size_t a, std::size_t b, const Vector2d& way, double aside) {
        const Vector2d across(way.y(), way.x());
        const auto [known, isNew] = m_pitches.try_emplace({a, b, way.y(), aside}, 0.0);
        const double reach = m_box.sizes().maxCoeff() + m_settings.spacing;
        if (isNew && std::abs(aside) < reach)
            known->second = pitchBetween(m_hulls[a], movedPlan(m_hulls[b], aside * across), way, reach,
                                         m_settings.spacing);
        return known->second;
    }

    [[nodiscard]] double columnPitch() const {
        const double box = m_box.sizes().x() + m_settings.spacing;
        if (m_settings.arrangement == Arrangement::Grid)
            return upToSixteenth(box + m_room.column);
        double pitch = 0;
        for (const PlanShape& a : m_hulls)
            for (const PlanShape& b : m_hulls)
                pitch = std::max(pitch, pitchBetween(a, b, Vector2d::UnitX(), box, m_settings.spacing));
        return pitch;
    }
    [[nodiscard]] double rowPitch() const {
        const double spacing = m_settings.spacing;
        const double box = m_box.sizes().y() + spacing + (m_room.row > 0 ? m_room.row + spacing : 0);
        if (m_settings.arrangement == Arrangement::Grid || m_room.row > 0)
            return upToSixteenth(box);
        double pitch = 0;
        for (const PlanShape& a : m_hulls)
            for (const PlanShape& b : m_hulls)
                for (const double shift : {m_shift, m_shift - columnPitch(), m_shift + columnPitch()})
                    pitch = std::max(
                        pitch, pitchBetween(a, movedPlan(b, {shift, 0}), Vector2d::UnitY(), box, spacing));
        // Every second row stands over its like.
        return std::max(pitch, upToSixteenth(box / 2));
    }
    /// What the columns after the main runner stand further on.
    [[nodiscard]] double gap() const {
        if (!hasMainRunner())
            return 0;
        const double closer = m_box.sizes().x() + m_settings.spacing - columnPitch();
        return upToSixteenth(m_room.main + m_settings.spacing + closer);
    }
    /// Between the columns on both sides, or beside the first or last.
    [[nodiscard]] double mainAxis(const Layout& layout) const {
        const double beside = m_settings.spacing + m_room.main / 2;
        AlignedBox2d left;
        AlignedBox2d right;
        for (const CavityCopy& copy : layout.copies) {
            const bool packed = m_settings.arrangement == Arrangement::Packed;
            const AlignedBox2d box = packed ? boxOf(m_hulls[copy.kind]) : m_box;
            (copy.column < layout.mainColumn ? left : right)
                .extend(box.translated(Vector2d(copy.offset.x(), 0)));
        }
        if (left.isEmpty())
            return upToSixteenth(right.min().x() - beside) - sixteenth;
        return upToSixteenth(left.max().x() + beside);
    }
    void centre(Layout& layout) const {
        centreLayout(layout, m_kinds);
        for (int r = 0; r < m_settings.rows; ++r) {
            const CavityCopy& copy = layout.copies[static_cast<std::size_t>(r * m_settings.columns)];
            layout.runnerAxes.push_back(copy.offset.y() + layout.runnerOverKind[copy.kind]);
        }
    }

    const std::vector<CavityKind>& m_kinds;
    const std::vector<std::size_t>& m_kindAt;
    const LayoutSettings& m_settings;
    RunnerRoom m_room;
    AlignedBox2d m_box;             ///< round each of the kinds
    std::vector<double> m_lift;     ///< by kind, towards the runner
    std::vector<PlanShape> m_hulls; ///< by kind, lifted
    double m_shift = 0;
    std::map<std::tuple<std::size_t, std::size_t, double, double>, double> m_pitches; ///< packed
};

} // namespace

CavityKind cavityKind(IndexedMesh cast, SideLabels labels) {
    CavityKind kind;
    kind.box = boundingBox(cast);
    kind.volume = volume(cast);
    kind.hull = planHull(cast.V);
    kind.outlines = outlinesOf(cast, labels);
    kind.cast = std::move(cast);
    kind.labels = std::move(labels);
    return kind;
}

std::expected<CavityKind, double> turnedKind(const CavityKind& kind, double angle, const CavityRules& rules) {
    if (angle == 0)
        return kind;
    const Eigen::Matrix3d turn = Eigen::AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix();
    IndexedMesh cast{kind.cast.V * turn.transpose(), kind.cast.F};
    cast.V.col(2) = kind.cast.V.col(2); // the plane stays, to the bit
    std::expected<CavityKind, double> turned = certifiedKind(cast, kind.labels, rules);
    if (turned) {
        turned->turn = kind.turn + angle;
        turned->part = kind.part;
    }
    return turned;
}

std::vector<CavityOutline> CavityKind::outlinesFromInlet() const {
    std::vector<CavityOutline> turned = outlines;
    for (CavityOutline& outline : turned)
        for (Vector2d& p : outline.shape)
            p = fromInlet(p);
    return turned;
}

std::vector<Gate> gatesAtInlet(const CavityKind& kind, double width) {
    std::vector<Gate> gates = gatesOf(kind.outlinesFromInlet(), width);
    for (Gate& gate : gates) {
        gate.tip = kind.toInlet(gate.tip);
        for (Vector2d& p : gate.outline)
            p = kind.toInlet(p);
    }
    return gates;
}

Vector2d onCopyStep(const Vector2d& place) {
    constexpr double step = 1.0 / 256;
    return (place / step).array().round().matrix() * step;
}

void centreLayout(Layout& layout, const std::vector<CavityKind>& kinds) {
    AlignedBox2d all;
    for (const CavityCopy& copy : layout.copies)
        all.extend(boxOf(movedPlan(kinds[copy.kind].hull, copy.offset)));
    const Vector2d middle = all.center();
    const Vector2d shift = -(middle / sixteenth).array().round().matrix() * sixteenth;
    for (CavityCopy& copy : layout.copies)
        copy.offset += shift;
    layout.mainAxis += shift.x();
    layout.hub += shift;
}

double upToSixteenth(double length) {
    return std::ceil(length / sixteenth - 1e-9) * sixteenth;
}

Result<std::vector<CavityKind>> withAlternate(const CavityKind& kind, const CavityRules& rules,
                                              Alternation alternation) {
    std::vector<CavityKind> kinds{kind};
    if (alternation == Alternation::None)
        return kinds;
    Result<CavityKind> second = alternateKind(kind, rules, alternation);
    if (!second)
        return std::unexpected(second.error());
    kinds.push_back(*std::move(second));
    return kinds;
}

Layout layoutOf(const std::vector<CavityKind>& kinds, const std::vector<std::size_t>& kindAt,
                const LayoutSettings& settings, const RunnerRoom& room) {
    return Arranger(kinds, kindAt, settings, room).arranged();
}

} // namespace moldwright
