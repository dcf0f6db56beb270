// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "base/task.h"
#include "deformation/local_global.h"
#include "design/design.h"
#include "design/placed_pin.h"
#include "design/working_body.h"

#include <vector>

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
/// local-global iterations with castability enforced, and restarts plastically. Importance may change
/// between steps. Nothing is split: sides are by the faces' points, faces that cross the plane are
/// left alone.
class Elastoplastic {
public:
    /// Fills the part with tetrahedra. `pins` (part frame, undeformed) are points of them that may move only
    /// in the plane. `faceWeights`: importance per face of the part; empty: all 1. Errors: Worker, Cancelled.
    [[nodiscard]] static Result<Elastoplastic> create(const IndexedMesh& part, const MoldState& state,
                                                      const ElastoplasticSettings& settings, const Task& task,
                                                      const std::vector<Pin>& pins = {},
                                                      const std::vector<double>& faceWeights = {});

    /// Where the pins are now, part frame, one a pin.
    [[nodiscard]] std::vector<PlacedPin> pins() const { return m_body.pinsAt(m_solver.positions()); }
    /// Other settings and directions, from the next step on.
    void change(const ElastoplasticSettings& settings, const Directions& directions);
    /// Importance per face of the part; empty: all 1.
    void setFaceWeights(const std::vector<double>& weights);

    /// One step of Algorithm 1, lines 50 and 60. `task` is asked before each iteration.
    void step(const Task& task);

    /// The shape now, part frame; faces as in the part.
    [[nodiscard]] IndexedMesh shape() const { return m_body.surfaceAt(m_solver.positions()); }
    [[nodiscard]] const MoldState& state() const { return m_state; }
    [[nodiscard]] int steps() const { return m_steps; }
    [[nodiscard]] int iterations() const { return m_iterations; }
    [[nodiscard]] int tets() const { return static_cast<int>(m_solver.shape().T.rows()); }

private:
    Elastoplastic(WorkingBody body, const MoldState& state, const ElastoplasticSettings& settings);
    [[nodiscard]] SideLabels sides() const;

    WorkingBody m_body;
    MoldState m_state;
    ElastoplasticSettings m_settings;
    LocalGlobal m_solver;
    int m_steps = 0;
    int m_iterations = 0;
};

/// Post-processing of the paper: minimises Eq. (2) over the points of `shape`, faces that cross the plane
/// included. Points of the surface that `pins` hold stay in the plane. [Stein 2019], Algorithm 1, line 100.
[[nodiscard]] IndexedMesh postProcess(const IndexedMesh& shape, const MoldState& state, double draftDegrees,
                                      const Task& task, const std::vector<PlacedPin>& pins = {});

} // namespace moldwright
