// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/design.h"

#include "design/default_method.h"
#include "design/design_run.h"
#include "design/paper_method.h"

#include <algorithm>

namespace moldwright {

namespace {

/// What cannot be had together; none where all can.
std::optional<Error> contradictionIn(const DesignRequest& request) {
    if (!request.undercuts.empty() && !request.plane)
        return Error{ErrorCode::Usage,
                     {MW_TEXT("design", "Undercuts were chosen to be filled or bent, and no plane was given: "
                                        "which undercuts there are depends on it. Give a plane too."),
                      {}},
                     {},
                     {}};
    const DirectionLimits limits =
        request.directionsChoice == DirectionsChoice::Normal ? alongNormal(request.limits) : request.limits;
    if (request.directionsChoice == DirectionsChoice::Given || !request.plane ||
        allows(limits, request.plane->normal))
        return std::nullopt;
    return Error{
        ErrorCode::Impossible,
        {MW_TEXT("design", "No direction within {0}° of the axis leaves the plane within {1}° of its "
                           "normal. Turn the plane towards the axis, or allow more."),
         {readable(limits.coneDegrees), readable(limits.maxTiltDegrees)}},
        {},
        {}};
}

/// The part with its points elsewhere.
SharedMesh withPoints(const SharedMesh& part, const std::shared_ptr<const Points>& points) {
    return points ? std::make_shared<const IndexedMesh>(IndexedMesh{*points, part->F}) : part;
}

Result<DesignResult> runLeg(DesignRun& run) {
    if (const std::optional<Error> refusal = contradictionIn(run.request()))
        return std::unexpected(*refusal);
    return run.request().method == DeformationMethod::Paper ? designAsPublished(run) : designByBending(run);
}

/// The legs of one design, each from where the one before it was left.
class Legs {
public:
    Legs(const DesignRequest& request, const Task& task, const FrameSink& frames)
        : m_request(request), m_task(task), m_frames(frames), m_points(request.start) {}

    Result<DesignResult> run() {
        for (;;) {
            DesignRun leg(m_request, m_task, m_frames, withPoints(m_request.part, m_points), m_steps);
            Result<DesignResult> result = runLeg(leg);
            (void)leg.hear(false); // also what was changed while the result was proved
            for (const auto& [stage, seconds] : leg.seconds())
                m_seconds[stage] += seconds;
            m_steps = leg.steps();
            if (leg.next() && !m_task.stopped())
                goOn(leg);
            else if (!anewFromThePart(result))
                return finished(std::move(result), leg);
        }
    }

private:
    void goOn(const DesignRun& leg) {
        static_cast<LiveSettings&>(m_request) = *leg.next();
        if (!m_request.plane && leg.reachedState())
            m_request.plane = leg.reachedState()->plane;
        m_points = leg.reached() ? leg.reached() : m_points;
        m_begunAnew = false;
    }

    /// A shape bent for one plane may be in the way of itself at another: then the part itself is bent there.
    bool anewFromThePart(const Result<DesignResult>& result) {
        if (!m_points || m_task.stopped() || (result && result->cast))
            return false;
        m_points = nullptr;
        m_begunAnew = true;
        return true;
    }

    Result<DesignResult> finished(Result<DesignResult> result, const DesignRun& leg) {
        if (!result && result.error().code == ErrorCode::Cancelled && m_request.keepUnfinished) {
            result = DesignResult{}; // nothing was reached yet
            result->cutShort = true;
            result->certificate.reason = "The design was stopped before it had a shape.";
        }
        if (!result)
            return result;
        result->seconds = m_seconds;
        result->settings = leg.heard();
        result->steps = std::max(m_steps, result->plasticSteps);
        if (m_begunAnew)
            result->warnings.push_back(
                {MW_TEXT("design", "The shape that the run had reached could not be parted at this plane: "
                                   "bending began anew with the part."),
                 {}});
        return result;
    }

    DesignRequest m_request;
    const Task& m_task;
    const FrameSink& m_frames;
    std::shared_ptr<const Points> m_points; ///< the part's, where the next leg begins; null: as they are
    std::map<std::string, double> m_seconds;
    int m_steps = 0;
    bool m_begunAnew = false;
};

} // namespace

Result<DesignResult> design(const DesignRequest& request, const Task& task, const FrameSink& frames) {
    return Legs(request, task, frames).run();
}

} // namespace moldwright
