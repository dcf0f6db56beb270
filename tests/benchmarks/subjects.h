// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "deformation/local_global.h"
#include "design/design.h"
#include "design/working_frame.h"
#include "mesh/indexed_mesh.h"

#include <benchmark/benchmark.h>

#include <string>

namespace moldwright::bench {

/// What a row of the tables is measured on: a bundled sample, 80 mm long, brought to the number of surface
/// vertices of a row of [Stein 2019], Table 1, by subdivision or decimation; in its best mold state.
struct Subject {
    std::string name;
    SharedMesh part; ///< mm
    MoldState state;
    WorkingFrame frame;
    BodyShape body; ///< working frame, filled with tetrahedra
};

/// The rows' numbers, as arguments of a benchmark: beam, fish, hand, rabbit.
void eachSubject(benchmark::internal::Benchmark* benchmark);

/// The subject that a benchmark's argument names, made when first asked for; the benchmark gets its name as
/// label and its sizes as counters `vertices` and `tets`. Throws when a sample cannot be read or filled.
const Subject& subjectOf(benchmark::State& state);

/// The subject's design as `moldwright-cli design` runs it without options. Throws when it ends in an error.
DesignResult designOf(const Subject& subject);

/// The side of each face of the body at rest, 0 for those that cross the plane.
SideLabels sidesOf(const BodyShape& body);

} // namespace moldwright::bench
