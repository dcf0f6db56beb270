// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/variant_figures.h"

#include "castability/certificate.h"
#include "design/comparison.h"
#include "design/strain.h"
#include "mesh/measures.h"
#include "mold/mold.h"
#include "project/variants.h"

#include <numeric>
#include <vector>

namespace moldwright {

namespace {

double strainOf(const CastResult& cast) {
    std::vector<int> same(static_cast<std::size_t>(cast.mesh->vertexCount()));
    std::iota(same.begin(), same.end(), 0);
    return surfaceStrain({cast.before, cast.mesh->F}, *cast.mesh, same).rms;
}

} // namespace

VariantFigures variantFigures(const IndexedMesh& part, const Variant& variant) {
    const CastResult& cast = *variant.cast;
    const Certificate proof = certify(*cast.mesh, cast.labels, cast.state, cast.draftDegrees);
    VariantFigures figures;
    figures.castable = proof.holds();
    figures.worstDraftDegrees = proof.worstDraftDegrees;
    figures.largestDistance = cast.change.maxDistance * diagonal(part);
    if (cast.before.rows() > 0) {
        figures.strain = strainOf(cast);
        figures.rmsDistance = rmsDistance(part, *cast.mesh, cast.before);
    }
    figures.filledVolume = cast.change.filledVolumeFraction * volume(part);
    if (const auto size = blockSize(trayOf(variant, {}), cast.draftDegrees, variant.mold))
        figures.blockSize = *size;
    figures.steps = cast.steps;
    return figures;
}

} // namespace moldwright
