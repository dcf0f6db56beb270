// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/plane_offers.h"

#include "castability/analysis.h"
#include "design/parting.h"
#include "mesh/measures.h"
#include "panels/picture_list.h"

#include <algorithm>

namespace moldwright {

namespace {

constexpr int planesSearched = 40;
constexpr int planesOffered = 6;
constexpr int picturesFiner = 2; ///< than the list shows them, for fine screens
const Eigen::Vector3d lookedFrom(0.75, -1, 0.6);

PlaneSearch searchFor(const DesignSettings& settings) {
    PlaneSearch search;
    search.count = planesSearched;
    search.draftDegrees = settings.draftDegrees;
    search.limits = settings.limits;
    search.normalDirections = settings.directionsChoice == DirectionsChoice::Normal;
    search.seed = settings.seed;
    return search;
}

std::vector<PlaneCandidate> workablePlanes(const IndexedMesh& part, const DesignSettings& settings,
                                           const Task& task) {
    std::vector<PlaneCandidate> found = findPlanes(part, searchFor(settings), task.part(0, 0.8));
    std::vector<PlaneCandidate> workable;
    for (const PlaneCandidate& plane : found) {
        if (task.stopped() || workable.size() == planesOffered)
            break;
        if (planePasses(part, plane.state))
            workable.push_back(plane);
    }
    if (workable.empty()) {
        found.resize(std::min<std::size_t>(found.size(), planesOffered));
        return found;
    }
    return workable;
}

scene::SmallPicture pictureOf(const IndexedMesh& part, const MoldState& state, double draftDegrees,
                              const scene::SceneColours& colours) {
    const DraftAnalysis analysis = analyzeDraft(part, state, draftDegrees, false);
    const std::vector<scene::Rgb> faces = scene::undercutColours(analysis.violating, colours);
    const scene::PlaneRectangle plane = scene::planeRectangle(state.plane, part.V);
    std::vector<Eigen::Vector3d> inSight = scene::cornersOf(boundingBox(part));
    for (const auto& [s, t] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        inSight.push_back(plane.at(s, t));
    const int width = PictureList::pictureSize.width() * picturesFiner;
    const int height = PictureList::pictureSize.height() * picturesFiner;
    const scene::Camera camera = scene::fitted(scene::lookingFrom({}, lookedFrom), inSight,
                                               {static_cast<double>(width), static_cast<double>(height)});
    return scene::smallPicture(part, faces, plane, colours, camera, width, height);
}

} // namespace

std::vector<OfferedPlane> offerPlanes(const IndexedMesh& part, const DesignSettings& settings,
                                      const scene::SceneColours& colours, const Task& task) {
    std::vector<OfferedPlane> offers;
    for (const PlaneCandidate& plane : workablePlanes(part, settings, task)) {
        if (task.stopped())
            break;
        offers.push_back({plane, pictureOf(part, plane.state, settings.draftDegrees, colours)});
    }
    return offers;
}

} // namespace moldwright
