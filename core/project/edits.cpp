// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/edits.h"

#include <utility>

namespace moldwright {

namespace {

using Eigen::Affine3d;
using Eigen::Vector3d;

Affine3d fromFile(const Placement& placement) {
    return Affine3d(placement.motion) * Eigen::Scaling(placement.scale);
}

/// The state after the part went through `change`, a similarity.
MoldState moved(const MoldState& state, const Affine3d& change) {
    const auto turned = [&](const Vector3d& v) -> Vector3d { return (change.linear() * v).normalized(); };
    const Vector3d onPlane = change * Vector3d(state.plane.offset * state.plane.normal);
    MoldState result;
    result.plane.normal = turned(state.plane.normal);
    result.plane.offset = result.plane.normal.dot(onPlane);
    result.directions = {turned(state.directions.d1), turned(state.directions.d2)};
    return result;
}

/// A design of the part after the part went through `change`; its cast is one of the part as it lay.
void move(Variant& variant, const Affine3d& change) {
    if (variant.state)
        variant.state = moved(*variant.state, change);
    for (Pin& pin : variant.pins)
        pin.point = change * pin.point;
    for (UndercutChoice& undercut : variant.undercuts)
        undercut.place = change * undercut.place;
    if (std::optional<Vector3d>& axis = variant.design.limits.axis)
        axis = (change.linear() * *axis).normalized();
    variant.cast = nullptr;
}

} // namespace

IndexedMesh placed(const IndexedMesh& source, const Placement& placement) {
    const Affine3d motion = fromFile(placement);
    IndexedMesh part = source;
    part.V = (source.V * motion.linear().transpose()).rowwise() + motion.translation().transpose();
    return part;
}

Project withPart(Project project, std::string name, std::string sourceFile, SharedMesh source,
                 const Placement& placement) {
    Project result;
    result.design = project.design;
    result.mold = project.mold;
    result.name = std::move(name);
    result.sourceFile = std::move(sourceFile);
    result.part = std::make_shared<const IndexedMesh>(placed(*source, placement));
    result.source = std::move(source);
    result.placement = placement;
    return result;
}

Project withPlacement(Project project, const Placement& placement) {
    if (placement == project.placement || !project.source)
        return project;
    const Affine3d change = fromFile(placement) * fromFile(project.placement).inverse();
    project.placement = placement;
    project.part = std::make_shared<const IndexedMesh>(placed(*project.source, placement));
    move(project, change);
    for (Variant& other : project.others)
        move(other, change);
    return project;
}

Project withState(Project project, const MoldState& state, bool byHand) {
    if (project.state != state)
        project.cast = nullptr;
    project.state = state;
    project.planeChosenByHand = byHand;
    return project;
}

Project withDirections(Project project, const Directions& directions) {
    const MoldState state{project.state->plane, directions};
    DesignSettings settings = project.design;
    settings.directionsChoice = DirectionsChoice::Given;
    return withDesignSettings(withState(std::move(project), state, true), settings);
}

Project withPlane(Project project, const PartingPlane& plane, bool byHand) {
    MoldState state{plane, Directions::normalTo(plane)};
    // Far enough from the plane for a direction to be of use; the tilt cap of a design is narrower.
    constexpr double leaves = 0.05;
    if (project.state && project.design.directionsChoice != DirectionsChoice::Normal) {
        const Directions& old = project.state->directions;
        if (old.d1.dot(plane.normal) > leaves && old.d2.dot(plane.normal) < -leaves)
            state.directions = old;
    }
    return withState(std::move(project), state, byHand);
}

Project withDesignSettings(Project project, const DesignSettings& settings) {
    if (project.design != settings)
        project.cast = nullptr;
    project.design = settings;
    return project;
}

std::vector<NamedPin> named(const std::vector<Pin>& pins, const std::vector<NamedPin>& known) {
    std::vector<NamedPin> result;
    for (const Pin& pin : pins) {
        const auto same = std::ranges::find(known, pin.point, &NamedPin::point);
        result.push_back({pin, same != known.end() ? same->name : std::string()});
    }
    return result;
}

Project withPins(Project project, std::vector<NamedPin> pins) {
    if (!std::ranges::equal(project.pins, pins, {}, &NamedPin::point, &NamedPin::point))
        project.cast = nullptr;
    project.pins = std::move(pins);
    return project;
}

Project withImportance(Project project, std::vector<ImportantRegion> regions) {
    if (!weighAlike(project.importance, regions))
        project.cast = nullptr;
    project.importance = std::move(regions);
    return project;
}

Project withUndercut(Project project, const Vector3d& place,
                     std::optional<UndercutChoice::Treatment> treatment) {
    std::vector<UndercutChoice> choices = project.undercuts;
    std::erase_if(choices, [&](const UndercutChoice& choice) { return choice.place == place; });
    if (treatment)
        choices.push_back({place, *treatment});
    if (choices != project.undercuts)
        project.cast = nullptr;
    project.undercuts = std::move(choices);
    return project;
}

Project withMoldSettings(Project project, const MoldSettings& settings) {
    project.mold = settings;
    return project;
}

Project withCast(Project project, const DesignResult& result, double draftDegrees) {
    project.state = result.state;
    project.cast = std::make_shared<const CastResult>(CastResult{{result.cast, result.labels, result.state},
                                                                 draftDegrees,
                                                                 result.change,
                                                                 result.limbs,
                                                                 result.regions,
                                                                 result.before,
                                                                 result.steps});
    return project;
}

} // namespace moldwright
