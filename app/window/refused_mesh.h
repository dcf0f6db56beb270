// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/check.h"
#include "mesh/fault_places.h"
#include "scene/drawn_mesh.h"
#include "scene/fault_layer.h"
#include "scene/surface_picker.h"

#include <QString>

#include <memory>
#include <vector>

namespace moldwright {

/// A mesh that was read but cannot be designed with, ready to be shown with all its faults. Lengths are in
/// the file's unit. It never changes.
struct RefusedMesh {
    QString file;                               ///< where it was read from
    QString name;                               ///< the file's own name
    Examination part;                           ///< what is wrong with it; its mesh is drawn->mesh
    std::vector<FaultPlace> places;             ///< of drawn->mesh
    std::vector<int> paintedFaces;              ///< of all places whose faces tell, ascending
    std::vector<int> paintedStandIn;            ///< the same of its stand-in
    std::vector<scene::FaultLayer::Edge> edges; ///< of all places
    scene::SharedDrawnMesh drawn;
    std::shared_ptr<const scene::SurfacePicker> picker;

    /// Whether something at fault lies within the surface, where only glass shows it.
    [[nodiscard]] bool faultHidden() const;
};

/// Makes one; null where nothing can be shown: no faces, or numbers that no view can hold. Takes its time.
[[nodiscard]] std::shared_ptr<const RefusedMesh> refusedMesh(const QString& file, Examination part);

} // namespace moldwright
