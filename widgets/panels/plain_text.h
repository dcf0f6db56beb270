// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QRegularExpression>
#include <QString>

namespace moldwright {

/// The text of a command without the mark of its key in menus: "&Open" is "Open", "打开(&O)…" is "打开…".
[[nodiscard]] inline QString plainText(QString text) {
    static const QRegularExpression inBrackets(QStringLiteral("\\(&.\\)"));
    return text.remove(inBrackets).remove(u'&');
}

} // namespace moldwright
