// SPDX-License-Identifier: AGPL-3.0-or-later
#include "scene/feature_layer.h"

#include <vtkCellArray.h>
#include <vtkCoordinate.h>
#include <vtkPoints.h>
#include <vtkProperty2D.h>
#include <vtkRenderer.h>

namespace moldwright::scene {

namespace {

constexpr std::array<double, 4> lineWidths = {1.2, 1.6, 2.4, 2.4};

void addOutline(const Outline& outline, vtkPoints* points, vtkCellArray* lines) {
    if (outline.size() < 2)
        return;
    lines->InsertNextCell(static_cast<int>(outline.size()) + 1);
    const vtkIdType first = points->GetNumberOfPoints();
    for (const Eigen::Vector3d& p : outline)
        lines->InsertCellPoint(points->InsertNextPoint(p.data()));
    lines->InsertCellPoint(first);
}

} // namespace

FeatureLayer::FeatureLayer() {
    const vtkNew<vtkCoordinate> inTheScene;
    inTheScene->SetCoordinateSystemToWorld();
    for (Strokes& strokes : m_strokes) {
        strokes.mapper->SetInputData(strokes.lines);
        strokes.mapper->SetTransformCoordinate(inTheScene);
        strokes.actor->SetMapper(strokes.mapper);
    }
}

void FeatureLayer::addTo(vtkRenderer* renderer) {
    m_renderer = renderer;
    for (const Strokes& strokes : m_strokes)
        renderer->AddViewProp(strokes.actor);
}

FeatureLayer::Look FeatureLayer::lookOf(const ShownFeature& feature) {
    return feature.failing ? Failing : feature.chosen ? Chosen : Found;
}

Rgb FeatureLayer::colourOf(Look look) const {
    switch (look) {
    case Failing:
        return m_colours.undercut;
    case Chosen:
        return m_colours.accent;
    case Found:
        return m_colours.text;
    default:
        return m_colours.plane;
    }
}

void FeatureLayer::setLook(const SceneColours& colours, double scale) {
    m_colours = colours;
    m_scale = scale;
    for (int look = 0; look < LookCount; ++look) {
        vtkProperty2D* property = m_strokes.at(static_cast<std::size_t>(look)).actor->GetProperty();
        property->SetColor(colourOf(static_cast<Look>(look)).unit().data());
        property->SetLineWidth(static_cast<float>(lineWidths.at(static_cast<std::size_t>(look)) * scale));
    }
    show();
}

void FeatureLayer::set(const ShownPlan& plan) {
    if (plan == m_plan)
        return;
    m_plan = plan;
    show();
    layLines();
}

void FeatureLayer::show() {
    std::size_t disc = 0;
    for (const ShownFeature& feature : m_plan.features)
        for (std::size_t copy = 0; copy < feature.places.size(); ++copy) {
            if (disc == m_discs.size())
                m_discs.push_back(std::make_unique<GripDisc>(m_renderer));
            const Rgb colour = colourOf(lookOf(feature));
            const double radius = feature.chosen ? 7 : 5.5;
            m_discs[disc++]->show(true,
                                  {radius * m_scale, 2 * m_scale, feature.byHand ? colour : m_colours.chip,
                                   feature.byHand ? m_colours.chip : colour});
        }
    for (; disc < m_discs.size(); ++disc)
        m_discs[disc]->show(false, {});
}

void FeatureLayer::layLines() {
    std::array<vtkNew<vtkPoints>, LookCount> points;
    std::array<vtkNew<vtkCellArray>, LookCount> lines;
    for (vtkPoints* places : points)
        places->SetDataTypeToDouble();
    for (const Outline& outline : m_plan.lines)
        addOutline(outline, points[Quiet], lines[Quiet]);
    for (const ShownFeature& feature : m_plan.features)
        for (const Outline& outline : feature.outlines)
            addOutline(outline, points.at(lookOf(feature)), lines.at(lookOf(feature)));
    for (std::size_t look = 0; look < LookCount; ++look) {
        m_strokes.at(look).lines->Initialize();
        m_strokes.at(look).lines->SetPoints(points.at(look));
        m_strokes.at(look).lines->SetLines(lines.at(look));
    }
}

std::optional<FeatureAt> FeatureLayer::at(const Camera& camera, ViewSize view, double x, double y,
                                          double reach) const {
    std::optional<FeatureAt> nearest;
    for (std::size_t i = 0; i < m_plan.features.size(); ++i)
        for (std::size_t copy = 0; copy < m_plan.features[i].places.size(); ++copy) {
            const Eigen::Vector3d pixel = camera.project(m_plan.features[i].places[copy], view);
            const double away = (pixel.head<2>() - Eigen::Vector2d(x, y)).norm();
            if (away > reach)
                continue;
            reach = away;
            nearest = FeatureAt{static_cast<int>(i), static_cast<int>(copy)};
        }
    return nearest;
}

void FeatureLayer::arrange(const Camera& camera, ViewSize view) {
    std::size_t disc = 0;
    for (const ShownFeature& feature : m_plan.features)
        for (const Eigen::Vector3d& place : feature.places) {
            const Eigen::Vector3d pixel = camera.project(place, view);
            m_discs[disc++]->moveTo(pixel.x(), view.height - pixel.y());
        }
}

} // namespace moldwright::scene
