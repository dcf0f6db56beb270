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
    case DisplayMode::Undercuts:
    case DisplayMode::DraftMap:
    case DisplayMode::Importance:
    case DisplayMode::Plain:
        break;
    }
    return {};
}

} // namespace

bool isMap(DisplayMode mode) {
    return mode == DisplayMode::UndercutDepth || needsCast(mode);
}

bool needsCast(DisplayMode mode) {
    return mode == DisplayMode::Deviation || mode == DisplayMode::Strain;
}

bool MapRequest::operator==(const MapRequest& other) const {
    const bool same = mode == other.mode && content == other.content && surface == other.surface;
    return same && (needsCast(mode) ? part == other.part && cast == other.cast
                                    : state == other.state && draftDegrees == other.draftDegrees);
}

FaceMap faceMap(const MapRequest& request) {
    FaceMap map;
    map.request = request;
    map.values = valuesFor(request);
    const IndexedMesh& mesh = *request.surface;
    map.scale = scene::scaleFor(map.values);
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
