// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/sentence.h"

#include "language/core_words.h"

#include <QRegularExpression>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

/// A number as it is set in print; anything else, such as a file's name, as it is.
std::string withTrueMinus(const std::string& argument) {
    const QString text = QString::fromStdString(argument);
    bool isNumber = false;
    text.toDouble(&isNumber);
    return isNumber ? QString(text).replace(u'-', QChar(0x2212)).toStdString() : argument;
}

} // namespace

QString sentence(const Message& message) {
    Message shown{inSpokenLanguage(message.text), message.arguments};
    for (std::string& argument : shown.arguments)
        argument = withTrueMinus(argument);
    return QString::fromStdString(shown.english());
}

QString sentence(const std::string& english) {
    return QString::fromStdString(inSpokenLanguage(english));
}

QString sentenceWithWords(Message message) {
    for (std::string& argument : message.arguments)
        argument = inSpokenLanguage(argument);
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
