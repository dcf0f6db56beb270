// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/half_layer.h"

#include <array>

namespace moldwright::scene {

/// How a mold is open.
struct Opening {
    /// How far each half has left along its direction: 1 is half of the part's diagonal.
    double apart = 0;
    /// 0 to 1: how far half 1 is turned over to lie beside half 2, like a book, both parting faces to the
    /// same side; on that way they come back along their directions. Seen from there half 1 is to the right.
    double beside = 0;
};

/// The mold on its way from closed (0) over open (0.5) to lying open like a book (1).
[[nodiscard]] Opening openingAt(double share);

/// Both halves of a mold in the view.
class OpenedMold {
public:
    explicit OpenedMold(vtkRenderer* renderer) : m_halves{HalfLayer(renderer), HalfLayer(renderer)} {}

    /// Meshes in the mold's frame; null for none.
    void set(const std::array<SharedDrawnMesh, 2>& halves, const Eigen::Isometry3d& moldToPart,
             const Directions& directions, const std::array<Rgb, 2>& colours);
    /// `size`: the part's diagonal, mm.
    void open(const Opening& opening, double size);

    [[nodiscard]] MeshLayer& half(int side) { return m_halves.at(side - 1).layer(); }
    [[nodiscard]] const MeshLayer& half(int side) const { return m_halves.at(side - 1).layer(); }
    /// How far the halves have left, mm.
    [[nodiscard]] std::array<double, 2> ways() const { return {m_halves[0].way(), m_halves[1].way()}; }
    /// Whether half 1 is turned over, so that nothing is between the halves any more.
    [[nodiscard]] bool turnedOver() const { return half(1).mesh() && m_opening.beside > 0; }
    /// Of both boxes in the part's frame, opened as they are.
    [[nodiscard]] std::vector<Eigen::Vector3d> corners() const;

private:
    void place();
    /// Half 1 on its way over, in the mold's frame.
    [[nodiscard]] Eigen::Isometry3d turnedOverBy(double angle) const;

    std::array<HalfLayer, 2> m_halves;
    Eigen::Vector3d m_spine = Eigen::Vector3d::UnitY(); ///< of the book: a direction in the mold's plane
    Opening m_opening;
    double m_size = 0;
};

} // namespace moldwright::scene
