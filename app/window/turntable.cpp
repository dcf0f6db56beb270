// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/turntable.h"

#include "view/part_view.h"

#include <numbers>

namespace moldwright {

namespace {

constexpr int lookMilliseconds = 15; ///< between two looks whether the picture is there

} // namespace

Turntable::Turntable(PartView& view, QObject* parent)
    : QObject(parent), m_view(&view), m_from(view.camera()) {
    m_timer.setInterval(lookMilliseconds);
    connect(&m_timer, &QTimer::timeout, this, &Turntable::takePicture);
    connect(&view, &QObject::destroyed, this, &Turntable::end);
}

void Turntable::start() {
    lookOn();
    m_timer.start();
}

void Turntable::lookOn() {
    const double turned = 2 * std::numbers::pi * m_animation.count() / pictures;
    m_view->standAt(scene::orbited(m_from, m_view->scene().middle(), turned, 0));
}

void Turntable::takePicture() {
    if (m_view->drawing())
        return;
    m_animation.add(m_view->grabFramebuffer());
    Q_EMIT progressed(m_animation.count());
    if (m_animation.count() < pictures) {
        lookOn();
        return;
    }
    Q_EMIT finished(m_animation);
    end();
}

void Turntable::end() {
    m_timer.stop();
    if (m_view)
        m_view->standAt(m_from);
    Q_EMIT ended();
}

} // namespace moldwright
