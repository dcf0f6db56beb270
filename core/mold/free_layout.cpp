// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/free_layout.h"

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

using Eigen::Vector2d;

std::string numberOf(std::size_t cavity) {
    return std::to_string(cavity + 1);
}

/// From a place straight up, beyond everything.
PlanShape stripOver(const Vector2d& tip, double width, double top) {
    return planRectangle({tip.x() - width / 2, tip.y()},
                         {tip.x() + width / 2, std::max(top, tip.y()) + width});
}

class FreeLayout {
public:
    FreeLayout(const std::vector<CavityKind>& kinds, const std::vector<CavityPlace>& places,
               const std::vector<std::vector<Vector2d>>& tips, double spoutWidth, double steel)
        : m_steel(steel) {
        double top = 0;
        for (std::size_t i = 0; i < kinds.size(); ++i) {
            CavityCopy copy;
            copy.kind = i;
            copy.column = static_cast<int>(i);
            copy.offset = onCopyStep({places[i].x, places[i].y});
            m_layout.copies.push_back(copy);
            m_hulls.push_back(movedPlan(kinds[i].hull, copy.offset));
            for (const Vector2d& p : m_hulls.back())
                top = std::max(top, p.y());
        }
        if (spoutWidth > 0)
            for (std::size_t i = 0; i < kinds.size(); ++i)
                for (const Vector2d& tip : tips[i])
                    m_spouts.emplace_back(i, stripOver(tip + m_layout.copies[i].offset, spoutWidth, top));
    }

    Result<Layout> checked() {
        for (std::size_t i = 0; i < m_hulls.size(); ++i)
            for (std::size_t j = i + 1; j < m_hulls.size(); ++j)
                if (const double apart = planDistance(m_hulls[i], m_hulls[j]); apart < m_steel)
                    return failure(ErrorCode::Impossible,
                                   MW_TEXT("Mold",
                                           "Cavities {0} and {1} stand {2} mm apart; {3} mm of steel are "
                                           "asked for between them."),
                                   {numberOf(i), numberOf(j), readable(apart), readable(m_steel)});
        for (const auto& [owner, spout] : m_spouts) {
            for (std::size_t j = 0; j < m_hulls.size(); ++j)
                if (j != owner && planDistance(spout, m_hulls[j]) < m_steel)
                    return blocked(owner, j);
            for (const auto& [other, another] : m_spouts)
                if (other != owner && planDistance(spout, another) < m_steel)
                    return blocked(owner, other);
        }
        return std::move(m_layout);
    }

private:
    static std::unexpected<Error> blocked(std::size_t owner, std::size_t other) {
        return failure(ErrorCode::Impossible,
                       MW_TEXT("Mold",
                               "The spout of cavity {0} passes too near to cavity {1} or its spout. Move "
                               "one of them, or fill them through half 1."),
                       {numberOf(owner), numberOf(other)});
    }

    double m_steel;
    Layout m_layout;
    std::vector<PlanShape> m_hulls;
    std::vector<std::pair<std::size_t, PlanShape>> m_spouts; ///< with the cavity that each belongs to
};

} // namespace

Result<std::vector<CavityKind>> kindsAtPlaces(const std::vector<CavityKind>& parts,
                                              const std::vector<std::size_t>& partAt,
                                              const CavityRules& rules,
                                              const std::vector<CavityPlace>& places) {
    if (places.empty())
        return failure(ErrorCode::Usage,
                       MW_TEXT("Mold", "A free layout needs at least one place for a cavity."));
    std::vector<CavityKind> kinds;
    for (const CavityPlace& place : places) {
        std::expected<CavityKind, double> kind =
            turnedKind(parts[partAt[kinds.size()]], radians(std::remainder(place.turn, 360)), rules);
        if (!kind)
            return failure(ErrorCode::Impossible,
                           MW_TEXT("Mold",
                                   "Cavity {0} cannot be turned by {1}°: its faces would leave with {2}°, "
                                   "{3}° are required. Turned copies need removal directions normal to "
                                   "the plane."),
                           {numberOf(kinds.size()), readable(place.turn), readable(kind.error()),
                            readable(rules.draftDegrees)});
        kinds.push_back(*std::move(kind));
    }
    return kinds;
}

Result<Layout> freeLayout(const std::vector<CavityKind>& kinds, const std::vector<CavityPlace>& places,
                          const std::vector<std::vector<Vector2d>>& tips, double spoutWidth, double steel) {
    Result<Layout> layout = FreeLayout(kinds, places, tips, spoutWidth, steel).checked();
    if (layout)
        centreLayout(*layout, kinds);
    return layout;
}

} // namespace moldwright
