// SPDX-License-Identifier: AGPL-3.0-or-later
#include "samples.h"

namespace moldwright::samples {

std::vector<Sample> allSamples() {
    return {goatHead(), rabbit(), goat(), hand(), fish(), bentBeam(), doorKnob(), praline()};
}

IndexedMesh makeMesh(const Sample& sample) {
    return remesh(contour(sample.solid, 0.8 * sample.fineness.shortest), sample.solid, sample.fineness);
}

} // namespace moldwright::samples
