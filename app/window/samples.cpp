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

/// The words of samples.json, for those who translate.
[[maybe_unused]] constexpr const char* sampleWords[] = {
    QT_TRANSLATE_NOOP("Samples", "Goat head"),
    QT_TRANSLATE_NOOP("Samples", "Curled horns, an eye worth keeping"),
    QT_TRANSLATE_NOOP("Samples", "Sitting rabbit"),
    QT_TRANSLATE_NOOP("Samples", "Ears that lean apart"),
    QT_TRANSLATE_NOOP("Samples", "Standing goat"),
    QT_TRANSLATE_NOOP("Samples", "Four legs, two horns, one plane"),
    QT_TRANSLATE_NOOP("Samples", "Hand"),
    QT_TRANSLATE_NOOP("Samples", "Which plane suits the fingers?"),
    QT_TRANSLATE_NOOP("Samples", "Fish"),
    QT_TRANSLATE_NOOP("Samples", "Keep the curve of the tail fin"),
    QT_TRANSLATE_NOOP("Samples", "Bent beam"),
    QT_TRANSLATE_NOOP("Samples", "Sharp corners, exact flanges"),
    QT_TRANSLATE_NOOP("Samples", "Door knob"),
    QT_TRANSLATE_NOOP("Samples", "A neck that locks in any mold"),
    QT_TRANSLATE_NOOP("Samples", "Praline"),
    QT_TRANSLATE_NOOP("Samples", "Flat back, castable as it is"),
};

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
