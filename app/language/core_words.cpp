// SPDX-License-Identifier: AGPL-3.0-or-later
#include "language/core_words.h"

#include <QCoreApplication>

namespace moldwright {

using namespace Qt::StringLiterals;

const QStringList& sentenceContexts() {
    static const QStringList contexts = {
        u"exchange"_s, u"mesh"_s,     u"castability"_s, u"fill"_s,      u"pins"_s,   u"deformation"_s,
        u"design"_s,   u"mold"_s,     u"report"_s,      u"project"_s,   u"Mold"_s,   u"Project"_s,
        u"Report"_s,   u"Pictures"_s, u"Guides"_s,      u"Materials"_s, u"Presets"_s};
    return contexts;
}

std::string inSpokenLanguage(const std::string& english) {
    for (const QString& context : sentenceContexts()) {
        const QString text = QCoreApplication::translate(context.toLatin1().constData(), english.c_str());
        if (text != QString::fromStdString(english))
            return text.toStdString();
    }
    return english;
}

} // namespace moldwright
