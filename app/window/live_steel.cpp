// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/live_steel.h"

#include "scene/value_scale.h"

namespace moldwright {

LiveSteel::LiveSteel(QObject* parent)
    : QObject(parent),
      m_job(QStringLiteral("steel"), [this](const std::shared_ptr<const Mold>& mold) { work(mold); }) {}

LiveSteel::~LiveSteel() {
    m_task.cancel();
}

const ShownSteel* LiveSteel::of(const std::shared_ptr<const Mold>& mold) {
    if (m_asked != mold) {
        m_asked = mold;
        m_shown.reset();
        m_job.ask(mold);
    }
    return m_shown.get();
}

void LiveSteel::work(const std::shared_ptr<const Mold>& mold) {
    const auto steel = std::make_shared<ShownSteel>();
    steel->mold = mold;
    for (const std::size_t i : {0UL, 1UL}) {
        Result<SteelMap> map = steelMap(*mold, i == 0 ? 1 : 2, m_task);
        if (!map)
            return;
        steel->maps[i] = *std::move(map);
        steel->halves[i] = scene::drawnMesh(steel->maps[i].surface);
        if (const auto& standIn = steel->halves[i]->standIn)
            steel->standInSteel[i] =
                scene::carriedOver(*steel->maps[i].surface, steel->maps[i].thickness, *standIn->mesh);
    }
    QMetaObject::invokeMethod(this, [this, steel] { take(steel); });
}

void LiveSteel::take(const std::shared_ptr<const ShownSteel>& steel) {
    if (steel->mold != m_asked)
        return;
    m_shown = steel;
    Q_EMIT measured();
}

} // namespace moldwright
