// SPDX-License-Identifier: AGPL-3.0-or-later
#include "view/part_view.h"

#include <QGuiApplication>
#include <QMouseEvent>
#include <QStyle>
#include <QWheelEvent>

#include <vtkGenericOpenGLRenderWindow.h>

#include <cmath>
#include <numbers>

namespace moldwright {

namespace {

constexpr double clickReach = 4;        ///< logical pixels a click may wander
constexpr double gripReach = 12;        ///< logical pixels about a grip
constexpr double turnPerPixel = 0.0085; ///< radians
constexpr double zoomPerPixel = 1.006;
constexpr double zoomPerNotch = 1.15;
constexpr int settleMilliseconds = 250;
constexpr std::chrono::milliseconds smooth(60);  ///< a picture that takes longer makes movements jerk
constexpr std::chrono::milliseconds flowing(25); ///< one that takes less can be as fine as it likes
const Eigen::Vector3d homeDirection(0.75, -1, 0.6);

scene::Held heldNow(Qt::MouseButtons buttons, Qt::KeyboardModifiers keys) {
    return {buttons.testFlag(Qt::LeftButton),   buttons.testFlag(Qt::MiddleButton),
            buttons.testFlag(Qt::RightButton),  keys.testFlag(Qt::ShiftModifier),
            keys.testFlag(Qt::ControlModifier), keys.testFlag(Qt::AltModifier)};
}

} // namespace

PartView::PartView(QWidget* parent) : RenderView(parent), m_navigation(&scene::navigationSchemes().front()) {
    setFocusPolicy(Qt::StrongFocus);
    setMouseTracking(true);
    setAccessibleName(tr("View of the part"));
    m_scene.showIn(window());
    m_camera = scene::lookingFrom(m_camera, homeDirection);
    m_ease.setStartValue(0.0);
    m_ease.setEndValue(1.0);
    m_ease.setDuration(160);
    m_ease.setEasingCurve(QEasingCurve::OutCubic);
    m_settle.setSingleShot(true);
    m_settle.setInterval(settleMilliseconds);
    connect(&m_settle, &QTimer::timeout, this, &PartView::settled);
    connect(&m_ease, &QVariantAnimation::valueChanged, this,
            [this](const QVariant& t) { stepCamera(scene::between(m_easeFrom, m_easeTo, t.toDouble())); });
}

PartView::~PartView() = default;

scene::ViewSize PartView::viewSize() const {
    return {std::max(1.0, width() * devicePixelRatioF()), std::max(1.0, height() * devicePixelRatioF())};
}

Eigen::Vector2d PartView::pixel(const QPointF& place) const {
    return Eigen::Vector2d(place.x(), place.y()) * devicePixelRatioF();
}

void PartView::prepare(int width, int height, bool quick) {
    // Seen-through blocks would show where they meet: such a surface is drawn as a whole or not at all.
    m_scene.useStandIns(m_coarse || (tooSlow() && (m_isMoving || quick || m_scene.seeThrough())));
    m_scene.setSmoothEdges(!(m_isMoving || m_live || quick) || m_restPicture < flowing);
    m_scene.arrange(m_camera, {static_cast<double>(width), static_cast<double>(height)});
}

bool PartView::drawsInSlices() const {
    return tooSlow() && !m_isMoving && !m_coarse && !m_scene.seeThrough();
}

void PartView::pictureDone() {
    if (m_scene.standInsUsed() || m_isMoving || m_live)
        return;
    m_restPicture = lastPicture();
    m_timed = m_scene.surface();
}

bool PartView::tooSlow() const {
    const scene::SharedDrawnMesh& surface = m_scene.surface();
    if (!surface || !surface->standIn || surface->sketched())
        return false;
    // What was never drawn may be: nobody knows the graphics card.
    return m_timed.lock() != surface || m_restPicture > smooth;
}

void PartView::moving() {
    m_isMoving = true;
    m_settle.start();
}

void PartView::settled() {
    if (QGuiApplication::mouseButtons() != Qt::NoButton) {
        m_settle.start(); // held still, not let go
        return;
    }
    m_isMoving = false;
    redraw();
}

void PartView::stepCamera(const scene::Camera& camera) {
    moving();
    m_camera = camera;
    redraw();
    Q_EMIT cameraMoved();
}

void PartView::setCamera(const scene::Camera& camera) {
    m_ease.stop();
    stepCamera(camera);
}

void PartView::standAt(const scene::Camera& camera) {
    m_ease.stop();
    m_settle.stop();
    m_isMoving = false;
    m_camera = camera;
    redraw();
}

void PartView::easeTo(const scene::Camera& target) {
    m_ease.stop();
    if (!isVisible() || style()->styleHint(QStyle::SH_Widget_Animation_Duration, nullptr, this) == 0) {
        setCamera(target);
        return;
    }
    m_easeFrom = m_camera;
    m_easeTo = target;
    m_ease.start();
}

void PartView::setPerspective(bool perspective) {
    scene::Camera camera = m_camera;
    camera.perspective = perspective;
    setCamera(camera);
}

scene::Camera PartView::fittedTo(const scene::Camera& camera, std::span<const Eigen::Vector3d> points) const {
    // Discs at the outermost points have a size in pixels: a frame of theirs stays free.
    const scene::ViewSize view = viewSize();
    const double frame = std::min(gripReach * devicePixelRatioF(), std::min(view.width, view.height) / 8);
    const scene::ViewSize within{view.width - 2 * frame, view.height - 2 * frame};
    scene::Camera fit = scene::fitted(camera, points, within);
    fit.distance *= view.height / within.height;
    return fit;
}

void PartView::fitAll(bool atOnce) {
    // A turn that is under way goes on to its end.
    const bool turning = m_ease.state() == QAbstractAnimation::Running;
    const scene::Camera fit = fittedTo(turning ? m_easeTo : m_camera, m_scene.outline());
    atOnce ? setCamera(fit) : easeTo(fit);
}

void PartView::frame(const Eigen::AlignedBox3d& box) {
    easeTo(fittedTo(m_camera, scene::cornersOf(box)));
}

void PartView::lookFrom(const Eigen::Vector3d& direction) {
    easeTo(fittedTo(scene::lookingFrom(m_camera, direction), m_scene.outline()));
}

void PartView::lookHome(bool atOnce) {
    if (atOnce)
        setCamera(scene::lookingFrom(m_camera, homeDirection));
    else
        lookFrom(homeDirection);
}

void PartView::lookFromOpposite() {
    lookFrom(-m_camera.backwards());
}

void PartView::setEditable(bool editable) {
    m_editable = editable;
    m_scene.setGrips(editable, m_hovered);
    redraw();
}

void PartView::setPicking(Picking picking) {
    m_picking = picking;
    updatePointer();
}

void PartView::updatePointer() {
    setCursor(m_picking != Picking::Nothing ? Qt::CrossCursor
              : m_drag                      ? Qt::ClosedHandCursor
              : m_hovered && m_editable     ? Qt::OpenHandCursor
                                            : Qt::ArrowCursor);
}

std::optional<scene::SurfacePicker::Hit> PartView::hitAt(const Eigen::Vector2d& at) const {
    return m_picker ? m_picker->pick(m_camera.rayAt(at.x(), at.y(), viewSize()), m_scene.cut())
                    : std::nullopt;
}

Eigen::Vector3d PartView::pivotAt(const Eigen::Vector2d& at) const {
    if (const auto hit = hitAt(at))
        return hit->point;
    return m_scene.surface() ? m_scene.middle() : m_camera.focus;
}

std::optional<scene::Grip> PartView::gripUnder(const Eigen::Vector2d& at) const {
    return scene::gripAt(m_scene.grips(), m_camera, viewSize(), at.x(), at.y(),
                         gripReach * devicePixelRatioF());
}

QPoint PartView::gripPixel(scene::Grip grip) const {
    for (const scene::GripPlace& shown : m_scene.grips())
        if (shown.grip == grip)
            return pixelOf(shown.place);
    return {-1, -1};
}

QPoint PartView::pixelOf(const Eigen::Vector3d& place) const {
    const Eigen::Vector3d at = m_camera.project(place, viewSize()) / devicePixelRatioF();
    return {static_cast<int>(std::lround(at.x())), static_cast<int>(std::lround(at.y()))};
}

void PartView::mousePressEvent(QMouseEvent* event) {
    const Eigen::Vector2d at = pixel(event->position());
    if (event->buttons() == event->button()) {
        m_pressed = at;
        m_dragged = false;
    }
    m_last = at;
    m_pivot = pivotAt(at);
    if (event->button() == Qt::LeftButton && event->buttons() == Qt::LeftButton)
        leftPressed(at);
    else
        cancelDrag();
    event->accept();
}

void PartView::leftPressed(const Eigen::Vector2d& at) {
    if (const auto direction = m_scene.cube().viewAt(m_camera, viewSize(), at.x(), at.y())) {
        m_dragged = true; // the cube has had this press
        lookFrom(*direction);
        return;
    }
    if (const auto grip = gripUnder(at); grip && m_picking == Picking::Nothing) {
        takeHold(*grip, at);
        updatePointer();
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
    if (m_drag && m_dragged) {
        moving();
        Q_EMIT dragPreviewed(dragged(at, event->modifiers().testFlag(Qt::ControlModifier)), *m_hovered);
    } else if (m_dragged)
        moveCamera(m_navigation->motionFor(heldNow(event->buttons(), event->modifiers())), m_last, at);
    m_last = at;
    event->accept();
}

void PartView::hover(const Eigen::Vector2d& at) {
    if (m_picking == Picking::Place)
        Q_EMIT pointHovered(hitAt(at));
    const auto grip = gripUnder(at);
    if (grip == m_hovered)
        return;
    m_hovered = grip;
    m_scene.setGrips(m_editable, grip);
    updatePointer();
    redraw();
}

void PartView::leaveEvent(QEvent* event) {
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
    if (event->button() == Qt::LeftButton && m_drag) {
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
    if ((pinning || m_picking == Picking::Nothing) && clickedMark(at))
        return;
    if (pinning) {
        placePin(at, (m_picking == Picking::PinInside) != keys.testFlag(Qt::ShiftModifier));
        return;
    }
    const auto hit = m_picking == Picking::Nothing ? std::nullopt : hitAt(at);
    if (hit && m_picking == Picking::Place)
        Q_EMIT pointClicked(*hit);
    else if (hit && hit->face >= 0)
        Q_EMIT faceClicked(hit->face);
}

bool PartView::clickedMark(const Eigen::Vector2d& at) {
    const double reach = gripReach * devicePixelRatioF();
    if (const auto pin = m_scene.pins().at(m_camera, viewSize(), at.x(), at.y(), reach)) {
        Q_EMIT pinClicked(*pin);
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

bool PartView::cancelDrag() {
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
