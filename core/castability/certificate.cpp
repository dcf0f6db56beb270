// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/certificate.h"

#include "base/stop_point.h"
#include "castability/exact_predicates.h"
#include "castability/parting_curves.h"
#include "mesh/check.h"
#include "mesh/measures.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace moldwright {

namespace {

using Eigen::Vector3d;

std::vector<int> facesBelowDraft(const IndexedMesh& cast, const SideLabels& labels, const Directions& d,
                                 double draft) {
    const double tau = provableTolerance(draft);
    std::vector<int> below;
    for (int f = 0; f < cast.faceCount(); ++f) {
        stopPointAt(f);
        const int side = labels[static_cast<std::size_t>(f)];
        const bool leaves = side != 0 && leavesAlong(cast.corner(f, 0), cast.corner(f, 1), cast.corner(f, 2),
                                                     d.of(side), tau);
        if (!leaves)
            below.push_back(f);
    }
    return below;
}

/// The smallest angle between a face and its direction, in degrees, rounded down. A face without a side
/// counts with the worse of both.
double worstDraft(const IndexedMesh& cast, const SideLabels& labels, const Directions& directions) {
    double worst = 90;
    for (int f = 0; f < cast.faceCount(); ++f) {
        stopPointAt(f);
        const Vector3d c = accurateAreaVector(cast.corner(f, 0), cast.corner(f, 1), cast.corner(f, 2));
        for (const int side : {1, 2}) {
            const int label = labels[static_cast<std::size_t>(f)];
            if (label != 0 && label != side)
                continue;
            const Vector3d& d = directions.of(side);
            worst = std::min(worst, degrees(std::atan2(c.dot(d), c.cross(d).norm())));
        }
    }
    // Beyond the error of the angle above; people see fewer digits than these.
    constexpr double digits = 1e6;
    return std::floor((worst - 1e-9) * digits) / digits;
}

/// No point of a face on the wrong side, every curve point on the plane.
bool facesKeepTheirSide(const IndexedMesh& cast, const SideLabels& labels, const PartingPlane& plane) {
    const double tolerance = onPlaneTolerance(cast);
    for (int f = 0; f < cast.faceCount(); ++f) {
        stopPointAt(f);
        for (int k = 0; k < 3; ++k) {
            const double height = plane.distance(cast.corner(f, k));
            const int side = labels[static_cast<std::size_t>(f)];
            if ((side != 2 && height < -tolerance) || (side != 1 && height > tolerance))
                return false;
        }
    }
    return true;
}

bool nested(const IndexedMesh& cast, const std::vector<PartingCurve>& curves, const Directions& directions) {
    const CurveNesting above = nestingAlong(cast.V, curves, directions.d1);
    const CurveNesting below = nestingAlong(cast.V, curves, directions.d2, true);
    return above.simple && above.alternating && below.simple && below.alternating;
}

std::string reasonOf(const Certificate& c, std::size_t faces) {
    if (!c.closedAndOutward)
        return "The surface is not closed, manifold and outward.";
    if (!c.directionsLeave)
        return "A removal direction does not leave the parting plane on its side.";
    if (!c.draftHolds)
        return readable(static_cast<double>(c.violatingFaces.size()), 9) + " of " +
               readable(static_cast<double>(faces), 9) + " faces are below the draft angle.";
    if (!c.curvesOnPlane)
        return "A face lies on the wrong side of the parting plane.";
    if (!c.curvesSimpleAndNested)
        return "The parting curves, seen along a removal direction, cross, touch or are nested wrongly.";
    if (!c.selfIntersectionFree)
        return "The surface crosses itself.";
    return {};
}

} // namespace

double provableTolerance(double draftDegrees) {
    // sin of the rounded radians is within 3 ulps of the true value.
    double tau = std::sin(radians(draftDegrees));
    for (int ulp = 0; ulp < 4 && tau > 0; ++ulp)
        tau = std::nextafter(tau, 2.0);
    return tau;
}

double onPlaneTolerance(const IndexedMesh& cast) {
    const auto largest = static_cast<float>(cast.V.size() == 0 ? 0.0 : cast.V.cwiseAbs().maxCoeff());
    return 4.0 * (std::nextafter(largest, std::numeric_limits<float>::infinity()) - largest);
}

Certificate certify(const IndexedMesh& cast, const SideLabels& labels, const MoldState& state,
                    double draftDegrees) {
    Certificate result;
    const MeshDiagnosis diagnosis = diagnose(cast);
    result.closedAndOutward = diagnosis.closed && diagnosis.manifold && diagnosis.oriented &&
                              diagnosis.degenerateFaces.empty() && cast.faceCount() > 0;
    result.selfIntersectionFree = diagnosis.selfIntersections.empty();
    // Clear of what rounding can do to the product of two unit vectors.
    constexpr double clear = 1e-9;
    result.directionsLeave = state.directions.d1.dot(state.plane.normal) > clear &&
                             state.directions.d2.dot(state.plane.normal) < -clear;
    result.violatingFaces = facesBelowDraft(cast, labels, state.directions, draftDegrees);
    result.draftHolds = result.violatingFaces.empty();
    result.worstDraftDegrees = worstDraft(cast, labels, state.directions);
    const bool allLabelled = std::find(labels.begin(), labels.end(), 0) == labels.end();
    result.curvesOnPlane = allLabelled && facesKeepTheirSide(cast, labels, state.plane);
    if (result.closedAndOutward && allLabelled) {
        const auto curves = partingCurves(cast, labels);
        result.curvesSimpleAndNested = curves && !curves->empty() && nested(cast, *curves, state.directions);
    }
    result.reason = reasonOf(result, static_cast<std::size_t>(cast.faceCount()));
    return result;
}

SideLabels labelSides(const IndexedMesh& cast, const PartingPlane& plane) {
    const double tolerance = onPlaneTolerance(cast);
    SideLabels labels(static_cast<std::size_t>(cast.faceCount()), 0);
    for (int f = 0; f < cast.faceCount(); ++f) {
        stopPointAt(f);
        bool above = false;
        bool below = false;
        for (int k = 0; k < 3; ++k) {
            const double height = plane.distance(cast.corner(f, k));
            above = above || height > tolerance;
            below = below || height < -tolerance;
        }
        std::uint8_t& label = labels[static_cast<std::size_t>(f)];
        if (above != below)
            label = above ? 1 : 2;
        else if (!above)
            label = doubleAreaVector(cast, f).dot(plane.normal) > 0 ? 1 : 2;
    }
    return labels;
}

} // namespace moldwright
