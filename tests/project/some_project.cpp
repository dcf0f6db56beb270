// SPDX-License-Identifier: AGPL-3.0-or-later
#include "project/some_project.h"

#include "castability/certificate.h"
#include "project/edits.h"
#include "project/further_parts.h"
#include "project/variants.h"
#include "support/casts.h"

#include <algorithm>

namespace moldwright::test {

namespace {

bool equal(const SharedMesh& a, const SharedMesh& b) {
    return (!a && !b) || (a && b && a->V == b->V && a->F == b->F);
}

bool equal(const std::shared_ptr<const CastResult>& a, const std::shared_ptr<const CastResult>& b) {
    if (!a || !b)
        return a == b;
    return equal(a->mesh, b->mesh) && a->labels == b->labels && a->state == b->state &&
           a->draftDegrees == b->draftDegrees && a->change.meanDistance == b->change.meanDistance &&
           a->change.filledVolumeFraction == b->change.filledVolumeFraction && a->steps == b->steps &&
           a->before.rows() == b->before.rows() && a->before == b->before && a->regions == b->regions &&
           a->limbs.size() == b->limbs.size() &&
           (a->limbs.empty() || (a->limbs.back().tip == b->limbs.back().tip &&
                                 a->limbs.back().volumeRatio == b->limbs.back().volumeRatio));
}

bool equalParts(const TrayPart& a, const TrayPart& b) {
    return equal(a.cast->mesh, b.cast->mesh) && a.cast->labels == b.cast->labels &&
           a.cast->state == b.cast->state && a.name == b.name && a.source == b.source && a.count == b.count;
}

} // namespace

Project someProject() {
    const KnownCast cast = moved(frusta(20, 10, 5, 3, 0.1), {1, 2, 3}, 0.5, {1, 2, 3});
    Placement placement;
    placement.unit = Unit::Inch;
    placement.scale = 25.4;
    placement.motion.translate(Eigen::Vector3d(0.1, 1.0 / 3, -7));
    Project project =
        withPart({}, "Box ∅ 20", "box.stl", std::make_shared<const IndexedMesh>(cast.mesh), placement);
    project.number = "M-1042";
    project.revision = "B ∅";
    project.design = {2.5,
                      {20, Eigen::Vector3d(0, 0.6, 0.8), 3},
                      DirectionsChoice::Given,
                      DeformationMethod::Paper,
                      FillChoice::None,
                      7,
                      0.25,
                      true};
    project.pins = {{{{0.1, 0.2, 0.3}}, {}}, {{{-1, 2, 1e-17}}, {}}};
    project.undercuts = {{{1, -2, 0.25}, UndercutChoice::Treatment::Fill},
                         {{3, 4, 5}, UndercutChoice::Treatment::Bend}};
    project.importance = {{"eye", {0, 3, 4}, {2, 16, 1.5}, 0.25}, {"Logo ∅", {1}, {1}, 0}};
    project.mold.wall = 4;
    project.mold.floor = 3;
    project.mold.ceiling = 6;
    project.mold.step = 0.5;
    project.mold.pressure = 12;
    project.mold.keys.count = 4;
    project.mold.shrink.percent = Eigen::Vector3d(1, 2, 3);
    project.state = cast.state;
    project.planeChosenByHand = true;
    project.cast = std::make_shared<const CastResult>(CastResult{
        {std::make_shared<const IndexedMesh>(cast.mesh), labelSides(cast.mesh, cast.state.plane), cast.state},
        2.5,
        {0.01, 0.02, 1.1, 0.03},
        {{{1, 2, 3}, 0.9, 0.8}},
        {{"eye", 0.5, 0.25, 0.01, false}, {"Logo ∅", 1, 0.5}},
        1.01 * cast.mesh.V});
    return project;
}

Project someVariants() {
    Project project = withDuplicate(someProject(), 0); // shares the cast
    project = withVariantName(project, 0, "flat back");
    project = withFreshVariant(project);
    project.importance = {{"nose", {2, 5}, {4, 8}, 0.5}};
    project.pins = {{{{7, 8, 9}}, {}}};
    CastResult cast = *variantAt(project, 0).cast;
    cast.steps = 31;
    cast.mesh = std::make_shared<const IndexedMesh>(IndexedMesh{2 * cast.mesh->V, cast.mesh->F});
    project.cast = std::make_shared<const CastResult>(cast);
    return withVariant(project, 1);
}

Project someTrays() {
    const auto part = [](const KnownCast& cast, const std::string& name, int count) {
        return TrayPart{std::make_shared<const CertifiedCast>(
                            CertifiedCast{std::make_shared<const IndexedMesh>(cast.mesh),
                                          labelSides(cast.mesh, cast.state.plane), cast.state}),
                        name, "/parts/" + name + ".moldwright", count};
    };
    const TrayPart ball = part(moved(test::ball(7, 2), {0, 1, 1}, 0.3, {1, 0, 1.0 / 3}), "ball ∅", 3);
    const Project first = withFurtherPart(withVariant(someVariants(), 0), ball);
    return withFurtherPart(withFurtherPart(withVariant(first, 1), part(ring(9, 2, 8, 6), "ring", 1)), ball);
}

bool equal(const Variant& a, const Variant& b) {
    return a.variantName == b.variantName && a.state == b.state &&
           a.planeChosenByHand == b.planeChosenByHand && a.design == b.design && a.pins == b.pins &&
           a.undercuts == b.undercuts && a.importance == b.importance && equal(a.cast, b.cast) &&
           a.mold == b.mold && std::ranges::equal(a.furtherParts, b.furtherParts, equalParts);
}

bool equal(const Project& a, const Project& b) {
    return a.name == b.name && a.number == b.number && a.revision == b.revision &&
           a.sourceFile == b.sourceFile && equal(a.source, b.source) && a.placement == b.placement &&
           equal(a.part, b.part) && a.place == b.place && equal(static_cast<const Variant&>(a), b) &&
           std::ranges::equal(a.others, b.others,
                              [](const Variant& x, const Variant& y) { return equal(x, y); });
}

} // namespace moldwright::test
