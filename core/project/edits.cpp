// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/edits.h"

#include "mesh/measures.h"

#include <cassert>

namespace moldwright {

namespace {

SharedMesh placed(const IndexedMesh& source, const Placement& placement) {
    auto part = std::make_shared<IndexedMesh>(source);
    part->V = (placement.scale * source.V * placement.motion.linear().transpose()).rowwise() +
              placement.motion.translation().transpose();
    return part;
}

/// The similarity that takes the part as it lay to the part as it lies.
struct PlacementChange {
    Eigen::Isometry3d before;
    Eigen::Isometry3d after;
    double scale = 1;

    [[nodiscard]] Eigen::Vector3d point(const Eigen::Vector3d& x) const {
        return after * (scale * (before.inverse() * x));
    }
    [[nodiscard]] Eigen::Vector3d direction(const Eigen::Vector3d& d) const {
        return (after.linear() * (before.linear().transpose() * d)).normalized();
    }
};

MoldState carried(const MoldState& state, const PlacementChange& change) {
    MoldState moved;
    moved.plane.normal = change.direction(state.plane.normal);
    moved.plane.offset = moved.plane.normal.dot(change.point(state.plane.offset * state.plane.normal));
    moved.directions = {change.direction(state.directions.d1), change.direction(state.directions.d2)};
    return moved;
}

} // namespace

double millimetres(Unit unit) {
    switch (unit) {
    case Unit::Millimetre:
        return 1;
    case Unit::Centimetre:
        return 10;
    case Unit::Metre:
        return 1000;
    case Unit::Inch:
        return 25.4;
    }
    return 1;
}

Project withPart(const Project& project, const std::string& name, const std::string& sourceFile,
                 const SharedMesh& source, Unit unit, double scale) {
    assert(source && scale > 0);
    Project opened;
    opened.design = project.design;
    opened.mold = project.mold;
    opened.name = name;
    opened.sourceFile = sourceFile;
    opened.source = source;
    opened.placement = {unit, scale, Eigen::Isometry3d::Identity()};
    opened.part = placed(*source, opened.placement);
    return opened;
}

Project withPlacement(const Project& project, const Placement& placement) {
    assert(project.source && placement.scale > 0);
    const PlacementChange change{project.placement.motion, placement.motion,
                                 placement.scale / project.placement.scale};
    Project edited = withoutCast(project);
    edited.placement = placement;
    edited.part = placed(*project.source, placement);
    if (project.state)
        edited.state = carried(*project.state, change);
    for (Pin& pin : edited.pins)
        pin.point = change.point(pin.point);
    return edited;
}

Project withState(const Project& project, const MoldState& state, bool chosenByHand) {
    Project edited = project;
    edited.state = state;
    edited.planeChosenByHand = chosenByHand;
    return edited;
}

Project withDesign(const Project& project, const DesignSettings& design) {
    Project edited = project;
    edited.design = design;
    return edited;
}

Project withMold(const Project& project, const MoldSettings& mold) {
    Project edited = project;
    edited.mold = mold;
    return edited;
}

Project withName(const Project& project, const std::string& name) {
    Project edited = project;
    edited.name = name;
    return edited;
}

Project withCast(const Project& project, const CastResult& cast) {
    Project edited = project;
    edited.cast = std::make_shared<const CastResult>(cast);
    edited.state = cast.state;
    return edited;
}

Project withoutCast(const Project& project) {
    Project edited = project;
    edited.cast.reset();
    return edited;
}

Placement moved(const Placement& placement, const Eigen::Isometry3d& motion) {
    Placement edited = placement;
    edited.motion = motion * placement.motion;
    return edited;
}

Eigen::Isometry3d layFlat(const IndexedMesh& part, const Eigen::Vector3d& normal) {
    const Eigen::Vector3d down = -Eigen::Vector3d::UnitZ();
    Eigen::Isometry3d motion(Eigen::Quaterniond::FromTwoVectors(normal, down));
    const double lowest = (part.V * motion.linear().transpose()).col(2).minCoeff();
    motion.pretranslate(Eigen::Vector3d(0, 0, -lowest));
    return motion;
}

bool castIsCurrent(const Project& project) {
    return project.cast && project.state == project.cast->state &&
           project.design.draftDegrees == project.cast->draftDegrees;
}

} // namespace moldwright
