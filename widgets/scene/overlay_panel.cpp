// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/overlay_panel.h"

#include "scene/fonts.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>
#include <vtkTextProperty.h>
#include <vtkTextRenderer.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace moldwright::scene {

namespace {

constexpr double bodySize = 12;
constexpr double titleSize = 13;
constexpr double lineHeight = 20;
constexpr double paddingX = 10;
constexpr double paddingY = 6;
constexpr double swatchWidth = 14;
constexpr double swatchHeight = 11;
constexpr double valueGap = 24;
constexpr double rowGap = 12;         ///< between what stands in one row
constexpr std::size_t fewClasses = 3; ///< have their words each in a row

Rgb inkColour(Ink ink, const SceneColours& colours) {
    switch (ink) {
    case Ink::Text:
        return colours.text;
    case Ink::Secondary:
        return colours.secondaryText;
    case Ink::Side1:
        return colours.side1Ink;
    case Ink::Side2:
        return colours.side2Ink;
    case Ink::Error:
        return colours.errorInk;
    }
    return colours.text;
}

void useFont(vtkTextProperty* text, const std::string& words, bool bold, double size) {
    const std::string& file = viewFontFor(words, bold);
    if (!file.empty()) {
        text->SetFontFamily(VTK_FONT_FILE);
        text->SetFontFile(file.c_str());
    } else {
        text->SetBold(bold);
    }
    text->SetFontSize(static_cast<int>(std::lround(size)));
    text->SetVerticalJustificationToBottom();
}

} // namespace

std::vector<std::pair<double, double>> roundedRectangle(double width, double height, double radius) {
    std::vector<std::pair<double, double>> outline;
    const std::array<std::array<double, 3>, 4> corners = {{{radius, radius, 1.0},
                                                           {width - radius, radius, 1.5},
                                                           {width - radius, height - radius, 0.0},
                                                           {radius, height - radius, 0.5}}};
    constexpr int steps = 5;
    for (const auto& [x, y, start] : corners)
        for (int i = 0; i <= steps; ++i) {
            const double angle = (start + 0.5 * i / steps) * std::numbers::pi;
            outline.emplace_back(x + radius * std::cos(angle), y + radius * std::sin(angle));
        }
    return outline;
}

OverlayPanel::OverlayPanel() = default;

OverlayPanel::~OverlayPanel() = default;

void OverlayPanel::addTo(vtkRenderer* renderer) {
    m_renderer = renderer;
}

void OverlayPanel::clear() {
    for (const Piece& piece : m_pieces)
        m_renderer->RemoveViewProp(piece.actor);
    m_pieces.clear();
}

void OverlayPanel::setContent(const PanelContent& content, const SceneColours& colours, double scale,
                              PanelForm form) {
    clear();
    m_height =
        form == PanelForm::Lines ? layOut(content, colours, scale) : layOutRow(content, colours, scale, form);
    addBackground(colours, scale);
    for (const Piece& piece : m_pieces)
        m_renderer->AddViewProp(piece.actor);
    setVisible(m_visible);
    moveTo(m_left, m_bottom);
}

double OverlayPanel::layOut(const PanelContent& content, const SceneColours& colours, double scale) {
    const std::size_t rows = content.lines.size() + (content.title.empty() ? 0 : 1);
    const double height = (2 * paddingY + lineHeight * static_cast<double>(rows)) * scale;
    double y = height - (paddingY + lineHeight) * scale;
    double widest = 0;
    if (!content.title.empty()) {
        widest = addText({content.title, Ink::Text, true}, colours, titleSize * scale, paddingX * scale,
                         y + 2 * scale);
        y -= lineHeight * scale;
    }
    std::vector<std::pair<std::size_t, double>> values; // piece and width of each value, to be right-aligned
    double valueWidth = 0;
    for (const PanelContent::Line& line : content.lines) {
        double x = paddingX * scale;
        if (line.swatch)
            x = addSwatch(*line.swatch, x, y, scale) + 8 * scale;
        for (const PanelContent::Run& run : line.runs)
            x = addText(run, colours, bodySize * scale, x, y + 2 * scale) + 6 * scale;
        widest = std::max(widest, x - 6 * scale);
        if (!line.value.empty()) {
            const double end =
                addText({line.value, Ink::Secondary, false}, colours, bodySize * scale, 0, y + 2 * scale);
            values.emplace_back(m_pieces.size() - 1, end);
            valueWidth = std::max(valueWidth, end);
        }
        y -= lineHeight * scale;
    }
    if (!values.empty())
        widest += valueGap * scale + valueWidth;
    for (const auto& [piece, width] : values)
        m_pieces[piece].x = std::round(widest - width);
    m_width = std::ceil(widest + paddingX * scale);
    return height;
}

double OverlayPanel::layOutRow(const PanelContent& content, const SceneColours& colours, double scale,
                               PanelForm form) {
    const double y = paddingY * scale;
    double x = paddingX * scale;
    const auto text = [&](const PanelContent::Run& run, double size) {
        x = addText(run, colours, size * scale, x, y + 2 * scale) + rowGap * scale;
    };
    if (!content.title.empty())
        text({content.title, Ink::Text, true}, titleSize);
    const auto classes =
        std::ranges::count_if(content.lines, [](const auto& line) { return line.swatch.has_value(); });
    for (const PanelContent::Line& line : content.lines) {
        const bool listed = line.swatch && static_cast<std::size_t>(classes) <= fewClasses;
        if (form == PanelForm::Title || !(listed || (!line.swatch && form == PanelForm::Row)))
            continue;
        if (line.swatch)
            x = addSwatch(*line.swatch, x, y, scale) + 6 * scale;
        for (const PanelContent::Run& run : line.runs)
            text(run, bodySize);
        if (form == PanelForm::Row && !line.value.empty())
            text({line.value, Ink::Secondary, false}, bodySize);
    }
    if (form != PanelForm::Title && static_cast<std::size_t>(classes) > fewClasses)
        x = addScale(content, colours, scale, x, form == PanelForm::Row) + rowGap * scale;
    m_width = std::ceil(x + (paddingX - rowGap) * scale);
    return rowHeight * scale;
}

double OverlayPanel::addScale(const PanelContent& content, const SceneColours& colours, double scale,
                              double x, bool withValues) {
    const double y = paddingY * scale;
    const auto text = [&](const PanelContent::Run& run) {
        x = addText(run, colours, bodySize * scale, x, y + 2 * scale) + 6 * scale;
    };
    const auto words = [&](const PanelContent::Line& line) {
        if (!line.runs.empty())
            text(line.runs.front());
        if (withValues && !line.value.empty())
            text({line.value, Ink::Secondary, false});
    };
    std::vector<const PanelContent::Line*> classes; // lists begin with the most, scales with the least
    for (const PanelContent::Line& line : content.lines)
        if (line.swatch)
            classes.insert(classes.begin(), &line);
    words(*classes.front());
    for (const PanelContent::Line* line : classes)
        x = addSwatch(*line->swatch, x, y, scale);
    x += 6 * scale;
    words(*classes.back());
    return x - 6 * scale;
}

double OverlayPanel::addSwatch(Rgb colour, double x, double y, double scale) {
    addShape(roundedRectangle(swatchWidth * scale, swatchHeight * scale, 2 * scale), colour, true, 0,
             m_pieces.size());
    m_pieces.back().x = x;
    m_pieces.back().y = std::round(y + 5 * scale);
    return x + swatchWidth * scale;
}

double OverlayPanel::addText(const PanelContent::Run& run, const SceneColours& colours, double size, double x,
                             double y) {
    // Noto Sans has no minus sign, and VTK no fallback font: the en dash is as wide and as high.
    std::string words = run.text;
    for (std::size_t at = words.find("−"); at != std::string::npos; at = words.find("−", at))
        words.replace(at, std::string("−").size(), "–");
    vtkNew<vtkTextActor> text;
    text->SetInput(words.c_str());
    text->GetPositionCoordinate()->SetCoordinateSystemToDisplay();
    useFont(text->GetTextProperty(), words, run.bold, size);
    text->GetTextProperty()->SetColor(inkColour(run.ink, colours).unit().data());
    std::array<int, 4> box = {};
    vtkTextRenderer::GetInstance()->GetBoundingBox(text->GetTextProperty(), words, box.data(), 72);
    m_pieces.push_back({text.Get(), std::round(x), std::round(y)});
    return x + box[1] - box[0];
}

void OverlayPanel::addShape(std::vector<std::pair<double, double>> outline, Rgb colour, bool filled,
                            double lineWidth, std::size_t place) {
    vtkNew<vtkPoints> points;
    std::vector<vtkIdType> cell;
    for (const auto& [x, y] : outline)
        cell.push_back(points->InsertNextPoint(x, y, 0));
    if (!filled)
        cell.push_back(0);
    vtkNew<vtkCellArray> cells;
    cells->InsertNextCell(static_cast<vtkIdType>(cell.size()), cell.data());
    vtkNew<vtkPolyData> shape;
    shape->SetPoints(points);
    filled ? shape->SetPolys(cells) : shape->SetLines(cells);
    vtkNew<vtkPolyDataMapper2D> mapper;
    mapper->SetInputData(shape);
    vtkNew<vtkActor2D> actor;
    actor->SetMapper(mapper);
    actor->GetProperty()->SetColor(colour.unit().data());
    actor->GetProperty()->SetLineWidth(static_cast<float>(lineWidth));
    actor->GetPositionCoordinate()->SetCoordinateSystemToDisplay();
    m_pieces.insert(m_pieces.begin() + static_cast<std::ptrdiff_t>(place), {actor.Get(), 0, 0});
}

void OverlayPanel::addBackground(const SceneColours& colours, double scale) {
    const auto outline = roundedRectangle(m_width, m_height, 4 * scale);
    addShape(outline, colours.chip, true, 0, 0);
    addShape(outline, colours.chipEdge, false, scale, 1);
}

std::string OverlayPanel::words() const {
    std::string all;
    for (const Piece& piece : m_pieces)
        if (auto* text = vtkTextActor::SafeDownCast(piece.actor))
            all += (all.empty() ? "" : " ") + std::string(text->GetInput());
    return all;
}

void OverlayPanel::moveTo(double left, double bottom) {
    m_left = left;
    m_bottom = bottom;
    for (const Piece& piece : m_pieces)
        piece.actor->SetPosition(std::round(left + piece.x), std::round(bottom + piece.y));
}

void OverlayPanel::setVisible(bool visible) {
    m_visible = visible;
    for (const Piece& piece : m_pieces)
        piece.actor->SetVisibility(visible);
}

} // namespace moldwright::scene
