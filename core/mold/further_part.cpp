// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/further_part.h"

#include "castability/certificate.h"
#include "castability/float_rounding.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace moldwright {

namespace {

using Eigen::AngleAxisd;
using Eigen::Vector3d;

constexpr double quarter = std::numbers::pi / 2;

/// How much draft a cast has along a mold's directions when it is turned about the normal.
class Turns {
public:
    Turns(const IndexedMesh& cast, const SideLabels& labels, const Directions& mold) : m_mold(mold) {
        for (int f = 0; f < cast.faceCount(); ++f)
            if (const Vector3d normal = doubleAreaVector(cast, f); normal.norm() > 0)
                m_normals.at(labels[static_cast<std::size_t>(f)] == 1 ? 0 : 1).push_back(normal.normalized());
    }

    [[nodiscard]] double draft(double turn) const {
        const AngleAxisd back(-turn, Vector3d::UnitZ());
        double least = 1;
        for (const int side : {1, 2}) {
            const Vector3d d = back * m_mold.of(side);
            for (const Vector3d& normal : m_normals.at(side == 1 ? 0 : 1))
                least = std::min(least, normal.dot(d));
        }
        return draftDegrees(least);
    }

    /// The turn with most draft of those by which a direction of the cast's own leans as the mold's does, and
    /// of some all round.
    [[nodiscard]] double best(const Directions& own) const {
        std::vector<double> turns;
        for (const int side : {1, 2})
            turns.push_back(azimuth(m_mold.of(side)) - azimuth(own.of(side)));
        constexpr int round = 24;
        for (int i = 0; i < round; ++i)
            turns.push_back(2 * std::numbers::pi * i / round);
        return *std::ranges::max_element(turns, {}, [&](double turn) { return draft(turn); });
    }

private:
    static double azimuth(const Vector3d& d) { return std::atan2(d.y(), d.x()); }

    Directions m_mold;
    std::array<std::vector<Vector3d>, 2> m_normals; ///< unit, of the faces of side 1 and 2
};

IndexedMesh turned(const IndexedMesh& cast, double angle) {
    if (const double quarters = std::round(angle / quarter); angle == quarters * quarter)
        return quarterTurned(cast, (static_cast<int>(quarters) % 4 + 4) % 4);
    IndexedMesh mesh{cast.V * AngleAxisd(angle, Vector3d::UnitZ()).toRotationMatrix().transpose(), cast.F};
    mesh.V.col(2) = cast.V.col(2); // the plane stays, to the bit
    return mesh;
}

} // namespace

Result<StandingPart> furtherPart(const PlacedCast& placed, const SideLabels& labels, int quarters,
                                 const CavityRules& rules, const std::string& name) {
    const Turns turns(placed.mesh, labels, rules.directions);
    double turn = quarters * quarter;
    if (turns.draft(turn) < rules.draftDegrees)
        turn = turns.best(placed.state.directions);
    IndexedMesh cast = roundKeepingDraft(turned(placed.mesh, turn), labels, rules.directions,
                                         rules.draftDegrees, rules.grid);
    const Certificate proof = certify(cast, labels, {{}, rules.directions}, rules.draftDegrees);
    if (proof.closedAndOutward && !proof.draftHolds)
        return failure(ErrorCode::Impossible,
                       MW_TEXT("Mold",
                               "{0} cannot stand in this mold: along the mold's removal directions its faces "
                               "would leave with {1}° at best, {2}° are required. Design both parts with "
                               "directions normal to the plane, or with the same ones."),
                       {name, readable(proof.worstDraftDegrees), readable(rules.draftDegrees)});
    if (!proof.holds())
        return failure(ErrorCode::BadInput,
                       MW_TEXT("Mold", "{0} cannot stand in this mold. {1} Finish its cast first."),
                       {name, proof.reason});
    const Eigen::Quaterniond motion(AngleAxisd(turn, Vector3d::UnitZ()));
    return StandingPart{cavityKind(std::move(cast), labels), motion * placed.fromPart};
}

} // namespace moldwright
