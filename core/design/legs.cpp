// SPDX-License-Identifier: AGPL-3.0-or-later
#include "design/legs.h"

#include <algorithm>
#include <map>
#include <string>
#include <utility>

namespace moldwright {

namespace {

/// The part with its points elsewhere.
SharedMesh withPoints(const SharedMesh& part, const std::shared_ptr<const Points>& points) {
    return points ? std::make_shared<const IndexedMesh>(IndexedMesh{*points, part->F}) : part;
}

} // namespace

Legs::Legs(const DesignRequest& request, const Task& task, const FrameSink& frames, RunLeg runLeg)
    : m_request(request), m_task(task), m_frames(frames), m_runLeg(std::move(runLeg)) {}

Result<DesignResult> Legs::run() {
    begin(m_request, m_request.start);
    std::size_t last = 0;
    // A leg that is over has begun its successor already.
    for (at(0).result.wait(); !isLast(last); at(last).result.wait())
        ++last;
    return finished(at(last).result.get());
}

Legs::Leg& Legs::at(std::size_t leg) {
    const std::lock_guard lock(m_legsMutex);
    return m_legs[leg];
}

bool Legs::isLast(std::size_t leg) {
    const std::lock_guard lock(m_legsMutex);
    return leg + 1 == m_legs.size();
}

void Legs::begin(const DesignRequest& request, const std::shared_ptr<const Points>& points) {
    const std::lock_guard lock(m_legsMutex);
    const std::size_t leg = m_legs.size();
    m_legs.push_back({runOf(leg, request, points), points});
    m_legs.back().result = std::async(std::launch::async, [this, leg] { return runToItsEnd(leg); });
}

void Legs::follow(std::size_t leg, const DesignRun& run) {
    DesignRequest request = m_request;
    static_cast<LiveSettings&>(request) = *run.next();
    if (!request.plane && run.reachedState())
        request.plane = run.reachedState()->plane;
    begin(request, run.reached() ? run.reached() : at(leg).points);
}

DesignRun Legs::runOf(std::size_t leg, const DesignRequest& request,
                      const std::shared_ptr<const Points>& points) {
    const Task task = m_task.leg([this, leg](double fraction, const std::string& stage) {
        const std::lock_guard lock(m_viewMutex);
        if (leg == m_inView)
            m_task.progress(fraction, stage);
    });
    const FrameSink sink = [this, leg](const DesignFrame& frame) { show(leg, frame); };
    return {request, task, m_frames ? sink : FrameSink{}, withPoints(m_request.part, points),
            [this, leg](const DesignRun& run) { follow(leg, run); }};
}

Result<DesignResult> Legs::runToItsEnd(std::size_t number) {
    Leg& leg = at(number);
    const auto wholeRun = [&] {
        Result<DesignResult> result = m_runLeg(leg.run);
        leg.run.hear(false); // also what was changed while the result was proved
        return result;
    };
    Result<DesignResult> result = wholeRun();
    // A shape bent for one plane may be in the way of itself at another: then the part itself is bent there.
    if (leg.points && !leg.run.next() && !m_task.stopped() && !(result && result->cast)) {
        const std::map<std::string, double> spent = leg.run.seconds();
        leg.run = runOf(number, leg.run.request(), nullptr);
        leg.run.seconds() = spent;
        leg.points = nullptr;
        leg.begunAnew = true;
        result = wholeRun();
    }
    takeOver(number);
    return result;
}

void Legs::show(std::size_t leg, const DesignFrame& frame) {
    takeOver(leg);
    const std::lock_guard lock(m_viewMutex);
    // One that waited for its turn may have been overtaken meanwhile.
    if (leg < m_inView)
        return;
    DesignFrame numbered = frame;
    numbered.step = ++m_steps;
    m_frames(numbered);
}

void Legs::takeOver(std::size_t leg) {
    std::size_t before = m_inView;
    while (before < leg && !m_inView.compare_exchange_weak(before, leg)) {
    }
    for (; before < leg; ++before)
        at(before).run.end();
}

Result<DesignResult> Legs::finished(Result<DesignResult> result) {
    const Leg& last = m_legs.back();
    if (!result && result.error().code == ErrorCode::Cancelled && m_request.keepUnfinished) {
        result = DesignResult{}; // nothing was reached yet
        result->cutShort = true;
        result->certificate.reason = "The design was stopped before it had a shape.";
    }
    if (!result)
        return result;
    result->seconds.clear();
    for (Leg& leg : m_legs)
        for (const auto& [stage, seconds] : leg.run.seconds())
            result->seconds[stage] += seconds;
    result->settings = last.run.heard();
    result->steps = std::max(m_steps, result->plasticSteps);
    if (last.begunAnew)
        result->warnings.push_back(
            {MW_TEXT("design", "The shape that the run had reached could not be parted at this plane: "
                               "bending began anew with the part."),
             {}});
    return result;
}

} // namespace moldwright
