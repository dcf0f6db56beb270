// SPDX-License-Identifier: AGPL-3.0-or-later
// The project's tree: what its rows do, and their menus.
#include "window/main_window.h"

#include "panels/project_tree.h"
#include "window/importance_pages.h"
#include "window/pin_pages.h"
#include "window/row_commands.h"
#include "window/variant_pages.h"
#include "window/workbench.h"

#include <QMenu>

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
    else
        bench.rename(name);
}

} // namespace

void MainWindow::connectTree() {
    const auto toggleRow = [this](const QString& id) {
        toggle(m_visible, id);
        refreshSoon();
    };
    connect(m_tree, &ProjectTree::chosen, this, &MainWindow::select);
    connect(m_tree, &ProjectTree::visibilityToggled, this, toggleRow);
    connect(m_projectModel, &ProjectModel::renamed, this,
            [this](const QString& id, const QString& name) { rename(m_bench, id, name); });
    connect(m_tree, &ProjectTree::menuRequested, this, &MainWindow::showRowMenu);
    m_actions.on(u"rename"_s, [this] { m_tree->rename(rowMeant()); });
    m_actions.on(u"hide"_s, [this, toggleRow] { toggleRow(m_selected); });
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
    select(id);
    refreshActions(); // for this row
    QMenu menu;
    for (const QString& command : commands)
        command.isEmpty() ? (void)menu.addSeparator() : menu.addAction(m_actions[command]);
    menu.exec(place);
}

} // namespace moldwright
