// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/colours.h"

#include <vtkActor2D.h>
#include <vtkNew.h>
#include <vtkSmartPointer.h>
#include <vtkTextActor.h>

#include <optional>
#include <string>
#include <vector>

class vtkRenderer;

namespace moldwright::scene {

/// The ink of a piece of text in the view.
enum class Ink { Text, Secondary, Side1, Side2, Error };

/// What stands on a chip or legend in the view. Text is UTF-8, already translated.
struct PanelContent {
    struct Run {
        std::string text;
        Ink ink = Ink::Text;
        bool bold = false;
        bool operator==(const Run&) const = default;
    };
    struct Line {
        std::optional<Rgb> swatch;
        std::vector<Run> runs;
        std::string value; ///< right-aligned, secondary
        bool operator==(const Line&) const = default;
    };
    std::string title; ///< bold, on its own line; empty: none
    std::vector<Line> lines;

    bool operator==(const PanelContent&) const = default;
};

/// How a panel lays its content out: line below line; all in one row, with the swatches as a scale between
/// the words and figures of its ends; the same without figures and notes; the title alone.
enum class PanelForm { Lines, Row, ShortRow, Title };

/// A panel-coloured rounded rectangle with text, drawn flat in the view so that pictures hold it too. Sizes
/// in device pixels; positions count from the lower left corner of the view, as VTK does.
class OverlayPanel {
public:
    OverlayPanel();
    ~OverlayPanel();
    OverlayPanel(const OverlayPanel&) = delete;
    OverlayPanel& operator=(const OverlayPanel&) = delete;

    void addTo(vtkRenderer* renderer);

    static constexpr double rowHeight = 32; ///< of a panel with one line, logical pixels

    /// Lays the content out for a screen `scale` times as fine as 96 dpi.
    void setContent(const PanelContent& content, const SceneColours& colours, double scale,
                    PanelForm form = PanelForm::Lines);
    void moveTo(double left, double bottom);
    void setVisible(bool visible);
    [[nodiscard]] bool visible() const { return m_visible; }

    /// All its words as they are laid out, from the first to the last.
    [[nodiscard]] std::string words() const;
    [[nodiscard]] double width() const { return m_width; }
    [[nodiscard]] double height() const { return m_height; }

private:
    struct Piece {
        vtkSmartPointer<vtkActor2D> actor;
        double x = 0;
        double y = 0;
    };

    double addText(const PanelContent::Run& run, const SceneColours& colours, double size, double x,
                   double y);
    double layOut(const PanelContent& content, const SceneColours& colours, double scale);
    double layOutRow(const PanelContent& content, const SceneColours& colours, double scale, PanelForm form);
    double addScale(const PanelContent& content, const SceneColours& colours, double scale, double x,
                    bool withValues);
    double addSwatch(Rgb colour, double x, double y, double scale);
    void addShape(std::vector<std::pair<double, double>> outline, Rgb colour, bool filled, double lineWidth,
                  std::size_t place);
    void addBackground(const SceneColours& colours, double scale);
    void clear();

    vtkRenderer* m_renderer = nullptr;
    std::vector<Piece> m_pieces;
    double m_width = 0;
    double m_height = 0;
    double m_left = 0;
    double m_bottom = 0;
    bool m_visible = true;
};

/// Outline of a rectangle with rounded corners, anticlockwise from its lower left.
[[nodiscard]] std::vector<std::pair<double, double>> roundedRectangle(double width, double height,
                                                                      double radius);

} // namespace moldwright::scene
