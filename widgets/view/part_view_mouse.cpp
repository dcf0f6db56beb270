// SPDX-License-Identifier: AGPL-3.0-or-later
// What mouse, wheel and keys do in a view.
#include "view/part_view.h"

#include "mesh/measures.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <QWheelEvent>

#include <algorithm>
#include <cmath>
#include <utility>

namespace moldwright {

namespace {

constexpr double clickReach = 4;        ///< logical pixels a click may wander
constexpr double turnPerPixel = 0.0085; ///< radians
constexpr double zoomPerPixel = 1.006;
constexpr double zoomPerNotch = 1.15;
constexpr double largerPerNotch = 1.2; ///< of the brush's radius
constexpr double largerPerPixel = 1.01;
constexpr double leastPinch = 0.2; ///< of the size, by one event of two fingers

scene::Held heldNow(Qt::MouseButtons buttons, Qt::KeyboardModifiers keys) {
    return {buttons.testFlag(Qt::LeftButton),   buttons.testFlag(Qt::MiddleButton),
            buttons.testFlag(Qt::RightButton),  keys.testFlag(Qt::ShiftModifier),
            keys.testFlag(Qt::ControlModifier), keys.testFlag(Qt::AltModifier)};
}

} // namespace

void PartView::mousePressEvent(QMouseEvent* event) {
    const Eigen::Vector2d at = pixel(event->position());
    if (m_radiusBefore) {
        m_radiusBefore.reset();
        m_dragged = true; // sizing has had this press
        event->accept();
        return;
    }
    if (event->buttons() == event->button()) {
        m_pressed = at;
        m_dragged = false;
    }
    m_last = at;
    m_pivot = pivotAt(at);
    if (event->button() == Qt::LeftButton && event->buttons() == Qt::LeftButton)
        leftPressed(at, event->modifiers());
    else
        cancelDrag();
    event->accept();
}

void PartView::leftPressed(const Eigen::Vector2d& at, Qt::KeyboardModifiers keys) {
    if (const auto direction = m_scene.cube().viewAt(m_camera, viewSize(), at.x(), at.y())) {
        m_dragged = true; // the cube has had this press
        lookFrom(*direction);
        return;
    }
    if (m_picking == Picking::Stroke || m_picking == Picking::Lasso) {
        beginPainting(at, keys.testFlag(Qt::ControlModifier));
        return;
    }
    const bool pins =
        m_picking == Picking::Nothing || m_picking == Picking::Pin || m_picking == Picking::PinInside;
    if (const auto pin = pins && m_editable ? m_scene.pins().at(m_camera, viewSize(), at.x(), at.y(),
                                                                gripReach * devicePixelRatioF())
                                            : std::nullopt;
        pin && !pin->suggested) {
        m_pin = pin->number;
        return;
    }
    if (m_picking != Picking::Nothing)
        return;
    if (const auto feature = featureUnder(at)) {
        m_feature = feature;
        updatePointer();
    } else if (const auto grip = gripUnder(at)) {
        takeHold(*grip, at);
        updatePointer();
    } else {
        m_boxes = true;
    }
}

void PartView::takeHold(scene::Grip grip, const Eigen::Vector2d& at) {
    m_hovered = grip;
    if (grip == scene::Grip::Direction1 || grip == scene::Grip::Direction2) {
        const int side = grip == scene::Grip::Direction1 ? 1 : 2;
        m_drag = scene::DirectionDrag{
            *m_scene.state(), side,  m_scene.middle(), m_scene.arrowTip(side), m_scene.directionLimits(),
            at.x(),           at.y()};
    } else {
        m_drag = scene::PlaneDrag{*m_scene.state(), m_scene.rectangle(), grip, at.x(), at.y()};
    }
}

MoldState PartView::dragged(const Eigen::Vector2d& to, bool coarse) const {
    return std::visit(
        [&](const auto& drag) { return drag.moved(m_camera, viewSize(), to.x(), to.y(), coarse); }, *m_drag);
}

void PartView::mouseMoveEvent(QMouseEvent* event) {
    const Eigen::Vector2d at = pixel(event->position());
    if (event->buttons() == Qt::NoButton) {
        hover(at);
        return;
    }
    m_dragged = m_dragged || (at - m_pressed).norm() > clickReach * devicePixelRatioF();
    if (m_boxes && m_dragged) {
        drawBox(at);
    } else if (m_stroke || !m_lasso.empty()) {
        paintTo(at);
    } else if (m_pin && m_dragged) {
        dragPin(at);
    } else if (m_feature && m_dragged) {
        moving();
        Q_EMIT featureDragged(*m_feature, m_camera.rayAt(at.x(), at.y(), viewSize()),
                              event->modifiers().testFlag(Qt::ShiftModifier));
    } else if (m_drag && m_dragged) {
        moving();
        Q_EMIT dragPreviewed(dragged(at, event->modifiers().testFlag(Qt::ControlModifier)), *m_hovered);
    } else if (m_dragged)
        moveCamera(m_navigation->motionFor(heldNow(event->buttons(), event->modifiers())), m_last, at);
    m_last = at;
    event->accept();
}

void PartView::hover(const Eigen::Vector2d& at) {
    if (m_radiusBefore) {
        const double way = at.x() - std::exchange(m_sizedTo, at.x()).value_or(at.x());
        Q_EMIT brushScaled(std::pow(largerPerPixel, way / devicePixelRatioF()));
        return;
    }
    if (m_picking == Picking::Place)
        Q_EMIT pointHovered(hitAt(at));
    if (m_picking == Picking::Stroke) {
        m_last = at;
        showBrush(at);
        return;
    }
    const auto grip = gripUnder(at);
    if (grip == m_hovered)
        return;
    m_hovered = grip;
    m_scene.setGrips(m_editable, grip);
    updatePointer();
    redraw();
}

void PartView::leaveEvent(QEvent* event) {
    if (!m_stroke && m_lasso.empty() && !m_scene.brush().places().empty()) {
        m_scene.setBrush({});
        redraw();
    }
    if (m_hovered && !m_drag) {
        m_hovered.reset();
        m_scene.setGrips(m_editable, m_hovered);
        redraw();
    }
    RenderView::leaveEvent(event);
}

void PartView::moveCamera(scene::Motion motion, const Eigen::Vector2d& from, const Eigen::Vector2d& to) {
    const Eigen::Vector2d way = (to - from) / devicePixelRatioF();
    switch (motion) {
    case scene::Motion::Orbit:
        setCamera(scene::orbited(m_camera, m_pivot, -way.x() * turnPerPixel, -way.y() * turnPerPixel));
        break;
    case scene::Motion::Pan:
        setCamera(scene::panned(m_camera, to.x() - from.x(), to.y() - from.y(), viewSize()));
        break;
    case scene::Motion::Zoom:
        setCamera(scene::zoomedAt(m_camera, std::pow(zoomPerPixel, -way.y()), m_pressed.x(), m_pressed.y(),
                                  viewSize()));
        break;
    case scene::Motion::None:
        break;
    }
}

void PartView::mouseReleaseEvent(QMouseEvent* event) {
    const Eigen::Vector2d at = pixel(event->position());
    if (!m_dragged) { // a click
        m_pin.reset();
        m_feature.reset();
        updatePointer();
    }
    if (event->button() == Qt::LeftButton && std::exchange(m_boxes, false) && !m_lasso.empty()) {
        Q_EMIT boxDrawn(takenLasso(), event->modifiers());
    } else if (event->button() == Qt::LeftButton && (m_stroke || !m_lasso.empty())) {
        endPainting();
    } else if (event->button() == Qt::LeftButton && m_pin && m_dragged) {
        Q_EMIT pinDropped(*std::exchange(m_pin, std::nullopt));
    } else if (event->button() == Qt::LeftButton && m_feature && m_dragged) {
        m_feature.reset();
        updatePointer();
        Q_EMIT featureDropped();
    } else if (event->button() == Qt::LeftButton && m_drag) {
        const MoldState state = dragged(at, event->modifiers().testFlag(Qt::ControlModifier));
        m_drag.reset();
        updatePointer();
        if (m_dragged)
            Q_EMIT dragCommitted(state, *m_hovered);
    } else if (event->button() == Qt::LeftButton && !m_dragged) {
        clicked(at, event->modifiers());
    } else if (event->button() == Qt::RightButton && !m_dragged) {
        Q_EMIT menuRequested(event->globalPosition().toPoint());
    }
    event->accept();
}

void PartView::clicked(const Eigen::Vector2d& at, Qt::KeyboardModifiers keys) {
    const bool pinning = m_picking == Picking::Pin || m_picking == Picking::PinInside;
    if ((pinning || m_picking == Picking::Nothing) && clickedMark(at, keys))
        return;
    if (pinning) {
        placePin(at, (m_picking == Picking::PinInside) != keys.testFlag(Qt::ShiftModifier));
        return;
    }
    const bool picks =
        m_picking == Picking::Face || m_picking == Picking::Place || m_picking == Picking::Nothing;
    const auto hit = picks ? hitAt(at) : std::nullopt;
    if (hit && m_picking == Picking::Place)
        Q_EMIT pointClicked(*hit);
    else if (hit && hit->face >= 0 && m_picking == Picking::Face)
        Q_EMIT faceClicked(hit->face);
    else if (hit && hit->face >= 0)
        Q_EMIT surfaceClicked(*hit, keys);
}

bool PartView::clickedMark(const Eigen::Vector2d& at, Qt::KeyboardModifiers keys) {
    const double reach = gripReach * devicePixelRatioF();
    if (const auto pin = m_scene.pins().at(m_camera, viewSize(), at.x(), at.y(), reach)) {
        Q_EMIT pinClicked(*pin, keys);
        return true;
    }
    if (const auto feature = featureUnder(at)) {
        Q_EMIT featureClicked(*feature, keys);
        return true;
    }
    const int chip = m_scene.overlay().markAt(m_camera, viewSize(), at.x(), at.y(), reach);
    if (chip >= 0)
        Q_EMIT markClicked(chip);
    return chip >= 0;
}

void PartView::placePin(const Eigen::Vector2d& at, bool inside) {
    const auto hit = hitAt(at);
    if (!hit)
        return;
    const auto middle =
        inside ? m_picker->middleBelow(*hit, m_camera.rayAt(at.x(), at.y(), viewSize())) : std::nullopt;
    Q_EMIT pinPlaced(middle.value_or(hit->point));
}

void PartView::dragPin(const Eigen::Vector2d& to) {
    moving();
    if (const auto hit = hitAt(to); hit && hit->face >= 0)
        Q_EMIT pinDragged(*m_pin, m_camera.rayAt(to.x(), to.y(), viewSize()), *hit);
}

bool PartView::event(QEvent* event) {
    if (event->type() != QEvent::NativeGesture)
        return RenderView::event(event);
    const auto* gesture = static_cast<QNativeGestureEvent*>(event);
    if (gesture->gestureType() != Qt::ZoomNativeGesture)
        return RenderView::event(event);
    const Eigen::Vector2d at = pixel(gesture->position());
    setCamera(
        scene::zoomedAt(m_camera, std::max(1 + gesture->value(), leastPinch), at.x(), at.y(), viewSize()));
    event->accept();
    return true;
}

bool PartView::cancelDrag() {
    if (m_radiusBefore) {
        Q_EMIT brushScaled(*std::exchange(m_radiusBefore, std::nullopt) / m_brushRadius);
        return true;
    }
    if (m_stroke || !m_lasso.empty()) {
        m_lasso.clear();
        m_boxes = false;
        m_scene.setBrush({});
        m_dragged = true;
        if (std::exchange(m_stroke, false))
            Q_EMIT strokeCancelled();
        redraw();
        return true;
    }
    if (std::exchange(m_pin, std::nullopt)) {
        m_dragged = true;
        Q_EMIT pinDragCancelled();
        return true;
    }
    if (std::exchange(m_feature, std::nullopt)) {
        m_dragged = true;
        updatePointer();
        Q_EMIT featureDragCancelled();
        return true;
    }
    if (!m_drag)
        return false;
    m_drag.reset();
    m_dragged = true;
    updatePointer();
    Q_EMIT dragCancelled();
    return true;
}

void PartView::wheelEvent(QWheelEvent* event) {
    const Eigen::Vector2d at = pixel(event->position());
    if (m_picking == Picking::Stroke && event->modifiers().testFlag(Qt::AltModifier)) {
        // With Alt the wheel's turn comes as one across.
        const QPoint turn = event->angleDelta();
        Q_EMIT brushScaled(std::pow(largerPerNotch, (turn.y() != 0 ? turn.y() : turn.x()) / 120.0));
        event->accept();
        return;
    }
    const scene::Motion motion = m_navigation->wheelFor(heldNow(event->buttons(), event->modifiers()));
    const QPoint fine = event->pixelDelta();
    const Eigen::Vector2d way = fine.isNull()
                                    ? Eigen::Vector2d(event->angleDelta().x(), event->angleDelta().y()) / 4
                                    : Eigen::Vector2d(fine.x(), fine.y());
    if (motion == scene::Motion::Zoom) {
        const double notches = fine.isNull() ? event->angleDelta().y() / 120.0 : fine.y() / 60.0;
        setCamera(scene::zoomedAt(m_camera, std::pow(zoomPerNotch, notches), at.x(), at.y(), viewSize()));
    } else {
        m_pivot = pivotAt(at);
        moveCamera(motion, at, at + way * devicePixelRatioF());
    }
    event->accept();
}

} // namespace moldwright
