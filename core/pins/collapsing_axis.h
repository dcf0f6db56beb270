// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "pins/medial_mesh.h"
#include "pins/sphere_quadric.h"

#include <vector>

namespace moldwright {

/// A medial axis whose edges can be collapsed, and what each collapse costs. Balls keep their numbers; a ball
/// merged into another is gone.
class CollapsingAxis {
public:
    explicit CollapsingAxis(const MedialMesh& axis);

    /// What an edge costs to collapse, and the ball that it becomes.
    struct Collapse {
        double cost = 0;
        Sphere ball;
    };
    [[nodiscard]] Collapse collapseOf(int u, int v) const;

    /// Replaces u and v by `ball`; returns the number, u or v, that it has from now on.
    int collapse(int u, int v, const Sphere& ball);

    [[nodiscard]] int ballCount() const { return m_ballCount; }
    [[nodiscard]] int numbers() const { return static_cast<int>(m_spheres.size()); }
    [[nodiscard]] bool gone(int v) const { return m_gone[static_cast<std::size_t>(v)] != 0; }
    /// Rises with every change of the ball's place or planes.
    [[nodiscard]] unsigned age(int v) const { return m_age[static_cast<std::size_t>(v)]; }
    [[nodiscard]] const std::vector<int>& neighbours(int v) const {
        return m_neighbours[static_cast<std::size_t>(v)];
    }

    /// Whether the collapse would take an end, or lay a loop of three edges without a face flat.
    [[nodiscard]] bool losesEndOrLoop(int u, int v) const;

    /// What is left, balls in the order of their numbers.
    [[nodiscard]] MedialMesh axis() const;

private:
    [[nodiscard]] bool joined(int u, int v) const;
    [[nodiscard]] std::vector<std::array<int, 3>> facesAt(int u, int v) const;
    void moveNeighbours(int from, int to);
    void moveTriangles(int from, int to);

    int m_ballCount;
    std::vector<Sphere> m_spheres;
    std::vector<SphereQuadric> m_quadrics;
    std::vector<char> m_gone;
    std::vector<unsigned> m_age;
    std::vector<std::vector<int>> m_neighbours;
    std::vector<std::array<int, 3>> m_triangles; ///< those that collapsed use a ball twice
    std::vector<std::vector<int>> m_trianglesAt; ///< of each ball; some may have collapsed
};

} // namespace moldwright
