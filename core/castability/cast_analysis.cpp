// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/cast_analysis.h"

#include "mesh/measures.h"

#include <algorithm>
#include <cassert>

namespace moldwright {

DraftAnalysis analyzeCast(const IndexedMesh& cast, const SideLabels& labels, const MoldState& state,
                          double requiredDegrees, const Certificate& certificate) {
    assert(static_cast<int>(labels.size()) == cast.faceCount());
    DraftAnalysis analysis;
    analysis.faceDraft.assign(labels.size(), 90);
    analysis.violating.assign(labels.size(), 0);
    for (const int f : certificate.violatingFaces)
        analysis.violating[f] = 1;
    const double tau = std::sin(radians(requiredDegrees));
    double whole = 0;
    for (int f = 0; f < cast.faceCount(); ++f) {
        const Eigen::Vector3d c = doubleAreaVector(cast, f);
        const double area = c.norm() / 2;
        whole += area;
        if (area == 0)
            continue;
        const double cosine = c.normalized().dot(state.directions.of(labels[f]));
        analysis.faceDraft[f] = draftDegrees(cosine);
        analysis.worstDraftDegrees = std::min(analysis.worstDraftDegrees, analysis.faceDraft[f]);
        if (!analysis.violating[f])
            continue;
        analysis.violatingArea += area;
        analysis.energy += area * std::pow(std::max(0.0, tau - cosine), 2);
    }
    const double scale = diagonal(cast);
    analysis.energy /= 2 * scale * scale;
    analysis.violatingAreaFraction = whole > 0 ? analysis.violatingArea / whole : 0;
    return analysis;
}

} // namespace moldwright
