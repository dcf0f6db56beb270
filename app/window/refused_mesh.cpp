// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/refused_mesh.h"

#include "mesh/measures.h"

#include <QFileInfo>

#include <algorithm>

namespace moldwright {

namespace {

// Views hold floats, and square lengths.
constexpr double smallestShown = 1e-15;
constexpr double largestShown = 1e15;

bool canBeShown(const IndexedMesh& mesh) {
    if (mesh.faceCount() == 0 || !mesh.V.allFinite())
        return false;
    const double size = diagonal(mesh);
    return size > smallestShown && size < largestShown;
}

bool facesTell(const FaultPlace& place) {
    return place.edges.empty();
}

std::vector<int> paintedFaces(const std::vector<FaultPlace>& places) {
    std::vector<int> faces;
    for (const FaultPlace& place : places)
        if (facesTell(place))
            faces.insert(faces.end(), place.faces.begin(), place.faces.end());
    std::ranges::sort(faces);
    const auto twice = std::ranges::unique(faces);
    faces.erase(twice.begin(), twice.end());
    return faces;
}

std::vector<scene::FaultLayer::Edge> edgesOf(const std::vector<FaultPlace>& places, const IndexedMesh& mesh) {
    std::vector<scene::FaultLayer::Edge> edges;
    for (const FaultPlace& place : places)
        for (const auto& [from, to] : place.edges)
            edges.push_back({mesh.point(from), mesh.point(to)});
    return edges;
}

} // namespace

bool RefusedMesh::faultHidden() const {
    return std::ranges::find(places, FaultKind::Enclosed, &FaultPlace::kind) != places.end();
}

std::shared_ptr<const RefusedMesh> refusedMesh(const QString& file, Examination part) {
    if (!canBeShown(part.mesh))
        return nullptr;
    auto refused = std::make_shared<RefusedMesh>();
    refused->file = file;
    refused->name = QFileInfo(file).fileName();
    refused->places = faultPlaces(part);
    refused->paintedFaces = paintedFaces(refused->places);
    refused->edges = edgesOf(refused->places, part.mesh);
    const auto mesh = std::make_shared<const IndexedMesh>(std::move(part.mesh));
    refused->part = std::move(part);
    refused->drawn = scene::drawnMesh(mesh);
    refused->picker = std::make_shared<scene::SurfacePicker>(mesh);
    const std::vector<int>& nearest = refused->drawn->standInFaces;
    for (int f = 0; f < static_cast<int>(nearest.size()); ++f)
        if (std::ranges::binary_search(refused->paintedFaces, nearest[static_cast<std::size_t>(f)]))
            refused->paintedStandIn.push_back(f);
    return refused;
}

} // namespace moldwright
