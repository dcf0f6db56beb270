// SPDX-License-Identifier: AGPL-3.0-or-later
#include "theme/icons.h"
#include "window/action_table.h"
#include "window/preferences.h"

#include <QCoreApplication>

#include <algorithm>

namespace moldwright {

namespace {

/// The tool tip tells the keys, so both change together.
void giveKeys(QAction& action, const QKeySequence& keys) {
    action.setShortcut(keys);
    const QString words = keys.toString(QKeySequence::NativeText);
    action.setToolTip(words.isEmpty() ? action.statusTip()
                                      : QStringLiteral("%1 (%2)").arg(action.statusTip(), words));
}

} // namespace

Actions::Actions(QObject* parent) : QObject(parent) {
    const auto translated = [](const char* text) { return QCoreApplication::translate("Actions", text); };
    for (const ActionSpec& spec : actionTable()) {
        auto* action = new QAction(translated(spec.text), this);
        action->setObjectName(QString::fromLatin1(spec.id));
        action->setProperty("menu", translated(spec.menu));
        action->setProperty("iconName", QString::fromLatin1(spec.icon));
        if (*spec.icon)
            action->setIcon(themeIcon(QString::fromLatin1(spec.icon)));
        action->setShortcutContext(Qt::WindowShortcut);
        action->setStatusTip(translated(spec.hint));
        action->setCheckable(spec.checkable);
        m_actions[action->objectName()] = action;
        m_ordered.push_back(action);
        giveKeys(*action, preferences::keysOf(action->objectName())
                              .value_or(QKeySequence(QString::fromLatin1(spec.shortcut))));
    }
}

QKeySequence Actions::firstKeys(const QString& id) const {
    for (const ActionSpec& spec : actionTable())
        if (id == QLatin1String(spec.id))
            return QKeySequence(QString::fromLatin1(spec.shortcut));
    return {};
}

void Actions::setKeys(const QString& id, const QKeySequence& keys) {
    preferences::setKeysOf(id, keys == firstKeys(id) ? std::nullopt : std::optional(keys));
    giveKeys(*m_actions.at(id), keys);
}

void Actions::resetKeys() {
    for (const auto& [id, action] : m_actions)
        setKeys(id, firstKeys(id));
}

bool Actions::anyKeysChanged() const {
    return std::ranges::any_of(m_ordered, [&](const QAction* action) {
        return action->shortcut() != firstKeys(action->objectName());
    });
}

const QAction* Actions::withKeys(const QKeySequence& keys) const {
    const auto found =
        std::ranges::find_if(m_ordered, [&](const QAction* action) { return action->shortcut() == keys; });
    return keys.isEmpty() || found == m_ordered.end() ? nullptr : *found;
}

void Actions::on(const QString& id, const std::function<void()>& run) {
    connect(m_actions.at(id), &QAction::triggered, this, [run] { run(); });
}

void Actions::update(const std::function<bool(Needs)>& isSo) {
    std::size_t i = 0;
    for (const ActionSpec& spec : actionTable())
        m_ordered[i++]->setEnabled(isSo(spec.needs));
}

} // namespace moldwright
