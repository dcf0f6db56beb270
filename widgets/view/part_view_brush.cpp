// SPDX-License-Identifier: AGPL-3.0-or-later
// Strokes and lassos over what a view shows, and the ring of the brush.
#include "view/part_view.h"

#include "mesh/measures.h"

#include <QKeyEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace moldwright {

namespace {

constexpr double keyStep = 8; ///< logical pixels that an arrow key moves the brush
constexpr int mostDabs = 12;  ///< between two places of the pointer

} // namespace

void PartView::setBrushRadius(double radius) {
    if (radius == m_brushRadius)
        return;
    m_brushRadius = radius;
    if (m_picking == Picking::Stroke && !m_scene.brush().places().empty())
        showBrush(m_last);
}

void PartView::sizeBrush() {
    if (m_picking != Picking::Stroke || m_stroke || !(m_brushRadius > 0))
        return;
    m_radiusBefore = m_brushRadius;
    m_sizedTo.reset();
}

void PartView::beginPainting(const Eigen::Vector2d& at, bool inverted) {
    if (m_picking == Picking::Lasso) {
        m_inverted = inverted;
        m_lasso = {at};
        return;
    }
    const auto hit = hitAt(at);
    if (!hit || hit->face < 0)
        return;
    m_stroke = true;
    Q_EMIT strokeBegan(*hit, inverted);
}

void PartView::paintTo(const Eigen::Vector2d& at) {
    moving();
    if (!m_lasso.empty()) {
        m_lasso.push_back(at);
        showLasso();
        return;
    }
    // Half a radius apart the brush leaves no gap, however fast the pointer goes.
    const double step = std::max(2.0, m_brushRadius / m_camera.pixelSize(viewSize()) / 2);
    const int dabs = std::clamp(static_cast<int>(std::ceil((at - m_last).norm() / step)), 1, mostDabs);
    std::vector<scene::SurfacePicker::Hit> hits;
    for (int i = 1; i <= dabs; ++i)
        if (const auto hit = hitAt(m_last + (at - m_last) * i / dabs); hit && hit->face >= 0)
            hits.push_back(*hit);
    if (!hits.empty())
        Q_EMIT strokeWentOn(hits);
    showBrush(at);
}

void PartView::endPainting() {
    if (std::exchange(m_stroke, false)) {
        Q_EMIT strokeEnded();
        return;
    }
    const scene::Lasso lasso = takenLasso();
    if (lasso.line.size() > 2)
        Q_EMIT lassoDrawn(lasso, m_inverted);
}

scene::Lasso PartView::takenLasso() {
    m_scene.setBrush({});
    redraw();
    return {std::exchange(m_lasso, {}), m_camera, viewSize(), m_scene.cut()};
}

void PartView::drawBox(const Eigen::Vector2d& to) {
    moving();
    m_lasso = {m_pressed, {to.x(), m_pressed.y()}, to, {m_pressed.x(), to.y()}, m_pressed};
    showLasso();
}

void PartView::showBrush(const Eigen::Vector2d& at) {
    moving();
    const auto hit = hitAt(at);
    const bool over = hit && hit->face >= 0 && m_brushRadius > 0;
    m_scene.setBrush(over ? scene::circleAbout(hit->point,
                                               doubleAreaVector(*m_picker->mesh(), hit->face).normalized(),
                                               m_brushRadius)
                          : std::vector<Eigen::Vector3d>());
    redraw();
}

void PartView::showLasso() {
    std::vector<Eigen::Vector3d> places;
    for (const Eigen::Vector2d& pixel : m_lasso) {
        const scene::Ray ray = m_camera.rayAt(pixel.x(), pixel.y(), viewSize());
        const double depth =
            (m_camera.focus - ray.origin).dot(m_camera.backwards()) / ray.direction.dot(m_camera.backwards());
        places.emplace_back(ray.origin + depth * ray.direction);
    }
    m_scene.setBrush(places);
    redraw();
}

void PartView::keyPressEvent(QKeyEvent* event) {
    const double step = (event->modifiers().testFlag(Qt::ShiftModifier) ? 1 : keyStep) * devicePixelRatioF();
    Eigen::Vector2d way = Eigen::Vector2d::Zero();
    way.x() = event->key() == Qt::Key_Right ? step : event->key() == Qt::Key_Left ? -step : 0;
    way.y() = event->key() == Qt::Key_Down ? step : event->key() == Qt::Key_Up ? -step : 0;
    const bool dab = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (m_picking != Picking::Stroke || m_stroke || (way.isZero() && !dab)) {
        RenderView::keyPressEvent(event);
        return;
    }
    // Where the pointer never was, the brush begins in the middle.
    if (!QRectF(rect()).contains(m_last.x() / devicePixelRatioF(), m_last.y() / devicePixelRatioF()) ||
        m_scene.brush().places().empty())
        m_last = Eigen::Vector2d(viewSize().width, viewSize().height) / 2;
    m_last += way;
    if (dab) {
        beginPainting(m_last, false);
        endPainting();
    }
    showBrush(m_last);
    event->accept();
}

} // namespace moldwright
