// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "castability/mold_state.h"
#include "project/project.h"
#include "scene/value_scale.h"
#include "window/display_mode.h"
#include "window/work_thread.h"

#include <QObject>

#include <array>
#include <map>
#include <memory>
#include <mutex>
#include <vector>

namespace moldwright {

/// A map of numbers over a surface: what is wanted, and all that it follows from.
struct MapRequest {
    DisplayMode mode = DisplayMode::Deviation;
    ViewContent content = ViewContent::Newest;
    SharedMesh surface; ///< what is painted
    SharedMesh standIn; ///< its coarse stand-in; null for none
    SharedMesh part;
    std::shared_ptr<const CastResult> cast;  ///< null for undercut depths
    std::shared_ptr<const CastResult> other; ///< for a difference only: the cast it is from
    MoldState state;                         ///< for undercut depths only
    double draftDegrees = 1;

    bool operator==(const MapRequest& other) const;
};

/// The numbers, and how they are shown.
struct FaceMap {
    MapRequest request;
    std::vector<double> values;        ///< per face of the surface: mm, or for strain a share
    std::vector<double> standInValues; ///< per face of its stand-in, if it has one
    scene::ValueScale scale;
    std::array<double, scene::ValueScale::classes> areas{}; ///< mm²
    double freeArea = 0;                                    ///< mm², of undercut depths: what is no undercut
    double largest = 0;
    Eigen::Vector3d largestPlace = Eigen::Vector3d::Zero(); ///< mm
};

/// Whether a mode paints a map of numbers, and whether it needs a cast, or two.
[[nodiscard]] bool isMap(DisplayMode mode);
[[nodiscard]] bool needsCast(DisplayMode mode);

/// Makes maps on a thread of its own. For each content and mode only the newest request waits.
class LiveMaps : public QObject {
    Q_OBJECT
public:
    explicit LiveMaps(QObject* parent = nullptr);
    ~LiveMaps() override;

    void ask(const MapRequest& request);

Q_SIGNALS:
    void answered(const std::shared_ptr<const moldwright::FaceMap>& map);

private:
    using Key = std::pair<ViewContent, DisplayMode>;

    void work();

    std::mutex m_mutex;
    std::map<Key, MapRequest> m_waiting;
    WorkThread m_thread;
};

/// Computes a map. Precondition: a cast where the mode needs one.
[[nodiscard]] FaceMap faceMap(const MapRequest& request);

} // namespace moldwright
