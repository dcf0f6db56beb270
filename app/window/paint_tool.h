// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "mesh/face_neighbours.h"
#include "mesh/geodesic_disc.h"
#include "scene/lasso.h"
#include "scene/surface_picker.h"

#include <QObject>

#include <memory>
#include <optional>
#include <vector>

namespace moldwright {

class ViewPane;
class Workbench;

/// Which faces a stroke takes: those under the brush, what is smooth with the face clicked, its whole piece,
/// or what is seen in a lasso.
enum class PaintBy { Brush, Crease, Piece, Lasso };

/// The tools that paint importance: they turn strokes over the part, its cast or a frame of a run into edits
/// of the part's regions, each shown while it is drawn and one undo step in the end.
class PaintTool : public QObject {
    Q_OBJECT
public:
    explicit PaintTool(Workbench& bench, QObject* parent = nullptr);

    /// None: put away.
    void setActive(std::optional<PaintBy> by) { m_by = by; }
    /// The region that strokes belong to; −1: a new one, or for strokes that erase all of them.
    void setRegion(int region) { m_region = region; }
    [[nodiscard]] int region() const { return m_region; }
    /// Strokes erase (and with Ctrl they do not).
    void setErasing(bool erasing) { m_erasing = erasing; }
    [[nodiscard]] bool erasing() const { return m_erasing; }

    /// Listens to a view.
    void serve(ViewPane& pane);

Q_SIGNALS:
    /// A stroke has become part of this region.
    void painted(int region);

private:
    void begin(const ViewPane& pane, const scene::SurfacePicker::Hit& hit, bool inverted);
    void goOn(const ViewPane& pane, const std::vector<scene::SurfacePicker::Hit>& hits);
    void end();
    void takeLasso(const ViewPane& pane, const scene::Lasso& lasso, bool inverted);
    /// Where on the part something was hit; none where it is not known, or filling made it.
    [[nodiscard]] std::optional<SurfacePlace> placeOf(const ViewPane& pane,
                                                      const scene::SurfacePicker::Hit& hit) const;
    void add(const SurfacePlace& place);

    Workbench& m_bench;
    std::optional<PaintBy> m_by;
    int m_region = -1;
    bool m_erasing = false;
    bool m_strokeErases = false;
    std::vector<int> m_faces;                     ///< of the stroke, ascending
    std::unique_ptr<FaceNeighbours> m_neighbours; ///< of the part, once one is painted
    SharedMesh m_mesh;                            ///< it; null between strokes
};

} // namespace moldwright
