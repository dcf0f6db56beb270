// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/samples.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

/// Installed beside the program, else in the source tree it was built from.
QDir samplesFolder() {
    const QDir installed(QCoreApplication::applicationDirPath() + u"/../share/moldwright/samples"_s);
    return installed.exists() ? installed : QDir(QStringLiteral(MOLDWRIGHT_SAMPLES));
}

} // namespace

std::vector<SampleCard> bundledSamples() {
    const QDir folder = samplesFolder();
    QFile list(folder.filePath(u"samples.json"_s));
    std::vector<SampleCard> cards;
    if (!list.open(QIODevice::ReadOnly))
        return cards;
    for (const QJsonValue& value :
         QJsonDocument::fromJson(list.readAll()).object().value("samples"_L1).toArray()) {
        const QJsonObject sample = value.toObject();
        const QString file = sample.value("file"_L1).toString();
        const QString picture = u"pictures/%1.png"_s.arg(QFileInfo(file).completeBaseName());
        cards.push_back(
            {folder.filePath(file),
             QCoreApplication::translate("Samples", sample.value("title"_L1).toString().toUtf8().constData()),
             QCoreApplication::translate("Samples",
                                         sample.value("description"_L1).toString().toUtf8().constData()),
             folder.filePath(picture)});
    }
    return cards;
}

} // namespace moldwright
