// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/design_request.h"

#include "project/edits.h"

#include <utility>

namespace moldwright {

namespace {

/// Regions that ask of a run what these settings do.
std::vector<ImportantRegion> regionsWeighing(const LiveSettings& settings) {
    std::vector<ImportantRegion> regions;
    for (const KeptRegion& kept : settings.regions) {
        regions.push_back({kept.name, kept.faces, {}, kept.within});
        for (const int f : kept.faces)
            regions.back().weights.push_back(
                settings.faceWeights.empty() ? 1 : settings.faceWeights[static_cast<std::size_t>(f)]);
    }
    return regions;
}

} // namespace

LiveSettings liveSettings(const Project& project) {
    LiveSettings live;
    live.directionsChoice = project.design.directionsChoice;
    // Which undercuts there are depends on the plane: choices among them hold it.
    if ((project.planeChosenByHand || !project.undercuts.empty()) && project.state) {
        live.plane = project.state->plane;
        if (live.directionsChoice == DirectionsChoice::Given)
            live.directions = project.state->directions;
    } else if (live.directionsChoice == DirectionsChoice::Given) {
        live.directionsChoice = DirectionsChoice::Automatic;
    }
    live.followDirections = project.design.followDirections;
    live.draftDegrees = project.design.draftDegrees;
    live.limits = project.design.limits;
    live.smoothing = project.design.smoothing;
    live.pins.assign(project.pins.begin(), project.pins.end());
    if (project.part)
        live.faceWeights = faceWeights(project.importance, project.part->faceCount());
    live.regions = keptRegions(project.importance);
    return live;
}

DesignRequest designRequest(const Project& project) {
    DesignRequest request;
    static_cast<LiveSettings&>(request) = liveSettings(project);
    request.part = project.part;
    request.undercuts = project.undercuts;
    request.method = project.design.method;
    request.fill = project.design.fill;
    request.seed = project.design.seed;
    return request;
}

bool sameButLive(const Project& one, const Project& other) {
    return one.part == other.part && one.undercuts == other.undercuts &&
           one.design.method == other.design.method && one.design.fill == other.design.fill &&
           one.design.seed == other.design.seed;
}

Project withLiveSettings(Project project, const LiveSettings& settings) {
    DesignSettings design = project.design;
    design.directionsChoice = settings.directionsChoice;
    design.followDirections = settings.followDirections;
    design.draftDegrees = settings.draftDegrees;
    design.limits = settings.limits;
    design.smoothing = settings.smoothing;
    std::vector<NamedPin> pins = named(settings.pins, project.pins);
    project = withPins(withDesignSettings(std::move(project), design), std::move(pins));
    if (const LiveSettings now = liveSettings(project);
        now.regions != settings.regions || now.faceWeights != settings.faceWeights)
        project.importance = regionsWeighing(settings);
    if (settings.plane && settings.directionsChoice == DirectionsChoice::Given)
        return withState(std::move(project), {*settings.plane, settings.directions}, true);
    return settings.plane && (!project.state || project.state->plane != *settings.plane)
               ? withPlane(std::move(project), *settings.plane, true)
               : project;
}

} // namespace moldwright
