// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "base/task.h"
#include "mold/mold.h"

#include <filesystem>
#include <string>

namespace moldwright {

/// What is written beside STL, 3MF and JSON.
struct MoldFormats {
    bool obj = false; ///< mold-half-1.obj, mold-half-2.obj, mold-cast.obj
    bool ply = false; ///< the same as PLY
    bool svg = false; ///< mold-plan.svg, mold-section-x.svg, mold-section-y.svg
    bool dxf = false; ///< the same as DXF
};

/// Writes mold-half-1.stl, mold-half-2.stl, mold-cast.stl (mold's frame), mold.3mf (halves and cast side by
/// side on a plate, parting faces up) and mold.json into `folder`, which is made when missing. Each file
/// appears whole or not at all. Errors: WriteFailed; Cancelled, which leaves the files that were whole by
/// then.
[[nodiscard]] Result<void> writeMold(const Mold& mold, const std::string& partName,
                                     const std::filesystem::path& folder, const MoldFormats& also = {},
                                     const Task& task = {});

/// mold.json: what the mold is and what was proved of it. Keys are a contract of the command line; lengths in
/// mm, volumes in mm³, areas in mm², force in kN, angles in degrees.
[[nodiscard]] std::string moldJson(const Mold& mold);

} // namespace moldwright
