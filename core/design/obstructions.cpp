// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/obstructions.h"

#include "castability/topology.h"

#include <cmath>

namespace moldwright {

namespace {

/// To a tenth of a millimetre: a place is to be found, not measured.
std::string placeText(const Eigen::Vector3d& p) {
    const auto tenth = [](double x) { return readable(std::round(10 * x) / 10 + 0.0); };
    return "(" + tenth(p.x()) + ", " + tenth(p.y()) + ", " + tenth(p.z()) + ")";
}

Message describe(PieceFault fault, int side, const std::string& place, const std::string& size) {
    const std::vector<std::string> arguments{std::to_string(side), place, size};
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

Obstruction::Kind kindOf(PieceFault fault) {
    switch (fault) {
    case PieceFault::Closed:
        return Obstruction::Kind::ClosedPiece;
    case PieceFault::Handle:
    case PieceFault::Arch:
        return Obstruction::Kind::Handle;
    default:
        return Obstruction::Kind::Pocket;
    }
}

} // namespace

std::vector<Obstruction> findObstructions(const IndexedMesh& parted, const SideLabels& labels,
                                          const WorkingFrame& frame) {
    std::vector<Obstruction> found;
    for (const SidePiece& piece : sidePieces(parted, labels)) {
        const PieceFault fault = pieceFault(parted, piece);
        if (fault == PieceFault::None)
            continue;
        Eigen::AlignedBox3d box;
        for (const int f : piece.faces)
            for (int k = 0; k < 3; ++k)
                box.extend(frame.toPart(parted.corner(f, k)));
        const double size = box.diagonal().norm();
        found.push_back({kindOf(fault),
                         describe(fault, piece.side, placeText(box.center()), readable(size, 3)),
                         box.center(), size, piece.side});
    }
    return found;
}

} // namespace moldwright
