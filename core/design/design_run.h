// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "castability/plane_search.h"
#include "design/design.h"

#include <expected>
#include <functional>
#include <memory>
#include <string>

namespace moldwright {

/// What can be seen of a step of a design.
struct SeenStep {
    const char* stage;                         ///< English name
    IndexedMesh shape;                         ///< part frame
    SideLabels labels;                         ///< of its faces; empty while it is not split
    MoldState state;                           ///< part frame
    std::shared_ptr<const Points> before = {}; ///< as in DesignFrame
};

/// What the stages of one design share: what is asked, who watches, and what is known so far. A design is one
/// leg, or several: where the designer changes what bending cannot take as it goes, the leg ends, and the
/// next begins from the shape that was reached.
class DesignRun {
public:
    using WhenReplaced = std::function<void(const DesignRun&)>;

    /// `task` is the leg's own. `start`: the part with its points where bending begins; null: the part as it
    /// is. `whenReplaced` is told once, when next() has become known.
    DesignRun(const DesignRequest& request, const Task& task, FrameSink frames, SharedMesh start = {},
              WhenReplaced whenReplaced = {});

    /// The request; its live settings are those that this leg heeds.
    [[nodiscard]] const DesignRequest& request() const { return m_request; }
    /// Stopped too when the leg is over.
    [[nodiscard]] const Task& task() const { return m_leg->task; }
    [[nodiscard]] bool stopped() const { return task().stopped(); }
    /// The part as bending finds it: its own faces, its points maybe bent.
    [[nodiscard]] const SharedMesh& start() const { return m_start; }

    /// The same leg at another plane.
    [[nodiscard]] DesignRun at(const PartingPlane& plane) const;
    /// Goes on with what a run at() another plane has heard.
    void takeSettings(const DesignRun& other);

    /// Asks what the designer has changed; to be called after every step. True: request() holds something new
    /// that bending can take as it goes. Any other change, and every one unless `inPlace`, asks for another
    /// leg: this one ends, at once unless the request lets it bend meanwhile.
    bool hear(bool inPlace);
    /// Whether the designer wants the bending to end here and be finished; true once. Another leg is to hear
    /// it when there will be one.
    [[nodiscard]] bool finishAsked() const;
    /// Ends the leg.
    void end() const { m_leg->task.cancel(); }
    /// Whether anybody may change anything.
    [[nodiscard]] bool live() const { return static_cast<bool>(m_request.newest); }
    /// What the next leg is to hold; none while none was asked for.
    [[nodiscard]] const std::optional<LiveSettings>& next() const { return m_leg->next; }
    /// What this leg heeds.
    [[nodiscard]] const LiveSettings& heard() const { return m_leg->heard; }
    /// The part's own points as bent last, and at which state; null and none before the first bending.
    [[nodiscard]] const std::shared_ptr<const Points>& reached() const { return m_leg->reached; }
    [[nodiscard]] const std::optional<MoldState>& reachedState() const { return m_leg->reachedState; }
    void setReached(const IndexedMesh& shape, const MoldState& state);

    /// The seconds spent so far, by stage.
    [[nodiscard]] std::map<std::string, double>& seconds() { return m_seconds; }

    /// Directions at a plane, as the request chooses them.
    [[nodiscard]] Directions directionsFor(const IndexedMesh& shape, const PartingPlane& plane);

    /// The search for the `count` best planes, as the request limits draft, tilt and directions.
    [[nodiscard]] PlaneSearch planeSearch(int count) const;

    [[nodiscard]] bool watched() const { return static_cast<bool>(m_frames); }
    /// Shows a step to whoever watches.
    void show(SeenStep step);

    [[nodiscard]] static std::unexpected<Error> cancelled();

private:
    /// What runs at() several planes share.
    struct Leg {
        Task task;
        LiveSettings heard;
        std::optional<LiveSettings> next;
        std::shared_ptr<const Points> reached;
        std::optional<MoldState> reachedState;
        WhenReplaced whenReplaced;
    };

    DesignRequest m_request;
    SharedMesh m_start;
    FrameSink m_frames;
    std::shared_ptr<Leg> m_leg;
    std::map<std::string, double> m_seconds;
};

} // namespace moldwright
