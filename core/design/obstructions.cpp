// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/obstructions.h"

#include "castability/topology.h"
#include "mesh/measures.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

namespace moldwright {

namespace {

using Kind = Obstruction::Kind;

Message describe(Kind kind, PieceFault fault, int side, const std::string& place, const std::string& size) {
    const std::vector<std::string> arguments{std::to_string(side), place, size};
    if (kind == Kind::Link)
        return {
            MW_TEXT(
                "design",
                "A piece of {2} mm spans another piece on side {0}, near {1}: they hang in one another, and "
                "no half can leave between them. Take them apart, or have them merged."),
            arguments};
    switch (fault) {
    case PieceFault::Closed:
        return {
            MW_TEXT("design",
                    "A closed piece of {2} mm lies wholly on side {0}, near {1}: it never meets the parting "
                    "plane. Move the plane through it."),
            arguments};
    case PieceFault::Handle:
        return {
            MW_TEXT("design",
                    "A handle of {2} mm stands on side {0}, near {1}: the mold cannot leave its hole. Move "
                    "the plane through the hole, or fill it."),
            arguments};
    case PieceFault::Arch:
        return {
            MW_TEXT("design",
                    "An arch of {2} mm spans a gap on side {0}, near {1}: the mold under it cannot leave. "
                    "Move the plane, or fill the gap."),
            arguments};
    default:
        return {
            MW_TEXT("design",
                    "A pocket of air of {2} mm lies on side {0}, near {1}: the mold in it cannot leave. Move "
                    "the plane, or fill the pocket."),
            arguments};
    }
}

/// Is p under the triangle: between it and the plane, seen along the plane's normal?
bool isUnder(const Eigen::Vector3d& p, const Eigen::Vector3d& a, const Eigen::Vector3d& b,
             const Eigen::Vector3d& c) {
    const auto turn = [&](const Eigen::Vector3d& s, const Eigen::Vector3d& t) {
        return (t - s).x() * (p - s).y() - (t - s).y() * (p - s).x();
    };
    const double wc = turn(a, b);
    const double wa = turn(b, c);
    const double wb = turn(c, a);
    const double sum = wa + wb + wc;
    if (!((wa > 0 && wb > 0 && wc > 0) || (wa < 0 && wb < 0 && wc < 0)))
        return false;
    return (wa * std::abs(a.z()) + wb * std::abs(b.z()) + wc * std::abs(c.z())) / sum > std::abs(p.z());
}

/// Does the arch span a piece of another component on its side? Then the two hang in one another.
bool spansAnother(const IndexedMesh& parted, const SideLabels& labels, const Components& components,
                  const SidePiece& arch) {
    if (components.count < 2)
        return false;
    const int own = components.ofFace[static_cast<std::size_t>(arch.faces.front())];
    Eigen::AlignedBox2d shadow;
    for (const int f : arch.faces)
        for (int k = 0; k < 3; ++k)
            shadow.extend(Eigen::Vector2d(parted.corner(f, k).head<2>()));
    for (int g = 0; g < parted.faceCount(); ++g) {
        const auto other = static_cast<std::size_t>(g);
        const Eigen::Vector3d p = parted.corner(g, 0);
        if (components.ofFace[other] == own || labels[other] != arch.side ||
            !shadow.contains(Eigen::Vector2d(p.head<2>())))
            continue;
        if (std::any_of(arch.faces.begin(), arch.faces.end(), [&](int f) {
                return isUnder(p, parted.corner(f, 0), parted.corner(f, 1), parted.corner(f, 2));
            }))
            return true;
    }
    return false;
}

Kind kindOf(PieceFault fault) {
    switch (fault) {
    case PieceFault::Closed:
        return Kind::ClosedPiece;
    case PieceFault::Handle:
    case PieceFault::Arch:
        return Kind::Handle;
    default:
        return Kind::Pocket;
    }
}

} // namespace

std::string placeText(const Eigen::Vector3d& p) {
    const auto tenth = [](double x) { return readable(std::round(10 * x) / 10 + 0.0); };
    return "(" + tenth(p.x()) + ", " + tenth(p.y()) + ", " + tenth(p.z()) + ")";
}

std::vector<Obstruction> findObstructions(const IndexedMesh& parted, const SideLabels& labels,
                                          const WorkingFrame& frame) {
    std::vector<Obstruction> found;
    const Components components = connectedComponents(parted);
    for (const SidePiece& piece : sidePieces(parted, labels)) {
        const PieceFault fault = pieceFault(parted, piece);
        if (fault == PieceFault::None)
            continue;
        Eigen::AlignedBox3d box;
        for (const int f : piece.faces)
            for (int k = 0; k < 3; ++k)
                box.extend(frame.toPart(parted.corner(f, k)));
        const double size = box.diagonal().norm();
        const bool linked = fault == PieceFault::Arch && spansAnother(parted, labels, components, piece);
        const Kind kind = linked ? Kind::Link : kindOf(fault);
        found.push_back({kind,
                         describe(kind, fault, piece.side, placeText(box.center()), readable(size, 3)),
                         box.center(),
                         size,
                         piece.side,
                         {}});
    }
    return found;
}

} // namespace moldwright
