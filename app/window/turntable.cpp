// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/turntable.h"

#include "view/part_view.h"

#include <numbers>
#include <utility>

namespace moldwright {

namespace {

constexpr int lookMilliseconds = 15; ///< between two looks whether the picture is there
constexpr int mostWaiting = 3;       ///< pictures that wait to be packed: they are large

} // namespace

Turntable::Turntable(PartView& view, QObject* parent)
    : QObject(parent), m_view(&view), m_from(view.camera()) {
    m_thread.setObjectName(QStringLiteral("turntable"));
    m_place.moveToThread(&m_thread);
    m_timer.setInterval(lookMilliseconds);
    connect(&m_timer, &QTimer::timeout, this, &Turntable::takePicture);
    connect(&view, &QObject::destroyed, this, &Turntable::end);
}

Turntable::~Turntable() {
    m_thread.quit();
    m_thread.wait();
}

void Turntable::start() {
    m_thread.start();
    lookOn();
    m_timer.start();
}

void Turntable::lookOn() {
    const double turned = 2 * std::numbers::pi * m_taken / pictures;
    m_view->standAt(scene::orbited(m_from, m_view->scene().middle(), turned, 0));
}

void Turntable::takePicture() {
    if (m_view->drawing() || m_taken - m_packed >= mostWaiting)
        return;
    QMetaObject::invokeMethod(&m_place, [this, picture = m_view->picture()] {
        m_animation.add(picture);
        QMetaObject::invokeMethod(this, &Turntable::packed);
    });
    Q_EMIT progressed(++m_taken);
    if (m_taken < pictures)
        lookOn();
    else
        m_timer.stop();
}

void Turntable::packed() {
    if (++m_packed < pictures || m_over)
        return;
    Q_EMIT finished(m_animation);
    end();
}

void Turntable::end() {
    if (std::exchange(m_over, true))
        return;
    m_timer.stop();
    if (m_view)
        m_view->standAt(m_from);
    Q_EMIT ended();
}

} // namespace moldwright
