// SPDX-License-Identifier: AGPL-3.0-or-later
#include "castability/cast_analysis.h"

#include "mesh/measures.h"

#include <algorithm>
#include <cassert>

namespace moldwright {

namespace {

/// Draft of each face against its own side's direction; `violating` says which faces count as undercut.
template <class Violating>
DraftAnalysis analyzeBySide(const IndexedMesh& cast, const SideLabels& labels, const MoldState& state,
                            double requiredDegrees, const Violating& violating) {
    assert(static_cast<int>(labels.size()) == cast.faceCount());
    DraftAnalysis analysis;
    analysis.faceDraft.assign(labels.size(), 90);
    analysis.violating.assign(labels.size(), 0);
    const double tau = std::sin(radians(requiredDegrees));
    double whole = 0;
    for (int f = 0; f < cast.faceCount(); ++f) {
        const Eigen::Vector3d c = doubleAreaVector(cast, f);
        const double area = c.norm() / 2;
        const double cosine = area > 0 ? c.normalized().dot(state.directions.of(labels[f])) : 1;
        analysis.violating[f] = violating(f, cosine < tau);
        whole += area;
        if (area == 0)
            continue;
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

} // namespace

DraftAnalysis analyzeCast(const IndexedMesh& cast, const SideLabels& labels, const MoldState& state,
                          double requiredDegrees, const Certificate& certificate) {
    std::vector<std::uint8_t> proved(labels.size(), 1);
    for (const int f : certificate.violatingFaces)
        proved[f] = 0;
    return analyzeBySide(cast, labels, state, requiredDegrees, [&](int f, bool) { return !proved[f]; });
}

DraftAnalysis analyzeCast(const IndexedMesh& cast, const SideLabels& labels, const MoldState& state,
                          double requiredDegrees) {
    return analyzeBySide(cast, labels, state, requiredDegrees, [](int, bool below) { return below; });
}

} // namespace moldwright
