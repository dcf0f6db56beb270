// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/shrink.h"

#include <cmath>

namespace moldwright {

double shrinkFactor(double percent, ShrinkFormula formula) {
    const double s = percent / 100;
    return formula == ShrinkFormula::Plus ? 1 + s : 1 / (1 - s);
}

Result<CompensatedCast> compensated(const IndexedMesh& cast, const MoldState& state,
                                    const ShrinkSettings& shrink) {
    constexpr double most = 50;
    CompensatedCast result{cast, state, {}};
    for (int axis = 0; axis < 3; ++axis) {
        if (std::abs(shrink.percent[axis]) >= most)
            return failure(
                ErrorCode::Usage,
                MW_TEXT("Mold", "A shrink of {0} % is no shrink of a material: give less than 50 %."),
                {readable(shrink.percent[axis])});
        result.factors[axis] = shrinkFactor(shrink.percent[axis], shrink.formula);
    }
    if (result.factors == Eigen::Vector3d::Ones())
        return result;
    for (int v = 0; v < cast.vertexCount(); ++v)
        result.mesh.V.row(v) = madeLarger(cast.point(v), result.factors, shrink.origin).transpose();
    const Eigen::Vector3d onPlane = state.plane.offset * state.plane.normal;
    const Eigen::Vector3d moved = madeLarger(onPlane, result.factors, shrink.origin);
    if (result.factors.minCoeff() != result.factors.maxCoeff()) {
        // A uniform factor keeps all angles: dividing by it would only round.
        result.state.plane.normal = state.plane.normal.cwiseQuotient(result.factors).normalized();
        result.state.directions.d1 = result.factors.cwiseProduct(state.directions.d1).normalized();
        result.state.directions.d2 = result.factors.cwiseProduct(state.directions.d2).normalized();
    }
    result.state.plane.offset = result.state.plane.normal.dot(moved);
    return result;
}

} // namespace moldwright
