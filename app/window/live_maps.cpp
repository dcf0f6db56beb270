// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/live_maps.h"

#include "castability/analysis.h"
#include "design/comparison.h"
#include "design/strain.h"
#include "mesh/measures.h"

#include <algorithm>
#include <utility>

namespace moldwright {

namespace {

std::vector<double> valuesFor(const MapRequest& request) {
    const IndexedMesh& surface = *request.surface;
    switch (request.mode) {
    case DisplayMode::UndercutDepth:
        return undercutDepths(surface, request.state, request.draftDegrees);
    case DisplayMode::Strain:
        return faceStrains(request.cast->before, surface);
    case DisplayMode::Deviation: {
        Deviation both = deviation(*request.part, *request.cast->mesh, request.cast->before);
        return request.content == ViewContent::Part ? std::move(both.ofPart) : std::move(both.ofCast);
    }
    case DisplayMode::Difference:
        return castDifference(surface, request.cast->before, *request.other->mesh, request.other->before);
    case DisplayMode::Undercuts:
    case DisplayMode::DraftMap:
    case DisplayMode::Importance:
    case DisplayMode::Steel:
    case DisplayMode::Plain:
        break;
    }
    return {};
}

/// Two casts beside each other are painted by one scale.
scene::ValueScale scaleOf(const MapRequest& request, std::vector<double> values) {
    if (request.mode == DisplayMode::Difference) {
        const std::vector<double> back = castDifference(*request.other->mesh, request.other->before,
                                                        *request.surface, request.cast->before);
        values.insert(values.end(), back.begin(), back.end());
        std::ranges::sort(values); // both ways alike, also where the scale's sums are rounded
    }
    return scene::scaleFor(values);
}

} // namespace

bool isMap(DisplayMode mode) {
    return mode == DisplayMode::UndercutDepth || needsCast(mode);
}

bool needsCast(DisplayMode mode) {
    return mode == DisplayMode::Deviation || mode == DisplayMode::Difference || mode == DisplayMode::Strain;
}

bool MapRequest::operator==(const MapRequest& that) const {
    const bool same = mode == that.mode && content == that.content && surface == that.surface;
    return same && (needsCast(mode) ? part == that.part && cast == that.cast && other == that.other
                                    : state == that.state && draftDegrees == that.draftDegrees);
}

FaceMap faceMap(const MapRequest& request) {
    FaceMap map;
    map.request = request;
    map.values = valuesFor(request);
    const IndexedMesh& mesh = *request.surface;
    map.scale = scaleOf(request, map.values);
    for (int f = 0; f < mesh.faceCount(); ++f) {
        const bool free = request.mode == DisplayMode::UndercutDepth && map.values[f] == 0;
        (free ? map.freeArea : map.areas[map.scale.classOf(map.values[f])]) +=
            doubleAreaVector(mesh, f).norm() / 2;
    }
    const auto largest = std::ranges::max_element(map.values);
    map.largest = *largest;
    const auto at = static_cast<int>(largest - map.values.begin());
    map.largestPlace = (mesh.corner(at, 0) + mesh.corner(at, 1) + mesh.corner(at, 2)) / 3;
    if (request.standIn)
        map.standInValues = scene::carriedOver(mesh, map.values, *request.standIn);
    return map;
}

LiveMaps::LiveMaps(QObject* parent) : QObject(parent), m_thread(QStringLiteral("maps")) {}

LiveMaps::~LiveMaps() {
    {
        const std::lock_guard lock(m_mutex);
        m_waiting.clear();
    }
}

void LiveMaps::ask(const MapRequest& request) {
    {
        const std::lock_guard lock(m_mutex);
        m_waiting[{request.content, request.mode}] = request;
    }
    m_thread.post([this] { work(); });
}

void LiveMaps::work() {
    MapRequest request;
    {
        const std::lock_guard lock(m_mutex);
        if (m_waiting.empty())
            return; // newer requests took the place of the one that woke this
        request = m_waiting.extract(m_waiting.begin()).mapped();
    }
    const auto map = std::make_shared<const FaceMap>(faceMap(request));
    QMetaObject::invokeMethod(this, [this, map] { Q_EMIT answered(map); });
}

} // namespace moldwright
