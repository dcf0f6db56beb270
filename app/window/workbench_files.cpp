// SPDX-License-Identifier: AGPL-3.0-or-later
// Opening, closing and exporting.
#include "window/workbench.h"

#include "exchange/repair_mesh.h"
#include "mold/mold_files.h"
#include "project/edits.h"
#include "project/project_file.h"
#include "window/preferences.h"
#include "window/refused_mesh.h"
#include "window/sentence.h"

#include <QDir>
#include <QFileInfo>

namespace moldwright {

namespace {

/// An empty project with what the user wants new parts to begin with.
Project freshProject() {
    const preferences::Defaults defaults = preferences::defaults();
    Project fresh;
    fresh.design.draftDegrees = defaults.draftDegrees;
    fresh.design.limits.maxTiltDegrees = defaults.maxTiltDegrees;
    fresh.mold.wall = fresh.mold.floor = fresh.mold.ceiling = defaults.wall;
    return fresh;
}

/// A plane to begin with: level, through the part's middle.
MoldState levelPlane(const Eigen::Vector3d& middle) {
    PartingPlane plane;
    plane.offset = plane.normal.dot(middle);
    return {plane, Directions::normalTo(plane)};
}

} // namespace

void Workbench::openFile(const QString& file) {
    if (m_background.busy())
        return;
    if (QFileInfo(file).suffix().toLower() == QStringLiteral("moldwright"))
        readProject(file);
    else
        readFile(file, QFileInfo(file).completeBaseName(), false);
}

void Workbench::openSample(const QString& file, const QString& name) {
    if (!m_background.busy())
        readFile(file, name, true);
}

void Workbench::readProject(const QString& file) {
    m_background.start(
        tr("Opening %1").arg(QFileInfo(file).fileName()), [=, this](const Task&) -> Background::Finish {
            auto stored = std::make_shared<Result<StoredProject>>(openProject(file.toStdString()));
            return [=, this] {
                if (!*stored) {
                    complain(stored->error(), tr("Opening"));
                    return;
                }
                show((*stored)->project, file);
                preferences::addRecentFile(file);
                say(Standing::Done, tr("%1 opened.").arg(QFileInfo(file).fileName()));
            };
        });
}

void Workbench::forgetOldPart() {
    m_refused.reset();
    m_offered.clear();
    m_offeredPart.reset();
    m_progress.clear();
    m_molds.clear();
    m_variants.compareWith({});
}

void Workbench::show(const Project& project, const QString& file) {
    forgetOldPart();
    m_document.open(project, file);
    Q_EMIT partOpened();
}

void Workbench::save(const QString& file, const QByteArray& thumbnail, const std::function<void()>& then) {
    const Project project = m_document.committed();
    const std::size_t done = m_document.history().done();
    m_background.start(tr("Saving %1").arg(QFileInfo(file).fileName()),
                       [=, this](const Task&) -> Background::Finish {
                           const Result<void> written =
                               saveProject(file.toStdString(), {project, {}, thumbnail.toStdString()});
                           return [=, this] {
                               if (!written) {
                                   complain(written.error(), tr("Saving"));
                                   return;
                               }
                               m_document.markSaved(file, done);
                               preferences::addRecentFile(file);
                               Q_EMIT saved();
                               if (then)
                                   then();
                           };
                       });
}

void Workbench::readFile(const QString& file, const QString& name, bool sample) {
    m_background.start(
        tr("Opening %1").arg(QFileInfo(file).fileName()), [=, this](const Task& task) -> Background::Finish {
            const Result<ReadMesh> read = readMesh(file.toStdString(), task);
            if (!read)
                return [=, this] { complain(read.error(), tr("Opening")); };
            Examination part = examine(read->mesh, QFileInfo(file).fileName().toStdString());
            if (!part.faults.empty()) {
                const Error fault = part.faults.front();
                const auto refused = refusedMesh(file, std::move(part));
                return [=, this] { refused ? refuse(refused) : complain(fault, tr("Opening")); };
            }
            const OpenedMesh opened{name,
                                    sample ? QString() : file,
                                    {std::move(part.mesh), std::move(part.repairs), std::move(part.notes)}};
            return [=, this] {
                if (sample)
                    take(opened, Unit::Millimetre, 1);
                else
                    Q_EMIT unitAsked(opened);
            };
        });
}

void Workbench::refuse(const std::shared_ptr<const RefusedMesh>& refused) {
    m_refused = refused;
    // Its places are not the document's: there is nothing to show once it is left.
    for (const Error& fault : refused->part.faults)
        say(Standing::Failing, sentence(fault.message));
    Q_EMIT refusalChanged();
    Q_EMIT changed();
}

void Workbench::leaveRefused() {
    m_refused.reset();
    Q_EMIT refusalChanged();
    Q_EMIT changed();
}

void Workbench::repairRefused() {
    const std::shared_ptr<const RefusedMesh> refused = m_refused;
    m_background.start(tr("Repairing %1").arg(refused->name),
                       [=, this](const Task& task) -> Background::Finish {
                           Result<RepairedMesh> repaired =
                               repairMesh(*refused->drawn->mesh, refused->name.toStdString(), task);
                           if (!repaired)
                               return [=, this] { complain(repaired.error(), tr("Repairing")); };
                           std::vector<Message> repairs = refused->part.repairs;
                           repairs.insert(repairs.end(), repaired->repairs.begin(), repaired->repairs.end());
                           const OpenedMesh opened{QFileInfo(refused->file).completeBaseName(),
                                                   refused->file,
                                                   {std::move(repaired->mesh), std::move(repairs), {}}};
                           return [=, this] { Q_EMIT unitAsked(opened); };
                       });
}

void Workbench::take(const OpenedMesh& opened, Unit unit, double scale) {
    const auto source = std::make_shared<const IndexedMesh>(opened.prepared.mesh);
    const Project from = project().part ? m_document.committed() : freshProject();
    Project project = withPart(from, opened.name.toStdString(), opened.file.toStdString(), source,
                               {unit, scale, Eigen::Isometry3d::Identity()});
    project = withState(project, levelPlane(figures(project.part).box.center()), false);
    show(project, {});
    if (!opened.file.isEmpty())
        preferences::addRecentFile(opened.file);
    const Eigen::Vector3d size = figures(project.part).box.sizes();
    say(Standing::Done, tr("%1 opened: %2 × %3 × %4 mm, closed.")
                            .arg(opened.name)
                            .arg(size.x(), 0, 'f', 1)
                            .arg(size.y(), 0, 'f', 1)
                            .arg(size.z(), 0, 'f', 1));
    for (const std::vector<Message>& told : {opened.prepared.repairs, opened.prepared.notes})
        for (const Message& what : told)
            say(Standing::Info, sentence(what));
}

void Workbench::openLost(const Project& project) {
    forgetOldPart();
    m_document.openUnsaved(project);
    Q_EMIT partOpened();
}

void Workbench::closePart() {
    m_variants.compareWith({});
    m_document.open(Project{}, {});
    m_answer.reset();
    m_molds.clear();
    m_progress.clear();
    m_messages.clear();
    Q_EMIT changed();
}

void Workbench::exportShape(const QString& file) {
    const std::optional<MeshFormat> format = formatFor(file.toStdString());
    if (!format) {
        Q_EMIT problem(tr("The shape was not written: the file's name must end in stl, ply, obj or off."),
                       file);
        return;
    }
    const SharedMesh mesh = shownMesh();
    m_background.start(
        tr("Writing %1").arg(QFileInfo(file).fileName()), [=, this](const Task&) -> Background::Finish {
            const Result<void> written = writeMesh(file.toStdString(), *mesh, *format);
            return [=, this] {
                if (!written)
                    complain(written.error(), tr("Export"));
                else
                    say(Standing::Done, tr("Shape written to %1.").arg(QDir::toNativeSeparators(file)));
            };
        });
}

void Workbench::exportMold(const QString& folder) {
    const auto mold = built().mold;
    const std::string name = namesOf(built().tray);
    m_background.start(tr("Writing the halves"), [=, this](const Task& task) -> Background::Finish {
        const Result<void> written = writeMold(*mold, name, folder.toStdString(), {}, task);
        return [=, this] {
            if (!written)
                complain(written.error(), tr("Export"));
            else
                say(Standing::Done, tr("Mold halves written to %1.").arg(QDir::toNativeSeparators(folder)));
        };
    });
}

} // namespace moldwright
