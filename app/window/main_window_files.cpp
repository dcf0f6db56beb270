// SPDX-License-Identifier: AGPL-3.0-or-later
// Files that come in and go out, and what happens to the document when it is left.
#include "window/main_window.h"

#include "view/part_view.h"
#include "window/import_dialog.h"
#include "window/preferences.h"
#include "window/turntable.h"
#include "window/view_area.h"
#include "window/workbench.h"

#include <QBuffer>
#include <QCloseEvent>
#include <QFileDialog>
#include <QFileInfo>
#include <QLabel>
#include <QMessageBox>
#include <QMimeData>
#include <QPointer>
#include <QPushButton>
#include <QSaveFile>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

enum class Leave { Save, Discard, Stay };

Leave askToLeave(const QString& name, QWidget* parent) {
    QMessageBox box(parent);
    box.setWindowTitle(MainWindow::tr("Moldwright"));
    box.setText(MainWindow::tr("%1 has changes that are not saved.").arg(name));
    QPushButton* save = box.addButton(MainWindow::tr("Save"), QMessageBox::AcceptRole);
    QPushButton* discard =
        box.addButton(MainWindow::tr("Close without saving"), QMessageBox::DestructiveRole);
    QPushButton* stay = box.addButton(MainWindow::tr("Keep it open"), QMessageBox::RejectRole);
    save->setObjectName(u"leave-save"_s);
    discard->setObjectName(u"leave-discard"_s);
    stay->setObjectName(u"leave-stay"_s);
    box.setDefaultButton(save);
    box.setEscapeButton(stay);
    box.exec();
    return box.clickedButton() == save      ? Leave::Save
           : box.clickedButton() == discard ? Leave::Discard
                                            : Leave::Stay;
}

} // namespace

void MainWindow::openPath(const QString& file) {
    leaving([this, file] { m_bench.openFile(file); });
}

void MainWindow::dragEnterEvent(QDragEnterEvent* event) {
    if (event->mimeData()->hasUrls() && event->mimeData()->urls().front().isLocalFile())
        event->acceptProposedAction();
}

void MainWindow::dropEvent(QDropEvent* event) {
    openPath(event->mimeData()->urls().front().toLocalFile());
}

void MainWindow::closeEvent(QCloseEvent* event) {
    if (!m_mayClose) {
        event->ignore();
        leaving([this] {
            m_mayClose = true;
            close();
        });
        return;
    }
    keepLayout();
    event->accept();
}

void MainWindow::keepLayout() const {
    preferences::setLayout(u"geometry"_s, saveGeometry());
    preferences::setLayout(u"views"_s, m_views->saved());
    if (m_bench.project().part)
        preferences::setLayout(u"docks"_s, saveState(layoutVersion));
}

void MainWindow::leaving(const std::function<void()>& then) {
    if (!m_bench.project().part || !m_bench.document().isChanged()) {
        then();
        return;
    }
    switch (askToLeave(QString::fromStdString(m_bench.project().name), this)) {
    case Leave::Save:
        whenIdle([this, then] { save(then); });
        break;
    case Leave::Discard:
        whenIdle(then);
        break;
    case Leave::Stay:
        break;
    }
}

void MainWindow::whenIdle(const std::function<void()>& then) {
    if (!m_bench.background().busy()) {
        then();
        return;
    }
    connect(&m_bench.background(), &Background::finished, this, then,
            Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection));
    m_bench.stop();
}

void MainWindow::save(const std::function<void()>& then) {
    const QString file = m_bench.document().file();
    if (file.isEmpty())
        saveAs(then);
    else
        saveTo(file, then);
}

void MainWindow::saveAs(const std::function<void()>& then) {
    QString file =
        fileToWrite(tr("Save the project"), u".moldwright"_s, tr("Moldwright projects (*.moldwright)"));
    if (file.isEmpty())
        return;
    if (QFileInfo(file).suffix() != u"moldwright"_s)
        file += u".moldwright"_s;
    saveTo(file, then);
}

void MainWindow::saveTo(const QString& file, const std::function<void()>& then) {
    // The file may be written after this window has made way for one in another language.
    m_bench.save(file, thumbnail(), [window = QPointer(this), then] {
        if (window && then)
            then();
    });
}

QByteArray MainWindow::thumbnail() {
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    m_view->picture().scaled(256, 192, Qt::KeepAspectRatio, Qt::SmoothTransformation).save(&buffer, "PNG");
    return png;
}

QString MainWindow::fileToWrite(const QString& title, const QString& ending, const QString& kinds) {
    const QString name = QString::fromStdString(m_bench.project().name) + ending;
    const QString file =
        QFileDialog::getSaveFileName(this, title, preferences::folder() + u'/' + name, kinds);
    if (!file.isEmpty())
        preferences::setFolderOf(file);
    return file;
}

void MainWindow::chooseFileToOpen() {
    const QString file = QFileDialog::getOpenFileName(
        this, tr("Open a part"), preferences::folder(),
        tr("Parts and projects (*.stl *.obj *.ply *.off *.moldwright);;All files (*)"));
    if (file.isEmpty())
        return;
    preferences::setFolderOf(file);
    openPath(file);
}

void MainWindow::chooseFileToExport() {
    const QString file = fileToWrite(tr("Export the shape"), u".stl"_s,
                                     tr("STL (*.stl);;PLY (*.ply);;OBJ (*.obj);;OFF (*.off)"));
    if (!file.isEmpty())
        m_bench.exportShape(file);
}

void MainWindow::chooseFolderForMold() {
    const QString folder =
        QFileDialog::getExistingDirectory(this, tr("Folder for the halves"), preferences::folder());
    if (!folder.isEmpty())
        m_bench.exportMold(folder);
}

void MainWindow::chooseFileForReport() {
    const QString file = fileToWrite(tr("Print the report"), u".pdf"_s, tr("PDF (*.pdf)"));
    if (!file.isEmpty())
        m_bench.writeReport(file);
}

void MainWindow::choosePinsToImport() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Pins from a file"), preferences::folder(),
                                                      tr("Pins (*.json);;All files (*)"));
    if (file.isEmpty())
        return;
    preferences::setFolderOf(file);
    m_bench.importPins(file);
}

void MainWindow::choosePinsToExport() {
    const QString file = fileToWrite(tr("Pins into a file"), u"-pins.json"_s, tr("Pins (*.json)"));
    if (!file.isEmpty())
        m_bench.exportPins(file);
}

void MainWindow::chooseWeightsToImport() {
    const QString file = QFileDialog::getOpenFileName(this, tr("Regions from a file"), preferences::folder(),
                                                      tr("Regions (*.json);;All files (*)"));
    if (file.isEmpty())
        return;
    preferences::setFolderOf(file);
    m_bench.importWeights(file);
}

void MainWindow::chooseWeightsToExport() {
    const QString file = fileToWrite(tr("Regions into a file"), u"-regions.json"_s, tr("Regions (*.json)"));
    if (!file.isEmpty())
        m_bench.exportWeights(file);
}

void MainWindow::saveScreenshot() {
    const QString file = fileToWrite(tr("Save a picture"), u".png"_s, tr("PNG pictures (*.png)"));
    if (!file.isEmpty() && !m_view->picture().save(file))
        m_bench.say(Standing::Failing, tr("The picture could not be written to %1.").arg(file));
}

void MainWindow::saveTurntable() {
    const QString file = fileToWrite(tr("Save a turntable"), u".png"_s, tr("Animated PNG (*.png)"));
    if (file.isEmpty())
        return;
    auto* turntable = new Turntable(*m_view, this);
    m_turntable = turntable;
    connect(turntable, &Turntable::progressed, this, [this](int taken) {
        m_hint->setText(
            tr("Picture %1 of %2 around the part. <b>Esc</b> stops.").arg(taken).arg(Turntable::pictures));
    });
    connect(turntable, &Turntable::finished, this, [this, file](const AnimatedPng& animation) {
        QSaveFile out(file);
        const bool written =
            out.open(QIODevice::WriteOnly) && out.write(animation.bytes()) >= 0 && out.commit();
        m_bench.say(written ? Standing::Done : Standing::Failing,
                    written ? tr("Turntable written to %1.").arg(file)
                            : tr("The picture could not be written to %1.").arg(file));
    });
    connect(turntable, &Turntable::ended, this, [this, turntable] {
        turntable->deleteLater();
        m_turntable = nullptr;
        refreshSoon();
    });
    turntable->start();
}

void MainWindow::askUnit(const OpenedMesh& opened) {
    auto* dialog = new ImportDialog(opened, this);
    dialog->setAttribute(Qt::WA_DeleteOnClose);
    connect(dialog, &QDialog::accepted, this,
            [this, dialog, opened] { m_bench.take(opened, dialog->unit(), dialog->scale()); });
    dialog->open();
}

} // namespace moldwright
