// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "base/task.h"
#include "deformation/local_global.h"
#include "design/design.h"
#include "design/placed_pin.h"
#include "design/working_frame.h"

#include <functional>
#include <memory>

namespace moldwright {

/// How the paper's deformation runs. [Stein 2019], Sections 5.2 to 5.4.
struct ElastoplasticSettings {
    double smoothing = 0.1;     ///< γ of Eq. (6)
    int iterationsPerStep = 15; ///< local-global iterations before a plastic restart
    bool optimizeDirections = true;
    double draftDegrees = 1;
    DirectionLimits limits;
};

/// The paper's elastoplastic deformation as a thing that steps: each step optimises the directions, runs
/// local-global iterations with castability enforced, and restarts plastically. Pins and importance may
/// change between steps. Nothing is split: sides are by the faces' points, faces that cross the plane are
/// left alone.
class Elastoplastic {
public:
    /// Fills the part with tetrahedra. `pins` that lie inside, not just below the surface, become points of
    /// them. Errors: Worker, Cancelled.
    [[nodiscard]] static Result<Elastoplastic> create(SharedMesh part, const MoldState& state,
                                                      const ElastoplasticSettings& settings, const Task& task,
                                                      const std::vector<Pin>& pins = {});

    /// Points of the part that may move only in the plane (part frame, undeformed): the nearest one to each
    /// pin.
    void setPins(const std::vector<Pin>& pins);
    /// Where those of setPins() are now, part frame, one a pin.
    [[nodiscard]] std::vector<PlacedPin> pins() const;
    /// Bends the part as a whole until the pins of setPins() lie in the plane, and takes that for its shape.
    void drawPins(const Task& task);
    /// Other settings and directions, from the next step on.
    void change(const ElastoplasticSettings& settings, const Directions& directions);
    /// Importance per face of the part; empty: all 1.
    void setFaceWeights(const std::vector<double>& weights);

    /// One step of Algorithm 1, lines 50 and 60. `task` is asked before each iteration.
    void step(const Task& task);

    /// The shape now, part frame; faces as in the part.
    [[nodiscard]] IndexedMesh shape() const;
    [[nodiscard]] const MoldState& state() const { return m_state; }
    [[nodiscard]] int steps() const { return m_steps; }
    [[nodiscard]] int iterations() const { return m_iterations; }
    [[nodiscard]] int tets() const { return static_cast<int>(m_solver.shape().T.rows()); }

private:
    Elastoplastic(SharedMesh part, const MoldState& state, const ElastoplasticSettings& settings,
                  WorkingFrame frame, BodyShape body);
    [[nodiscard]] SideLabels sides() const;

    SharedMesh m_part;
    MoldState m_state;
    ElastoplasticSettings m_settings;
    WorkingFrame m_frame;
    Points m_undeformed;       ///< working frame
    std::vector<int> m_pinned; ///< the point that each pin holds
    LocalGlobal m_solver;
    int m_steps = 0;
    int m_iterations = 0;
};

/// Post-processing of the paper: minimises Eq. (2) over the points of `shape`, faces that cross the plane
/// included. Points of the surface that `pins` hold stay in the plane. [Stein 2019], Algorithm 1, line 100.
[[nodiscard]] IndexedMesh postProcess(const IndexedMesh& shape, const MoldState& state, double draftDegrees,
                                      const Task& task, const std::vector<PlacedPin>& pins = {});

} // namespace moldwright
