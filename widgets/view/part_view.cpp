// SPDX-License-Identifier: AGPL-3.0-or-later
#include "view/part_view.h"

#include <QGuiApplication>
#include <QStyle>

#include <vtkGenericOpenGLRenderWindow.h>

#include <cmath>
#include <numbers>

namespace moldwright {

namespace {

constexpr int settleMilliseconds = 250;
constexpr std::chrono::milliseconds smooth(60);  ///< a picture that takes longer makes movements jerk
constexpr std::chrono::milliseconds flowing(25); ///< one that takes less can be as fine as it likes
const Eigen::Vector3d homeDirection(0.75, -1, 0.6);

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
    m_scene.arrange(m_camera, {static_cast<double>(width), static_cast<double>(height)},
                    !(m_isMoving || m_live || quick));
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

QColor PartView::ground() const {
    const scene::Rgb colour = m_scene.colours().viewBottom;
    return {colour.r, colour.g, colour.b};
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
    double top = frame;
    double bottom = frame;
    const auto fit = [&] {
        const scene::ViewSize within{view.width - 2 * frame, view.height - top - bottom};
        scene::Camera fitted = scene::fitted(camera, points, within);
        fitted.distance *= view.height / within.height;
        return scene::panned(fitted, 0, (top - bottom) / 2, view);
    };
    // Where the shape would lie under the legend's row or the state, it makes room for them.
    const scene::Overlay& overlay = m_scene.overlay();
    if (const auto shape = m_scene.shapeSpot(fit(), view)) {
        if (shape->bottom < overlay.legend().rowRoom())
            bottom = std::min(overlay.legend().rowRoom(), view.height / 4);
        if (shape->overlaps(overlay.stateSpot(view)))
            top = std::min(view.height - overlay.stateSpot(view).bottom + frame / 2, view.height / 4);
    }
    return fit();
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
    cancelDrag();
    m_picking = picking;
    m_scene.setBrush({});
    updatePointer();
}

void PartView::updatePointer() {
    setCursor(m_picking != Picking::Nothing ? Qt::CrossCursor
              : m_drag                      ? Qt::ClosedHandCursor
              : m_feature                   ? Qt::ClosedHandCursor
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

std::optional<scene::FeatureAt> PartView::featureUnder(const Eigen::Vector2d& at) const {
    return m_scene.features().at(m_camera, viewSize(), at.x(), at.y(), gripReach * devicePixelRatioF());
}

double PartView::pixelLength() const {
    return m_camera.pixelSize(viewSize()) * devicePixelRatioF();
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

} // namespace moldwright
