// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/lost_work.h"

#include "mesh/measures.h"
#include "scene/camera.h"
#include "scene/small_picture.h"

#include <QBuffer>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr int pictureWidth = 192; ///< twice as fine as it is shown, for fine screens
constexpr int pictureHeight = 144;
constexpr int mostFailures = 2;
const Eigen::Vector3d lookedFrom(0.75, -1, 0.6);

std::string pictureOf(const Project& project, const scene::SceneColours& colours) {
    if (!project.part || !project.state)
        return {};
    const IndexedMesh& shape = project.cast ? *project.cast->mesh : *project.part;
    const scene::Camera camera = scene::fitted(scene::lookingFrom({}, lookedFrom), boundingBox(shape),
                                               {double{pictureWidth}, double{pictureHeight}});
    const scene::SmallPicture drawn =
        scene::smallPicture(shape, {}, scene::planeRectangle(project.state->plane, shape.V), colours, camera,
                            pictureWidth, pictureHeight);
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    QImage(drawn.rgba.data(), drawn.width, drawn.height, 4 * drawn.width, QImage::Format_RGBA8888)
        .save(&buffer, "PNG");
    return png.toStdString();
}

/// Of a copy that was read whole.
LostWork workIn(const StoredProject& stored) {
    const QJsonObject origin = QJsonDocument::fromJson(QByteArray::fromStdString(stored.viewState)).object();
    LostWork work;
    work.project = std::make_shared<const Project>(stored.project);
    work.name = QString::fromStdString(stored.project.name);
    work.file = origin.value("file"_L1).toString();
    work.when = QDateTime::fromString(origin.value("when"_L1).toString(), Qt::ISODate).toLocalTime();
    work.picture.loadFromData(QByteArray::fromStdString(stored.thumbnail));
    return work;
}

} // namespace

StoredProject copyOf(const Project& project, const QString& file, const scene::SceneColours& colours) {
    const QJsonObject origin{{u"file"_s, file},
                             {u"when"_s, QDateTime::currentDateTimeUtc().toString(Qt::ISODate)}};
    return {project, QJsonDocument(origin).toJson().toStdString(), pictureOf(project, colours)};
}

LostWork readLostWork(const std::shared_ptr<RecoveryFolder>& folder) {
    LostWork work;
    const std::vector<QString> copies = folder->copies();
    if (const int failures = folder->failures(); failures < mostFailures) {
        folder->setFailures(failures + 1); // should reading end this program
        for (const QString& copy : copies) {
            if (const Result<StoredProject> stored = openProject(copy.toStdString())) {
                work = workIn(*stored);
                break;
            }
        }
        folder->setFailures(failures);
    }
    if (!work.when.isValid() && !copies.empty())
        work.when = QFileInfo(copies.front()).lastModified();
    work.folder = folder;
    return work;
}

} // namespace moldwright
