// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/wire.h"
#include "mesh/tet_mesh.h"
#include "worker/jobs.h"

#include <tetgen.h>

namespace moldwright {

namespace {

void setPoints(tetgenio& in, const Points& V) {
    in.numberofpoints = static_cast<int>(V.rows());
    in.pointlist = new REAL[static_cast<std::size_t>(V.size())];
    std::copy_n(V.data(), V.size(), in.pointlist);
}

void setFacets(tetgenio& in, const Triangles& F) {
    in.numberoffacets = static_cast<int>(F.rows());
    in.facetlist = new tetgenio::facet[static_cast<std::size_t>(F.rows())];
    for (int f = 0; f < in.numberoffacets; ++f) {
        tetgenio::facet& facet = in.facetlist[f];
        tetgenio::init(&facet);
        facet.numberofpolygons = 1;
        facet.polygonlist = new tetgenio::polygon[1];
        tetgenio::polygon& polygon = facet.polygonlist[0];
        tetgenio::init(&polygon);
        polygon.numberofvertices = 3;
        polygon.vertexlist = new int[3]{F(f, 0), F(f, 1), F(f, 2)};
    }
}

} // namespace

Result<std::string> tetrahedralizeJob(const std::string& request) {
    WireReader reader(request);
    std::string switches = reader.text() + "Q";
    const auto V = reader.matrix<Points>();
    const auto F = reader.matrix<Triangles>();
    const auto inside = reader.matrix<Points>();
    if (!reader.whole() || F.rows() == 0 || F.minCoeff() < 0 || F.maxCoeff() >= V.rows())
        return failure(ErrorCode::Worker, MW_TEXT("exchange", "The worker program was asked for nothing."));
    tetgenio in;
    tetgenio inner;
    tetgenio out;
    setPoints(in, V);
    setFacets(in, F);
    setPoints(inner, inside);
    try {
        ::tetrahedralize(switches.data(), &in, &out, &inner);
    } catch (int code) { // TetGen throws plain numbers
        return failure(ErrorCode::Worker, MW_TEXT("exchange", "TetGen gave up on this surface (code {0})."),
                       {std::to_string(code)});
    }
    WireWriter answer;
    answer.matrix(Eigen::Map<const Points>(out.pointlist, out.numberofpoints, 3));
    answer.matrix(Eigen::Map<const Tetrahedra>(out.tetrahedronlist, out.numberoftetrahedra, 4));
    return answer.bytes();
}

} // namespace moldwright
