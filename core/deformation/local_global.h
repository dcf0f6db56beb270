// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "deformation/elastic_body.h"
#include "deformation/plane_system.h"
#include "deformation/rotation_smoothing.h"

#include <Eigen/Geometry>

#include <vector>

namespace moldwright {

/// The elastoplastic deformation's elastic part: alternates between rotations (local) and positions (global),
/// turning elements at surface faces that violate removability until they would pass. [Stein 2019],
/// Sections 5.2 to 5.4. Lives in the plane's frame; points held in the plane keep z = 0; without held points
/// the centroid stays.
class LocalGlobal {
public:
    /// `held`: 1 for points that may move only in the plane. `smoothing`: γ of Eq. (6).
    LocalGlobal(BodyShape shape, std::vector<char> held, double smoothing);

    /// One iteration. `sides`: the side of each surface face; 0 leaves a face alone (it crosses the plane).
    /// Returns the mean square of the points' motion.
    double iterate(const SideLabels& sides, const Directions& directions, double tau);

    /// Plastic restart: what is now becomes the rest shape, with its own cotangent weights. [Stein 2019],
    /// Section 5.3.
    void restart();

    [[nodiscard]] const Positions& positions() const { return m_X; }
    void setPositions(const Positions& X) { m_X = X; }
    [[nodiscard]] const BodyShape& shape() const { return m_shape; }
    [[nodiscard]] const PlaneSystem& system() const { return m_system; }

    /// Changes what is held or how important things are, from the next iteration on.
    void setHeld(std::vector<char> held);
    void setTetWeights(std::vector<double> weights);
    /// γ of Eq. (6).
    void setSmoothing(double smoothing) { m_smoothing = smoothing; }

private:
    /// A lane with a surface face whose draft it must have.
    struct LaneOfFace {
        int lane;
        int face;
    };

    void prepare();
    void listLanesOfFaces();
    void enforce(const SideLabels& sides, const Directions& directions, double tau);

    BodyShape m_shape;
    std::vector<char> m_held;
    double m_smoothing;
    ElasticBody m_body;
    RotationSmoothing m_neighbours;
    PlaneSystem m_system;
    Positions m_X;
    Rotations m_rotations;
    Rotations m_smoothed;
    std::vector<LaneOfFace>
        m_lanesOfFaces;   ///< sorted by lane: an element with several faces has them together
    Points m_restNormals; ///< of the surface faces
};

} // namespace moldwright
