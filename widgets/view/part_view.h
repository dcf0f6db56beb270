// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/direction_handle.h"
#include "scene/lasso.h"
#include "scene/navigation.h"
#include "scene/scene.h"
#include "scene/surface_picker.h"
#include "view/render_view.h"

#include <QPoint>
#include <QTimer>
#include <QVariantAnimation>

#include <memory>
#include <optional>
#include <span>
#include <variant>
#include <vector>

namespace moldwright {

/// One view of the part: turns mouse and wheel into camera moves after the chosen navigation scheme, and the
/// left button into what the tool does. It changes nothing but its camera; what the user wants is told by
/// signals.
class PartView : public RenderView {
    Q_OBJECT
public:
    explicit PartView(QWidget* parent = nullptr);
    ~PartView() override;

    [[nodiscard]] scene::Scene& scene() { return m_scene; }

    void setNavigation(const scene::NavigationScheme& scheme) { m_navigation = &scheme; }
    void setPicker(std::shared_ptr<const scene::SurfacePicker> picker) { m_picker = std::move(picker); }

    /// While on, large surfaces are shown by their stand-ins: what they are to look like is not known yet.
    void setCoarse(bool coarse) { m_coarse = coarse; }
    /// While on, pictures follow one another quickly.
    void setLive(bool live) { m_live = live; }

    /// Whether grips of plane and directions are shown and can be dragged.
    void setEditable(bool editable);
    /// What a click on the surface means, under a crossing pointer: faceClicked(), pointClicked(), or
    /// pinPlaced() on the surface or inside (Shift: the other way). A stroke is drawn over the surface, by
    /// the arrow keys and Return too; a lasso around what is seen.
    enum class Picking { Nothing, Face, Place, Pin, PinInside, Stroke, Lasso };
    void setPicking(Picking picking);
    [[nodiscard]] Picking picking() const { return m_picking; }
    /// The circle shown under a hand that draws strokes, mm; 0: none.
    void setBrushRadius(double radius);
    /// The pointer makes the brush larger on its way right and smaller on its way left, until a click;
    /// cancelDrag() gives it its radius back.
    void sizeBrush();

    [[nodiscard]] const scene::Camera& camera() const { return m_camera; }
    /// The length of a logical pixel at the camera's focus, mm.
    [[nodiscard]] double pixelLength() const;
    void setPerspective(bool perspective);
    /// Looks from there without moving there: the next picture is as fine as can be. Nobody is told.
    void standAt(const scene::Camera& camera);
    /// Looks from there at once, as another view does.
    void followCamera(const scene::Camera& camera) { setCamera(camera); }

    /// The camera eases to where all is in sight.
    void fitAll(bool atOnce = false);
    void lookFrom(const Eigen::Vector3d& direction);
    void lookHome(bool atOnce = false);
    /// To the other side of what is in view.
    void lookFromOpposite();
    void frame(const Eigen::AlignedBox3d& box);

    /// Gives up a drag of a grip, a stroke or a lasso; returns whether there was one.
    bool cancelDrag();

    /// A pixel of this widget where a point of the scene is, mm.
    [[nodiscard]] QPoint pixelOf(const Eigen::Vector3d& place) const;
    /// A pixel of this widget where a grip is, for tests and tours; outside when it is not shown.
    [[nodiscard]] QPoint gripPixel(scene::Grip grip) const;

Q_SIGNALS:
    /// A grip of the plane or a direction is dragged; committed once, when it is let go.
    void dragPreviewed(const moldwright::MoldState& state, moldwright::scene::Grip grip);
    void dragCommitted(const moldwright::MoldState& state, moldwright::scene::Grip grip);
    void dragCancelled();
    void faceClicked(int face);
    /// A place on the surface, or on the section that cuts it open, was clicked; the pointer is over it, or
    /// over none.
    void pointClicked(const moldwright::scene::SurfacePicker::Hit& hit);
    void pointHovered(const std::optional<moldwright::scene::SurfacePicker::Hit>& hit);
    /// A place for a pin was clicked, mm: on the surface, or as far inside as can be under the pointer.
    void pinPlaced(const Eigen::Vector3d& place);
    /// A stroke over the surface; `inverted`: with Ctrl. All places that the pointer passes are told.
    void strokeBegan(const moldwright::scene::SurfacePicker::Hit& hit, bool inverted);
    void strokeWentOn(const std::vector<moldwright::scene::SurfacePicker::Hit>& hits);
    void strokeEnded();
    void strokeCancelled();
    /// The brush is wanted larger by a factor.
    void brushScaled(double factor);
    void lassoDrawn(const moldwright::scene::Lasso& lasso, bool inverted);
    /// A pin of the scene is dragged: the ray under the pointer, and the surface there; then let go, or not.
    void pinDragged(int pin, const moldwright::scene::Ray& ray,
                    const moldwright::scene::SurfacePicker::Hit& hit);
    void pinDropped(int pin);
    void pinDragCancelled();
    /// A pin of the scene was clicked.
    void pinClicked(const moldwright::scene::PinAt& pin, Qt::KeyboardModifiers keys);
    /// A feature of the mold is dragged: the ray under the pointer, to be taken as it is when `exactly`; then
    /// let go, or not.
    void featureDragged(const moldwright::scene::FeatureAt& feature, const moldwright::scene::Ray& ray,
                        bool exactly);
    void featureDropped();
    void featureDragCancelled();
    void featureClicked(const moldwright::scene::FeatureAt& feature, Qt::KeyboardModifiers keys);
    /// The surface was clicked while that means nothing to a tool, and nothing that can be chosen is there.
    void surfaceClicked(const moldwright::scene::SurfacePicker::Hit& hit, Qt::KeyboardModifiers keys);
    /// A box was drawn from where nothing can be taken hold of, while clicks on the surface mean nothing.
    void boxDrawn(const moldwright::scene::Lasso& box, Qt::KeyboardModifiers keys);
    /// The mark of a chip was clicked.
    void markClicked(int chip);
    void menuRequested(const QPoint& globalPlace);
    /// It looks from elsewhere.
    void cameraMoved();

protected:
    void prepare(int width, int height, bool quick) override;
    [[nodiscard]] bool drawsInSlices() const override;
    [[nodiscard]] int sliceCount() const override { return m_scene.sliceCount(); }
    void prepareSlice(int slice) override { m_scene.drawSlice(slice); }
    void pictureDone() override;
    [[nodiscard]] QColor ground() const override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    bool event(QEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;

private:
    [[nodiscard]] scene::ViewSize viewSize() const;
    /// The camera moved so that all these points, and grips at them, are in sight.
    [[nodiscard]] scene::Camera fittedTo(const scene::Camera& camera,
                                         std::span<const Eigen::Vector3d> points) const;
    [[nodiscard]] Eigen::Vector2d pixel(const QPointF& place) const;
    [[nodiscard]] std::optional<scene::SurfacePicker::Hit> hitAt(const Eigen::Vector2d& pixel) const;
    [[nodiscard]] Eigen::Vector3d pivotAt(const Eigen::Vector2d& pixel) const;
    [[nodiscard]] std::optional<scene::FeatureAt> featureUnder(const Eigen::Vector2d& pixel) const;
    [[nodiscard]] std::optional<scene::Grip> gripUnder(const Eigen::Vector2d& pixel) const;
    void leftPressed(const Eigen::Vector2d& at, Qt::KeyboardModifiers keys);
    void beginPainting(const Eigen::Vector2d& at, bool inverted);
    void paintTo(const Eigen::Vector2d& at);
    void endPainting();
    void showBrush(const Eigen::Vector2d& at);
    void showLasso();
    void drawBox(const Eigen::Vector2d& to);
    /// The lasso as far as it is drawn, which goes.
    [[nodiscard]] scene::Lasso takenLasso();
    void dragPin(const Eigen::Vector2d& to);
    void clicked(const Eigen::Vector2d& at, Qt::KeyboardModifiers keys);
    [[nodiscard]] bool clickedMark(const Eigen::Vector2d& at, Qt::KeyboardModifiers keys);
    void placePin(const Eigen::Vector2d& at, bool inside);
    void moveCamera(scene::Motion motion, const Eigen::Vector2d& from, const Eigen::Vector2d& to);
    void takeHold(scene::Grip grip, const Eigen::Vector2d& at);
    [[nodiscard]] MoldState dragged(const Eigen::Vector2d& to, bool coarse) const;
    void hover(const Eigen::Vector2d& at);
    void easeTo(const scene::Camera& target);
    void moving();
    void settled();
    [[nodiscard]] bool tooSlow() const;
    void setCamera(const scene::Camera& camera);
    void stepCamera(const scene::Camera& camera);
    void updatePointer();

    static constexpr double gripReach = 12; ///< logical pixels about a grip

    scene::Scene m_scene;
    scene::Camera m_camera;
    const scene::NavigationScheme* m_navigation;
    std::shared_ptr<const scene::SurfacePicker> m_picker;
    QVariantAnimation m_ease;
    QTimer m_settle; ///< runs out some time after the last movement
    bool m_isMoving = false;
    bool m_coarse = false;
    bool m_live = false;
    std::weak_ptr<const scene::DrawnMesh> m_timed; ///< the surface whose picture took m_restPicture
    std::chrono::milliseconds m_restPicture{0};    ///< as fine as can be
    scene::Camera m_easeFrom;
    scene::Camera m_easeTo;
    bool m_editable = false;
    Picking m_picking = Picking::Nothing;
    std::optional<std::variant<scene::PlaneDrag, scene::DirectionDrag>> m_drag;
    std::optional<int> m_pin;                  ///< the pin that is held
    std::optional<scene::FeatureAt> m_feature; ///< the feature that is
    double m_brushRadius = 0;
    std::optional<double> m_radiusBefore; ///< while the pointer sizes the brush
    std::optional<double> m_sizedTo;      ///< where it was last, px; none: it has not moved yet
    bool m_stroke = false;                ///< one is being drawn
    bool m_inverted = false;              ///< the lasso is
    bool m_boxes = false;                 ///< the button went down where a box begins
    std::vector<Eigen::Vector2d> m_lasso; ///< as far as it is drawn
    std::optional<scene::Grip> m_hovered; ///< the grip under the pointer, or held
    Eigen::Vector2d m_pressed = Eigen::Vector2d::Zero();
    Eigen::Vector2d m_last = Eigen::Vector2d::Zero();
    Eigen::Vector3d m_pivot = Eigen::Vector3d::Zero();
    bool m_dragged = false; ///< the pointer went far enough that the press is no click
};

} // namespace moldwright
