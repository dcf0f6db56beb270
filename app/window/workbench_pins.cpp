// SPDX-License-Identifier: AGPL-3.0-or-later
// Pins: set, moved, named, removed.
#include "window/workbench.h"

#include "project/edits.h"

#include <algorithm>

namespace moldwright {

void Workbench::addPin(const Eigen::Vector3d& place) {
    std::vector<NamedPin> pins = m_document.committed().pins;
    pins.push_back({{inPart(place)}, {}});
    setPins(std::move(pins), tr("Pin a point"));
}

void Workbench::movePin(int pin, const Eigen::Vector3d& place, const QString& mergeKey, bool preview) {
    std::vector<NamedPin> pins = m_document.committed().pins;
    pins.at(static_cast<std::size_t>(pin)).point = place;
    if (preview) {
        m_document.preview(withPins(m_document.committed(), std::move(pins)));
        return;
    }
    setPins(std::move(pins), tr("Move %1").arg(pinName(pin)), mergeKey);
}

QString Workbench::pinName(int pin) const {
    const std::string& name = project().pins.at(static_cast<std::size_t>(pin)).name;
    return name.empty() ? tr("Pin %1").arg(pin + 1) : QString::fromStdString(name);
}

void Workbench::renamePin(int pin, const QString& name) {
    std::vector<NamedPin> pins = m_document.committed().pins;
    const bool plain = name.trimmed() == tr("Pin %1").arg(pin + 1); // its number stays right, whatever goes
    pins.at(static_cast<std::size_t>(pin)).name = plain ? std::string() : name.trimmed().toStdString();
    setPins(std::move(pins), tr("Rename"));
}

void Workbench::removePins(const std::vector<int>& pins) {
    std::vector<NamedPin> kept;
    for (int i = 0; i < static_cast<int>(project().pins.size()); ++i)
        if (std::ranges::find(pins, i) == pins.end())
            kept.push_back(m_document.committed().pins[static_cast<std::size_t>(i)]);
    setPins(std::move(kept), pins.size() == 1 ? tr("Remove %1").arg(pinName(pins.front()))
                                              : tr("Remove %1 pins").arg(pins.size()));
}

void Workbench::clearPins() {
    setPins({}, tr("Remove all pins"));
}

void Workbench::setPins(std::vector<NamedPin> pins, const QString& words, const QString& mergeKey) {
    m_document.edit(words, withPins(m_document.committed(), std::move(pins)), mergeKey);
}

} // namespace moldwright
