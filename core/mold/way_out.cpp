// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/way_out.h"

#include "mold/shrink.h"

namespace moldwright {

std::array<ContactWays, 2> contactsOnTheWayOut(const Mold& mold, const IndexedMesh& cast) {
    Points middles(cast.faceCount(), 3);
    for (int f = 0; f < cast.faceCount(); ++f) {
        const Eigen::Vector3d middle = (cast.corner(f, 0) + cast.corner(f, 1) + cast.corner(f, 2)) / 3;
        const Eigen::Vector3d larger = madeLarger(middle, mold.shrinkFactors, mold.settings.shrink.origin);
        middles.row(f) = (mold.partToMold * larger).transpose();
    }
    return {contactWays(middles, *mold.half1.mesh, mold.directions.d1),
            contactWays(middles, *mold.half2.mesh, mold.directions.d2)};
}

} // namespace moldwright
