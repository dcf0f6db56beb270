// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "deformation/elastic_body.h"
#include "support/solids.h"

namespace moldwright::test {

/// Two solids that are not joined as one body: the points of `a`, then those of `b`.
inline BodyShape besideEachOther(const Solid& a, const Solid& b) {
    BodyShape body;
    const auto first = static_cast<int>(a.tets.V.rows());
    body.V.resize(first + b.tets.V.rows(), 3);
    body.V << a.tets.V, b.tets.V;
    body.T.resize(a.tets.T.rows() + b.tets.T.rows(), 4);
    body.T << a.tets.T, (b.tets.T.array() + first).matrix();
    body.F.resize(a.F.rows() + b.F.rows(), 3);
    body.F << a.F, (b.F.array() + first).matrix();
    return body;
}

} // namespace moldwright::test
