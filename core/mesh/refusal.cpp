// SPDX-License-Identifier: AGPL-3.0-or-later
#include "mesh/refusal.h"

#include "mesh/measures.h"
#include "mesh/nesting.h"

#include <cmath>

namespace moldwright {

namespace {

// Below this share of the diagonal a part is a sheet, and with its cube, a closed surface: nothing to cast.
constexpr double leastThickness = 1e-12;

std::string inWords(const Eigen::Vector3d& p) {
    return "(" + readable(p.x(), 6) + ", " + readable(p.y(), 6) + ", " + readable(p.z(), 6) + ")";
}

Eigen::Vector3d centreOf(const IndexedMesh& mesh, int f) {
    return (mesh.corner(f, 0) + mesh.corner(f, 1) + mesh.corner(f, 2)) / 3;
}

Error refusedAt(std::string text, std::vector<std::string> arguments, std::vector<Eigen::Vector3d> places) {
    arguments.push_back(inWords(places.front()));
    return {ErrorCode::BadInput, {std::move(text), std::move(arguments)}, {}, std::move(places)};
}

Error flat(const std::string& name) {
    return {ErrorCode::BadInput,
            {MW_TEXT("mesh", "{0} encloses no volume, so there is nothing to cast."), {name}},
            {},
            {}};
}

Error open(const IndexedMesh& mesh, const MeshDiagnosis& found, const std::string& name) {
    return refusalAtFaces(
        mesh,
        found.boundaryLoops == 1
            ? MW_TEXT("mesh",
                      "The surface of {0} has a hole, near {2}, so it has no inside to cast. Close it in the "
                      "program that made the file.")
            : MW_TEXT("mesh",
                      "The surface of {0} has {1} holes, one near {2}, so it has no inside to cast. Close "
                      "them in the program that made the file."),
        {name, std::to_string(found.boundaryLoops)}, found.openFaces);
}

Error crowded(const IndexedMesh& mesh, const MeshDiagnosis& found, const std::string& name) {
    return refusalAtFaces(mesh,
                          MW_TEXT("mesh",
                                  "In {0} more than two faces meet at an edge: {1} faces are concerned, one "
                                  "near {2}. Separate the parts, or join them, in the program that made "
                                  "the file."),
                          {name, std::to_string(found.crowdedFaces.size())}, found.crowdedFaces);
}

Error pinched(const IndexedMesh& mesh, const MeshDiagnosis& found, const std::string& name) {
    std::vector<Eigen::Vector3d> places;
    for (const int v : found.pinchedPoints)
        places.push_back(mesh.point(v));
    return refusedAt(
        places.size() == 1
            ? MW_TEXT("mesh", "The surface of {0} touches itself in a single point, at {2}. Separate it "
                              "there in the program that made the file.")
            : MW_TEXT("mesh", "The surface of {0} touches itself in {1} single points, one at {2}. "
                              "Separate it there in the program that made the file."),
        {name, std::to_string(places.size())}, places);
}

Error withoutArea(const IndexedMesh& mesh, const MeshDiagnosis& found, const std::string& name) {
    return refusalAtFaces(
        mesh,
        found.degenerateFaces.size() == 1
            ? MW_TEXT("mesh", "A face of {0} has no area, near {2}. Clean the mesh in the program "
                              "that made the file.")
            : MW_TEXT("mesh", "{1} faces of {0} have no area, one near {2}. Clean the mesh in the "
                              "program that made the file."),
        {name, std::to_string(found.degenerateFaces.size())}, found.degenerateFaces);
}

Error crossing(const IndexedMesh& mesh, const MeshDiagnosis& found, const std::string& name) {
    std::vector<int> faces;
    for (const auto& [f, g] : found.selfIntersections)
        faces.insert(faces.end(), {f, g});
    return refusalAtFaces(
        mesh,
        found.selfIntersections.size() == 1
            ? MW_TEXT("mesh", "{0} crosses itself in one place, near {2}. A proof needs a surface "
                              "that does not.")
            : MW_TEXT("mesh", "{0} crosses itself in {1} places, one near {2}. A proof needs a "
                              "surface that does not."),
        {name, std::to_string(found.selfIntersections.size())}, std::move(faces));
}

Error nested(const IndexedMesh& mesh, const MeshDiagnosis& found, const std::string& name) {
    const Components components = connectedComponents(mesh);
    const int first = componentsInsideOthers(mesh, components).front();
    std::vector<int> faces;
    for (int f = 0; f < mesh.faceCount(); ++f)
        if (components.ofFace[static_cast<std::size_t>(f)] == first)
            faces.push_back(f);
    return refusalAtFaces(
        mesh,
        found.nested == 1
            ? MW_TEXT("mesh", "{0} holds a closed surface inside another, near {2}. A closed cavity "
                              "cannot be cast in a two-piece mold. Remove it, or open it to the "
                              "outside.")
            : MW_TEXT("mesh", "{0} holds {1} closed surfaces inside others, one near {2}. A closed "
                              "cavity cannot be cast in a two-piece mold. Remove them, or open "
                              "them to the outside."),
        {name, std::to_string(found.nested)}, std::move(faces));
}

} // namespace

Error refusalAtFaces(const IndexedMesh& mesh, std::string text, std::vector<std::string> arguments,
                     std::vector<int> faces) {
    std::vector<Eigen::Vector3d> places;
    for (const int f : faces)
        places.push_back(centreOf(mesh, f));
    Error error = refusedAt(std::move(text), std::move(arguments), std::move(places));
    error.faces = std::move(faces);
    return error;
}

Error oneSidedRefusal(const IndexedMesh& mesh, const std::vector<int>& faces, const std::string& name) {
    return refusalAtFaces(mesh,
                          MW_TEXT("mesh",
                                  "The surface of {0} has only one side: its faces cannot all look outward, "
                                  "as near {1}. It has no inside to cast."),
                          {name}, faces);
}

std::vector<Error> refusals(const IndexedMesh& mesh, const MeshDiagnosis& found, const std::string& name) {
    if (!(boundingBox(mesh).sizes().minCoeff() > leastThickness * diagonal(mesh)))
        return {flat(name)};
    std::vector<Error> faults;
    if (!found.openFaces.empty())
        faults.push_back(open(mesh, found, name));
    if (!found.crowdedFaces.empty())
        faults.push_back(crowded(mesh, found, name));
    // What an open surface encloses is anyone's guess.
    if (found.closed && !(found.volume > leastThickness * std::pow(diagonal(mesh), 3)))
        faults.push_back(flat(name));
    if (!found.pinchedPoints.empty())
        faults.push_back(pinched(mesh, found, name));
    if (!found.degenerateFaces.empty())
        faults.push_back(withoutArea(mesh, found, name));
    if (!found.selfIntersections.empty())
        faults.push_back(crossing(mesh, found, name));
    if (found.nested > 0)
        faults.push_back(nested(mesh, found, name));
    return faults;
}

} // namespace moldwright
