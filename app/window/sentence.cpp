// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/sentence.h"

#include <QCoreApplication>
#include <QRegularExpression>

namespace moldwright {

using namespace Qt::StringLiterals;

const QStringList& sentenceContexts() {
    static const QStringList contexts = {
        u"exchange"_s, u"mesh"_s,     u"castability"_s, u"fill"_s,      u"pins"_s,   u"deformation"_s,
        u"design"_s,   u"mold"_s,     u"report"_s,      u"project"_s,   u"Mold"_s,   u"Project"_s,
        u"Report"_s,   u"Pictures"_s, u"Guides"_s,      u"Materials"_s, u"Presets"_s};
    return contexts;
}

namespace {

std::string translated(const std::string& english) {
    for (const QString& context : sentenceContexts()) {
        const QString text = QCoreApplication::translate(context.toLatin1().constData(), english.c_str());
        if (text != QString::fromStdString(english))
            return text.toStdString();
    }
    return english;
}

/// A number as it is set in print; anything else, such as a file's name, as it is.
std::string withTrueMinus(const std::string& argument) {
    const QString text = QString::fromStdString(argument);
    bool isNumber = false;
    text.toDouble(&isNumber);
    return isNumber ? QString(text).replace(u'-', QChar(0x2212)).toStdString() : argument;
}

} // namespace

QString sentence(const Message& message) {
    Message shown{translated(message.text), message.arguments};
    for (std::string& argument : shown.arguments)
        argument = withTrueMinus(argument);
    return QString::fromStdString(shown.english());
}

QString sentence(const std::string& english) {
    return QString::fromStdString(translated(english));
}

QString sentenceWithWords(Message message) {
    for (std::string& argument : message.arguments)
        argument = translated(argument);
    return sentence(message);
}

HeadAndRest headAndRest(const QString& text) {
    static const QRegularExpression end(u"\\. |。"_s);
    const QRegularExpressionMatch stop = end.match(text);
    if (!stop.hasMatch())
        return {text, {}};
    return {text.left(stop.capturedStart() + 1), text.mid(stop.capturedEnd())};
}

} // namespace moldwright
