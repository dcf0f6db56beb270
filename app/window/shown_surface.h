// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/analysis.h"
#include "project/project.h"
#include "scene/drawn_mesh.h"
#include "scene/surface_picker.h"

#include <memory>

namespace moldwright {

/// A surface as a view shows it. All null while it is not ready to be drawn.
struct ShownSurface {
    scene::SharedDrawnMesh drawn;
    bool coarse = false;                                ///< only the stand-in's analysis is there
    const DraftAnalysis* analysis = nullptr;            ///< of the surface; of its stand-in when `coarse`
    const DraftAnalysis* standInAnalysis = nullptr;     ///< of a large surface
    std::shared_ptr<const scene::SurfacePicker> picker; ///< null while it is not made
    std::shared_ptr<const Points> before; ///< n×3, mm: where its points were on the part; null: it is the
                                          ///< part, or nobody knows
    const Variant* variant = nullptr;     ///< whose it is; never null

    /// What `analysis` is of.
    [[nodiscard]] SharedMesh analysed() const { return coarse ? drawn->standIn->mesh : drawn->mesh; }
};

} // namespace moldwright
