// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/plane_search.h"
#include "design/design_run.h"

#include <optional>
#include <vector>

namespace moldwright {

/// A state, and the share of the part's volume that filling all would take there; see estimatedFill().
struct FillableState {
    MoldState state;
    double filled = 0;
};

/// The states (plane and directions) that a design tries, one after the other: the given plane alone, or the
/// best planes of the part that pass the topological certificate. The preferred plane comes first. Where it
/// does not serve, planes near it hardly will: next come planes that lean clearly differently from all
/// before, by their energy alone (the preference for volume on both sides does not count any more), then the
/// rest. Planes that lean otherwise than all of these follow: a coil is parted well square to its axis,
/// although nearly all of it must be bent then. Each is tested only when its turn comes.
class MoldStates {
public:
    /// `shape` (part frame) and `run` must outlive it. Errors: Cancelled.
    [[nodiscard]] static Result<MoldStates> create(const IndexedMesh& shape, DesignRun& run);

    /// The next state; none when there is no further one that passes, or the run was stopped.
    [[nodiscard]] std::optional<MoldState> next();

    /// Whether none of the best planes passed, of those whose turn has come.
    [[nodiscard]] bool onlyOthersPassed() const { return !m_bestPassed; }

    /// The state of least energy, whether it passes or not.
    [[nodiscard]] const MoldState& best() const { return m_best; }

    /// Of all states, passing or not, the one at which filling all takes the least.
    [[nodiscard]] FillableState leastToFill() const;

private:
    MoldStates(const IndexedMesh& shape, DesignRun& run) : m_shape(&shape), m_run(&run) {}
    void addOtherPlanes();
    [[nodiscard]] MoldState stateAt(const MoldState& candidate) const;
    [[nodiscard]] std::optional<MoldState> takeIfPassing(std::size_t i);

    const IndexedMesh* m_shape;
    DesignRun* m_run;
    MoldState m_best;
    struct Candidate {
        MoldState state;
        bool isBest; ///< of the search; else one that leans otherwise
    };
    std::vector<Candidate> m_all;
    std::vector<Candidate> m_left; ///< not yet tested, in the order to try
    bool m_bestPassed = false;
    std::vector<Eigen::Vector3d> m_normals; ///< of those handed out
};

} // namespace moldwright
