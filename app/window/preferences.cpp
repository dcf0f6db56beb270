// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/preferences.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QSettings>

namespace moldwright::preferences {

using namespace Qt::StringLiterals;

namespace {

constexpr int mostRecent = 6;

QString whenOf(const QFileInfo& file) {
    const QDateTime time = file.lastModified();
    const qint64 days = time.date().daysTo(QDate::currentDate());
    if (days <= 0)
        return time.toString(u"HH:mm"_s);
    return QLocale().toString(time.date(), days < 300 ? u"d MMM"_s : u"MMM yyyy"_s);
}

} // namespace

ThemeChoice themeChoice() {
    const QString name = QSettings().value(u"theme"_s).toString();
    return name == u"dark"_s    ? ThemeChoice::Dark
           : name == u"light"_s ? ThemeChoice::Light
                                : ThemeChoice::System;
}

void setThemeChoice(ThemeChoice choice) {
    QSettings().setValue(u"theme"_s, choice == ThemeChoice::Dark    ? u"dark"_s
                                     : choice == ThemeChoice::Light ? u"light"_s
                                                                    : u"system"_s);
}

QString language() {
    return QSettings().value(u"language"_s).toString();
}

void setLanguage(const QString& language) {
    QSettings().setValue(u"language"_s, language);
}

QLocale locale() {
    return language().isEmpty() ? QLocale::system() : QLocale(language());
}

QString navigation() {
    return QSettings().value(u"navigation"_s).toString();
}

void setNavigation(const QString& id) {
    QSettings().setValue(u"navigation"_s, id);
}

std::optional<QKeySequence> keysOf(const QString& command) {
    const QVariant kept = QSettings().value(u"keys/"_s + command);
    return kept.isValid() ? std::optional(QKeySequence(kept.toString(), QKeySequence::PortableText))
                          : std::nullopt;
}

void setKeysOf(const QString& command, const std::optional<QKeySequence>& keys) {
    if (keys)
        QSettings().setValue(u"keys/"_s + command, keys->toString(QKeySequence::PortableText));
    else
        QSettings().remove(u"keys/"_s + command);
}

Defaults defaults() {
    const QSettings kept;
    const Defaults first;
    return {kept.value(u"defaults/draft"_s, first.draftDegrees).toDouble(),
            kept.value(u"defaults/tilt"_s, first.maxTiltDegrees).toDouble(),
            kept.value(u"defaults/wall"_s, first.wall).toDouble()};
}

void setDefaults(const Defaults& defaults) {
    QSettings kept;
    kept.setValue(u"defaults/draft"_s, defaults.draftDegrees);
    kept.setValue(u"defaults/tilt"_s, defaults.maxTiltDegrees);
    kept.setValue(u"defaults/wall"_s, defaults.wall);
}

std::vector<RecentFile> recentFiles() {
    std::vector<RecentFile> files;
    for (const QString& file : QSettings().value(u"recent"_s).toStringList())
        if (const QFileInfo info(file); info.exists())
            files.push_back({file, whenOf(info)});
    return files;
}

void addRecentFile(const QString& file) {
    QStringList files = QSettings().value(u"recent"_s).toStringList();
    const QString full = QFileInfo(file).absoluteFilePath();
    files.removeAll(full);
    files.prepend(full);
    QSettings().setValue(u"recent"_s, files.mid(0, mostRecent));
}

void clearRecentFiles() {
    QSettings().remove(u"recent"_s);
}

QByteArray layout(const QString& name) {
    return QSettings().value(u"layout/"_s + name).toByteArray();
}

void setLayout(const QString& name, const QByteArray& layout) {
    QSettings().setValue(u"layout/"_s + name, layout);
}

QString folder() {
    return QSettings().value(u"folder"_s, QDir::homePath()).toString();
}

void setFolderOf(const QString& file) {
    QSettings().setValue(u"folder"_s, QFileInfo(file).absolutePath());
}

} // namespace moldwright::preferences
