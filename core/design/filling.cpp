// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/filling.h"

#include "castability/topology.h"
#include "design/design_run.h"
#include "design/obstructions.h"
#include "design/pins_in_plane.h"
#include "fill/plan_regions.h"
#include "mesh/check.h"
#include "mesh/measures.h"

#include <algorithm>
#include <functional>
#include <limits>
#include <map>

namespace moldwright {

namespace {

using Treatment = UndercutChoice::Treatment;

/// The undercuts as they are offered for choice.
Result<FillPlan> choicePlan(const PartedMesh& surface, const Directions& directions, const Task& task) {
    Result<FillPlan> plan = planFill(surface, directions, task);
    if (plan)
        *plan = divided(std::move(*plan), directions, task);
    return plan;
}

/// What the designer wants of the regions of a plan that choices speak of.
std::map<int, Treatment> treatments(const FillPlan& plan, const std::vector<UndercutChoice>& choices,
                                    const WorkingFrame& frame) {
    std::map<int, Treatment> wanted;
    for (const UndercutChoice& choice : choices)
        if (const int region = regionNearest(plan, frame.toWork(choice.place)); region >= 0)
            wanted[region] = choice.treatment;
    return wanted;
}

std::vector<int> regionsToFill(const FillPlan& plan, FillExtent extent,
                               const std::map<int, Treatment>& wanted) {
    std::vector<int> chosen;
    for (int r = 0; r < static_cast<int>(plan.regions.size()); ++r) {
        const auto own = wanted.find(r);
        const bool byRule = extent == FillExtent::All || (extent == FillExtent::Needed &&
                                                          plan.regions[static_cast<std::size_t>(r)].needed);
        if (own != wanted.end() ? own->second == Treatment::Fill : byRule)
            chosen.push_back(r);
    }
    return chosen;
}

/// A filled surface, and whether it joins pieces although nobody chose that.
struct Filled {
    FilledPart part;
    bool joins = false;
};

int pieces(const PartedMesh& surface) {
    return connectedComponents(surface.mesh).count;
}

Result<Filled> filledAsChosen(const PartedMesh& surface, const Directions& directions, const Filling& filling,
                              const WorkingFrame& frame, const Task& task) {
    const Result<FillPlan> plan = choicePlan(surface, directions, task);
    if (!plan)
        return std::unexpected(plan.error());
    const std::map<int, Treatment> wanted = treatments(*plan, filling.choices, frame);
    Result<FilledPart> result = fillChosen(*plan, regionsToFill(*plan, filling.extent, wanted));
    if (!result)
        return std::unexpected(result.error());
    if (filling.extent != FillExtent::Chosen &&
        !topologyAllowsCasting(result->surface.mesh, result->surface.labels))
        for (const auto& [region, treatment] : wanted)
            if (treatment == Treatment::Bend && plan->regions[static_cast<std::size_t>(region)].needed)
                return failure(
                    ErrorCode::Impossible,
                    MW_TEXT("design", "The undercut near {0} is to be bent, and no bending frees it. Have "
                                      "it filled, or move the plane."),
                    {placeText(frame.toPart(plan->regions[static_cast<std::size_t>(region)].place))});
    if (filling.extent == FillExtent::Chosen)
        return Filled{std::move(*result), false};
    const Result<FilledPart> chosen = fillChosen(*plan, regionsToFill(*plan, FillExtent::Chosen, wanted));
    const int allowed = pieces(chosen ? chosen->surface : surface);
    const bool joins = pieces(result->surface) < allowed;
    return Filled{std::move(*result), joins};
}

Result<Filled> filledByRule(const PartedMesh& surface, const Directions& directions, FillExtent extent,
                            const Task& task) {
    Result<FilledPart> result = [&]() -> Result<FilledPart> {
        if (extent == FillExtent::All)
            return fill(surface, directions, task);
        const Result<FillPlan> plan = planFill(surface, directions, task);
        if (!plan)
            return std::unexpected(plan.error());
        return minimalFill(*plan);
    }();
    if (!result)
        return std::unexpected(result.error());
    const bool joins = pieces(result->surface) < pieces(surface);
    return Filled{std::move(*result), joins};
}

/// Parts a part (working frame) ever closer to where it lies until `use` takes it; else the last reason why
/// not.
Result<void> partUntilUsed(const IndexedMesh& work, const Task& task,
                           const std::function<std::optional<Error>(const PartedMesh&)>& use) {
    std::optional<Error> refusal;
    for (const double snap : kSnaps) {
        if (task.stopped())
            return DesignRun::cancelled();
        const PartedMesh surface = insertPartingLine(work, snap);
        refusal = selfIntersections(surface.mesh).empty() ? use(surface) : crossesItself();
        if (!refusal)
            return {};
    }
    return std::unexpected(*refusal);
}

/// A way to fill a parted surface.
using Way = std::function<Result<Filled>(const PartedMesh&, const Directions&, const WorkingFrame&)>;

Way fillingBy(const Filling& filling, const Task& task) {
    return [&](const PartedMesh& surface, const Directions& directions, const WorkingFrame& frame) {
        return filling.choices.empty() ? filledByRule(surface, directions, filling.extent, task)
                                       : filledAsChosen(surface, directions, filling, frame, task);
    };
}

Result<PartedPart> fillUntil(const Taking& take, const IndexedMesh& part, const MoldState& state,
                             const Way& fillBy, const Task& task, const std::vector<PlacedPin>& partPins) {
    PartedPart result{state, WorkingFrame(part, state), {}};
    const Directions directions = result.frame.directionsToWork(state.directions);
    const std::vector<PlacedPin> pins = pinsToWork(partPins, result.frame);
    const auto use = [&](const PartedMesh& surface) -> std::optional<Error> {
        Result<Filled> filled = fillBy(surface, directions, result.frame);
        if (!filled)
            return filled.error();
        result.pins = pinsAfterFilling(pins, filled->part.sourceVertex);
        if (!pinsAreInPlane(filled->part.surface.mesh, result.pins))
            return missesPin();
        if (const std::optional<Error> refusal = take(filled->part.surface, result.pins))
            return refusal;
        result.surface = std::move(filled->part.surface);
        for (int& source : result.surface.sourceFace)
            if (source >= 0)
                source = surface.sourceFace[static_cast<std::size_t>(source)];
        result.filledVolume = filled->part.volume * std::pow(result.frame.scale(), 3);
        result.joinsPieces = filled->joins;
        return std::nullopt;
    };
    const IndexedMesh work = withPinsInPlane(result.frame.toWork(part), pins);
    if (const Result<void> done = partUntilUsed(work, task, use); !done)
        return std::unexpected(done.error());
    return result;
}

/// The faces alone, with the points that they use.
IndexedMesh facesAlone(const std::vector<Eigen::Vector3d>& points, Triangles faces) {
    std::map<int, int> number;
    for (int& v : faces.reshaped<Eigen::RowMajor>())
        v = number.try_emplace(v, static_cast<int>(number.size())).first->second;
    IndexedMesh mesh{Points(static_cast<Eigen::Index>(number.size()), 3), std::move(faces)};
    for (const auto& [old, now] : number)
        mesh.V.row(now) = points[static_cast<std::size_t>(old)].transpose();
    return mesh;
}

std::vector<FillableUndercut> undercutsOf(const FillPlan& plan, const PartedMesh& surface,
                                          const WorkingFrame& frame) {
    const std::vector<char> joins = regionsThatJoin(plan);
    std::vector<FillableUndercut> undercuts;
    for (std::size_t r = 0; r < plan.regions.size(); ++r) {
        const FillRegion& region = plan.regions[r];
        const int number = static_cast<int>(r);
        std::vector<int> faces;
        for (const int f : facesCovered(plan, number))
            if (const int source = surface.sourceFace[static_cast<std::size_t>(f)];
                faces.empty() || faces.back() != source)
                faces.push_back(source);
        undercuts.push_back({region.side, frame.toPart(region.place), region.size * frame.scale(),
                             region.volume * std::pow(frame.scale(), 3), region.needed, joins[r] != 0,
                             std::move(faces),
                             frame.toPart(facesAlone(plan.choices.points, facesMade(plan, number)))});
    }
    return undercuts;
}

} // namespace

bool bendsAny(const std::vector<UndercutChoice>& choices) {
    return std::ranges::any_of(choices,
                               [](const auto& choice) { return choice.treatment == Treatment::Bend; });
}

bool fillsAny(const std::vector<UndercutChoice>& choices) {
    return std::ranges::any_of(choices,
                               [](const auto& choice) { return choice.treatment == Treatment::Fill; });
}

Result<PartedPart> filledSurface(const IndexedMesh& part, const MoldState& state, const Filling& filling,
                                 const Task& task, const std::vector<PlacedPin>& pins) {
    return fillUntil(takeAny, part, state, fillingBy(filling, task), task, pins);
}

Result<PartedSolid> filledSolid(const IndexedMesh& part, const MoldState& state, const Filling& filling,
                                const Task& task, const std::vector<PlacedPin>& pins) {
    TetMesh tets;
    Result<PartedPart> taken =
        fillUntil(takeTetrahedralized(tets, task), part, state, fillingBy(filling, task), task, pins);
    return solidOf(std::move(taken), std::move(tets));
}

Result<PartedPart> filledWithDraft(const IndexedMesh& part, const MoldState& state, double draftDegrees,
                                   const Task& task, const std::vector<PlacedPin>& pins) {
    const auto way = [&](const PartedMesh& surface, const Directions& directions,
                         const WorkingFrame&) -> Result<Filled> {
        Result<FilledPart> filled = fillWithDraft(surface, directions, draftDegrees, task);
        if (!filled)
            return std::unexpected(filled.error());
        const bool joins = pieces(filled->surface) < pieces(surface);
        return Filled{std::move(*filled), joins};
    };
    return fillUntil(takeAny, part, state, way, task, pins);
}

bool planePasses(const IndexedMesh& part, const MoldState& state, const std::vector<UndercutChoice>& choices,
                 const Task& task) {
    if (!fillsAny(choices))
        return planePasses(part, state);
    const Result<PartedPart> filled = filledSurface(part, state, {FillExtent::Chosen, choices}, task);
    return filled && topologyAllowsCasting(filled->surface.mesh, filled->surface.labels);
}

ObstructedPart obstructionsAt(const IndexedMesh& part, const MoldState& state,
                              const std::vector<UndercutChoice>& choices, const Task& task) {
    if (fillsAny(choices))
        if (Result<PartedPart> filled = filledSurface(part, state, {FillExtent::Chosen, choices}, task))
            return {findObstructions(filled->surface.mesh, filled->surface.labels, filled->frame),
                    std::move(filled->surface)};
    return obstructionsAt(part, state);
}

int undercutNearest(const std::vector<FillableUndercut>& undercuts, const IndexedMesh& part,
                    const Eigen::Vector3d& place, double reach) {
    int found = -1;
    double nearest = reach * reach;
    for (std::size_t i = 0; i < undercuts.size(); ++i) {
        double distance = (undercuts[i].place - place).squaredNorm();
        for (const int f : undercuts[i].faces)
            for (int k = 0; k < 3; ++k)
                distance = std::min(distance, (part.corner(f, k) - place).squaredNorm());
        if (distance < nearest) {
            nearest = distance;
            found = static_cast<int>(i);
        }
    }
    return found;
}

Result<std::vector<FillableUndercut>> fillableUndercuts(const IndexedMesh& part, const MoldState& state,
                                                        const Task& task) {
    const WorkingFrame frame(part, state);
    std::vector<FillableUndercut> undercuts;
    const auto use = [&](const PartedMesh& surface) -> std::optional<Error> {
        const Result<FillPlan> plan = choicePlan(surface, frame.directionsToWork(state.directions), task);
        if (!plan)
            return plan.error();
        undercuts = undercutsOf(*plan, surface, frame);
        return std::nullopt;
    };
    if (const Result<void> done = partUntilUsed(frame.toWork(part), task, use); !done)
        return std::unexpected(done.error());
    return undercuts;
}

} // namespace moldwright
