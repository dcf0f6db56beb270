// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mold/drawing.h"

#include "castability/parting_curves.h"
#include "mold/section.h"

#include <array>
#include <iomanip>
#include <map>
#include <set>
#include <sstream>

namespace moldwright {

namespace {

using Eigen::Vector2d;
using Eigen::Vector3d;
using Curves = std::vector<std::vector<Vector2d>>;

/// Which coordinates of the mold's frame run to the right and up.
struct View {
    int right = 0;
    int up = 1;

    [[nodiscard]] Vector2d of(const Vector3d& p) const { return {p[right], p[up]}; }
};

/// Segments of closed outlines joined to curves; where four meet, whichever comes first.
Curves chained(const Section& section, const View& view) {
    std::multimap<int, std::size_t> at;
    for (std::size_t s = 0; s < section.outline.size(); ++s)
        for (const int end : section.outline[s])
            at.emplace(end, s);
    std::set<std::size_t> used;
    Curves curves;
    for (std::size_t first = 0; first < section.outline.size(); ++first) {
        if (!used.insert(first).second)
            continue;
        const int start = section.outline[first][0];
        int end = section.outline[first][1];
        std::vector<Vector2d> curve{view.of(section.fill.point(start))};
        for (bool found = true; found && end != start;) {
            curve.push_back(view.of(section.fill.point(end)));
            found = false;
            const auto [low, high] = at.equal_range(end);
            for (auto next = low; next != high && !found; ++next)
                if (used.insert(next->second).second) {
                    const auto& segment = section.outline[next->second];
                    end = segment[0] == end ? segment[1] : segment[0];
                    found = true;
                }
        }
        curves.push_back(std::move(curve));
    }
    return curves;
}

Curves cutCurves(const IndexedMesh& mesh, const PartingPlane& cut, const View& view) {
    return chained(sectionOf(mesh, cut), view);
}

Eigen::AlignedBox2d boxOf(const Drawing& drawing) {
    Eigen::AlignedBox2d box(Vector2d::Zero());
    for (const DrawingLayer& layer : drawing.layers)
        for (const auto& curve : layer.curves)
            for (const Vector2d& p : curve)
                box.extend(p);
    return box;
}

} // namespace

Drawing planDrawing(const Mold& mold) {
    const View view{0, 1};
    Drawing drawing{"Parting plane", {}};
    const auto curves = partingCurves(*mold.cast, labelSides(*mold.cast, {}));
    DrawingLayer line{"PARTING_LINE", {}};
    if (curves)
        for (const PartingCurve& curve : *curves) {
            line.curves.emplace_back();
            for (const int v : curve)
                line.curves.back().push_back(view.of(mold.cast->point(v)));
        }
    drawing.layers.push_back(std::move(line));
    drawing.layers.push_back({"HALF_1", cutCurves(*mold.half1.mesh, {-Vector3d::UnitZ(), 0}, view)});
    drawing.layers.push_back({"HALF_2", cutCurves(*mold.half2.mesh, {Vector3d::UnitZ(), 0}, view)});
    return drawing;
}

Drawing sectionDrawing(const Mold& mold, int axis) {
    const View view{1 - axis, 2};
    Vector3d place = Vector3d::Zero();
    for (const MoldFeature& feature : mold.features)
        if (feature.kind == "cavity") {
            place = feature.place;
            break;
        }
    const PartingPlane cut{Vector3d::Unit(axis), place[axis]};
    Drawing drawing{axis == 0 ? "Section across x" : "Section across y", {}};
    drawing.layers.push_back({"HALF_1", cutCurves(*mold.half1.mesh, cut, view)});
    drawing.layers.push_back({"HALF_2", cutCurves(*mold.half2.mesh, cut, view)});
    drawing.layers.push_back({"CAST", cutCurves(*mold.cast, cut, view)});
    return drawing;
}

std::string svgOf(const Drawing& drawing) {
    constexpr std::array<const char*, 3> colours = {"#c0392b", "#1f4e79", "#3a7d44"};
    constexpr double margin = 5;
    const Eigen::AlignedBox2d box = boxOf(drawing);
    const Vector2d size = box.sizes() + Vector2d::Constant(2 * margin);
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << std::setprecision(9) << "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"" << size.x()
        << "mm\" height=\"" << size.y() << "mm\" viewBox=\"" << box.min().x() - margin << ' '
        << -box.max().y() - margin << ' ' << size.x() << ' ' << size.y() << "\">\n<title>" << drawing.title
        << "</title>\n";
    for (std::size_t i = 0; i < drawing.layers.size(); ++i) {
        const DrawingLayer& layer = drawing.layers[i];
        out << "<path id=\"" << layer.name << "\" fill=\"none\" stroke-width=\"0.2\" stroke=\""
            << colours[i % colours.size()] << "\" d=\"";
        for (const auto& curve : layer.curves) {
            for (std::size_t k = 0; k < curve.size(); ++k)
                out << (k == 0 ? "M" : "L") << curve[k].x() << ' ' << -curve[k].y();
            out << "Z";
        }
        out << "\"/>\n";
    }
    out << "</svg>\n";
    return out.str();
}

std::string dxfOf(const Drawing& drawing) {
    std::ostringstream out;
    out.imbue(std::locale::classic());
    out << std::setprecision(9)
        << "0\nSECTION\n2\nHEADER\n9\n$ACADVER\n1\nAC1009\n9\n$INSUNITS\n70\n4\n0\nENDSEC\n"
        << "0\nSECTION\n2\nTABLES\n0\nTABLE\n2\nLAYER\n70\n"
        << drawing.layers.size() << "\n";
    for (std::size_t i = 0; i < drawing.layers.size(); ++i)
        out << "0\nLAYER\n2\n" << drawing.layers[i].name << "\n70\n0\n62\n" << i + 1 << "\n6\nCONTINUOUS\n";
    out << "0\nENDTAB\n0\nENDSEC\n0\nSECTION\n2\nENTITIES\n";
    for (const DrawingLayer& layer : drawing.layers)
        for (const auto& curve : layer.curves) {
            out << "0\nPOLYLINE\n8\n" << layer.name << "\n66\n1\n10\n0\n20\n0\n30\n0\n70\n1\n";
            for (const Vector2d& p : curve)
                out << "0\nVERTEX\n8\n"
                    << layer.name << "\n10\n"
                    << p.x() << "\n20\n"
                    << p.y() << "\n30\n0\n";
            out << "0\nSEQEND\n8\n" << layer.name << "\n";
        }
    out << "0\nENDSEC\n0\nEOF\n";
    return out.str();
}

} // namespace moldwright
