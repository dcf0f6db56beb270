// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/selection.h"

#include <algorithm>
#include <array>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

/// What rows of several kinds begin with that can be chosen together; empty for any other.
QString kindOf(const QString& id) {
    for (const QString& kind : {u"pin-"_s, u"region-"_s, u"feature-"_s})
        if (id.startsWith(kind))
            return kind;
    return {};
}

} // namespace

Choosing choosingBy(Qt::KeyboardModifiers keys) {
    return keys.testFlag(Qt::ControlModifier) ? Choosing::Toggle
           : keys.testFlag(Qt::ShiftModifier) ? Choosing::Add
           : keys.testFlag(Qt::AltModifier)   ? Choosing::Subtract
                                              : Choosing::Only;
}

QStringList chosenIds(const QString& chosen) {
    return chosen.split(u' ');
}

bool severalChosen(const QString& chosen) {
    return chosen.contains(u' ');
}

QString chosenTogether(const QStringList& ids) {
    const QString kind = kindOf(ids.back());
    QStringList together;
    for (const QString& id : ids)
        if (id == ids.back() || (!kind.isEmpty() && kindOf(id) == kind))
            together << id;
    return together.join(u' ');
}

QString chosenWith(const QString& chosen, const QStringList& ids, Choosing how) {
    if (ids.isEmpty())
        return chosen;
    QStringList all = how == Choosing::Only ? QStringList() : chosenIds(chosen);
    for (const QString& id : ids) {
        const bool was = all.removeOne(id);
        if (how == Choosing::Only || how == Choosing::Add || (how == Choosing::Toggle && !was))
            all << id; // what was chosen already is the last one now
    }
    return all.isEmpty() ? chosen : chosenTogether(all);
}

} // namespace moldwright
