// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/message.h"
#include "base/result.h"
#include "base/task.h"
#include "mesh/indexed_mesh.h"

#include <string>
#include <vector>

namespace moldwright {

/// A mesh that can be designed with, made from one that could not.
struct RepairedMesh {
    IndexedMesh mesh;
    std::vector<Message> repairs; ///< what was done, in order
    double movedBy =
        0; ///< mm, the file's unit: 0 where faces that were sound stay; else how far all may have moved
};

/// Repairs a mesh until examine() finds no fault with it. First its faults are mended one by one, its sound
/// faces staying (mendSurface()); where that does not help, or would lose more than a fiftieth of the
/// surface, a closed skin is made about it, within 1/600 of its diagonal (wrapSurface()). Closed surfaces
/// inside others are dropped. Both run in the worker program. `name` is the file's name for messages. Errors:
/// BadInput where nothing helps, Worker, Cancelled.
[[nodiscard]] Result<RepairedMesh> repairMesh(const IndexedMesh& mesh, const std::string& name,
                                              const Task& task = {});

} // namespace moldwright
