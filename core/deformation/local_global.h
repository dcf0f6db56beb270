// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "deformation/elastic_body.h"
#include "deformation/plane_system.h"

#include <Eigen/Geometry>

#include <memory>
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

private:
    void prepare();
    void enforce(const SideLabels& sides, const Directions& directions, double tau);
    void smooth();

    BodyShape m_shape;
    std::vector<char> m_held;
    double m_smoothing;
    std::unique_ptr<ElasticBody> m_body;
    PlaneSystem m_system;
    Positions m_X;
    std::vector<Eigen::Matrix3d> m_rotations;
    std::vector<int> m_tetOfFace; ///< the tetrahedron behind each surface face, −1 for a shell
    std::vector<std::array<int, 4>> m_neighbours; ///< of each tetrahedron across its faces, −1 outside
};

} // namespace moldwright
