// SPDX-License-Identifier: AGPL-3.0-or-later
// What is chosen, in the project's tree and in the views; what the tree's rows do, and their menus.
#include "window/main_window.h"

#include "panels/project_tree.h"
#include "view/part_view.h"
#include "window/importance_pages.h"
#include "window/importance_paint.h"
#include "window/mold_feature_pages.h"
#include "window/mold_placing.h"
#include "window/pin_pages.h"
#include "window/row_commands.h"
#include "window/selection.h"
#include "window/tray_pages.h"
#include "window/variant_pages.h"
#include "window/view_pane.h"
#include "window/workbench.h"

#include <QMenu>

#include <algorithm>
#include <functional>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

/// Renames what a row of the tree stands for.
void rename(Workbench& bench, const QString& id, const QString& name) {
    if (const int region = regionNumber(id); region >= 0)
        bench.renameRegion(region, name);
    else if (const int variant = variantNumber(id); variant >= 0)
        bench.renameVariant(variant, name);
    else if (const int pin = pinNumber(id); pin >= 0)
        bench.renamePin(pin, name);
    else if (const int part = trayNumber(id); part > 0)
        bench.renamePartOfMold(part - 1, name);
    else
        bench.rename(name);
}

} // namespace

void MainWindow::connectTree() {
    const auto toggleRows = [this](const QString& ids) {
        toggle(m_visible, chosenIds(ids));
        refreshSoon();
    };
    connect(m_tree, &ProjectTree::chosen, this, [this](const QStringList& ids) {
        if (!ids.isEmpty())
            select(chosenTogether(ids));
        m_tree->select(chosenIds(m_selected)); // which may be fewer
    });
    connect(m_tree, &ProjectTree::visibilityToggled, this, [this, toggleRows](const QString& id) {
        toggleRows(chosenIds(m_selected).contains(id) ? m_selected : id);
    });
    connect(m_projectModel, &ProjectModel::renamed, this,
            [this](const QString& id, const QString& name) { rename(m_bench, id, name); });
    connect(m_tree, &ProjectTree::menuRequested, this, &MainWindow::showRowMenu);
    m_actions.on(u"rename"_s, [this] { m_tree->rename(rowMeant()); });
    m_actions.on(u"hide"_s, [this, toggleRows] { toggleRows(m_selected); });
}

QString MainWindow::rowMeant() const {
    return m_selected == allVariantsId() ? variantId(variantMeant(m_selected, m_bench)) : m_selected;
}

const ProjectRow* MainWindow::rowOf(const QString& id) const {
    const QModelIndex index = m_projectModel->indexOf(id);
    return index.isValid() ? &m_projectModel->row(index) : nullptr;
}

void MainWindow::showRowMenu(const QString& id, const QPoint& place) {
    const QStringList commands = commandsOfRow(id);
    if (commands.isEmpty())
        return;
    if (!chosenIds(m_selected).contains(id))
        select(id);
    refreshActions(); // for this row
    QMenu menu;
    for (const QString& command : commands)
        command.isEmpty() ? (void)menu.addSeparator() : menu.addAction(m_actions[command]);
    menu.exec(place);
}

void MainWindow::choose(const QStringList& ids, Qt::KeyboardModifiers keys) {
    select(chosenWith(m_selected, ids, choosingBy(keys)));
}

void MainWindow::removeChosen() {
    if (const int variant = variantNumber(m_selected); variant >= 0)
        return m_bench.removeVariant(variant);
    if (const int part = trayNumber(m_selected); part > 0)
        return m_bench.removePartOfMold(part - 1);
    const std::vector<int> regions = regionNumbers(m_selected);
    if (regions.empty())
        m_bench.removePins(pinNumbers(m_selected));
    else
        m_bench.removeRegions(regions);
    QStringList gone = chosenIds(m_selected);
    // From the last to the first: each moves those after it up.
    std::ranges::sort(gone, std::greater(), [](const QString& id) { return id.section(u'-', -1).toInt(); });
    for (const QString& id : gone)
        forgetRow(m_visible, id);
    select(regions.empty() ? u"pins"_s : allRegionsId());
}

/// Regions can be taken hold of where they are seen.
bool MainWindow::regionsShown(const ViewPane& pane) const {
    return regionsChosen(m_selected) || pane.settings().mode == DisplayMode::Importance;
}

void MainWindow::serveChoosing(ViewPane& pane) {
    PartView* view = &pane.view();
    connect(view, &PartView::surfaceClicked, this,
            [this, &pane](const scene::SurfacePicker::Hit& hit, Qt::KeyboardModifiers keys) {
                const ShownSurface surface = m_bench.surface(pane.settings().content);
                if (!regionsShown(pane) || !surface.picker || surface.picker->mesh() != surface.drawn->mesh)
                    return;
                if (const int region = regionAt(m_bench, surface, m_visible, hit.face); region >= 0)
                    choose({regionId(region)}, keys);
            });
    connect(view, &PartView::boxDrawn, this,
            [this, &pane, view](const scene::Lasso& box, Qt::KeyboardModifiers keys) {
                const auto inBox = [&](const Eigen::Vector3d& place) {
                    return scene::isInside(box.line, box.camera.project(place, box.view).head<2>());
                };
                QStringList ids;
                for (const scene::ShownPin& pin : view->scene().pins().pins().pins)
                    if (inBox(pin.place))
                        ids << pinId(pin.number);
                const std::vector<PlacedRow>& rows = m_bench.placing().rows();
                const std::vector<scene::ShownFeature>& features = view->scene().features().plan().features;
                for (std::size_t i = 0; i < std::min(rows.size(), features.size()); ++i)
                    if (std::ranges::any_of(features[i].places, inBox))
                        ids << featureId(rows[i].stands.kind, rows[i].stands.number);
                if (regionsShown(pane))
                    for (const auto& [region, place] :
                         regionPlaces(m_bench, m_bench.surface(pane.settings().content), m_visible))
                        if (inBox(place))
                            ids << regionId(region);
                choose(ids, keys);
            });
}

} // namespace moldwright
