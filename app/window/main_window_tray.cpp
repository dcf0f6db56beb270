// SPDX-License-Identifier: AGPL-3.0-or-later
// Different parts in one mold: which files they come from.
#include "window/main_window.h"

#include "window/preferences.h"
#include "window/tray_pages.h"
#include "window/workbench.h"

#include <QFileDialog>

namespace moldwright {

using namespace Qt::StringLiterals;

void MainWindow::connectTrayActions() {
    m_actions.on(u"add-part"_s, [this] { choosePartsForMold(); });
    m_actions.on(u"read-part-again"_s, [this] { m_bench.readPartAgain(trayNumber(m_selected) - 1); });
    connect(&m_bench, &Workbench::partOfMoldAdded, this, [this](int part) { select(trayId(part + 1)); });
}

void MainWindow::choosePartsForMold() {
    const QStringList files =
        QFileDialog::getOpenFileNames(this, tr("Add parts to the mold"), preferences::folder(),
                                      tr("Moldwright projects (*.moldwright);;All files (*)"));
    if (files.isEmpty())
        return;
    preferences::setFolderOf(files.front());
    m_bench.addPartsToMold(files);
}

} // namespace moldwright
