// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/key_table.h"

#include "panels/plain_text.h"
#include "theme/theme.h"
#include "window/action_table.h"

#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeySequenceEdit>
#include <QLabel>
#include <QPushButton>
#include <QStyle>
#include <QTreeWidget>
#include <QVBoxLayout>

#include <algorithm>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

enum Column { CommandColumn, KeysColumn, MenuColumn, ColumnCount };

QString plain(const QString& text) {
    return plainText(text).remove(u'…');
}

} // namespace

KeyTable::KeyTable(Actions& actions, QWidget* parent) : QWidget(parent), m_actions(actions) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    auto* heading = new QLabel(tr("Keys"), this);
    QFont bold = heading->font();
    bold.setBold(true);
    heading->setFont(bold);
    column->addWidget(heading);
    m_list = new QTreeWidget(this);
    m_list->setObjectName(u"keys-list"_s);
    m_list->setAccessibleName(tr("Commands and their keys"));
    m_list->setRootIsDecorated(false);
    m_list->setUniformRowHeights(true);
    m_list->setColumnCount(ColumnCount);
    m_list->setHeaderLabels({tr("Command"), tr("Keys"), tr("Menu")});
    m_list->header()->setStretchLastSection(true);
    m_list->setMinimumHeight(160);
    column->addWidget(m_list, 1);
    column->addWidget(makeFoot());
    m_conflict = new QLabel(this);
    m_conflict->setObjectName(u"keys-conflict"_s);
    m_conflict->setWordWrap(true);
    QPalette warning = m_conflict->palette();
    warning.setColor(QPalette::WindowText, theme().warning);
    m_conflict->setPalette(warning);
    column->addWidget(m_conflict);
    fill();
    m_list->setCurrentItem(m_list->topLevelItem(0));
    m_list->header()->resizeSections(QHeaderView::ResizeToContents);
    connect(m_list, &QTreeWidget::currentItemChanged, this, &KeyTable::choose);
    connect(m_keys, &QKeySequenceEdit::editingFinished, this, &KeyTable::take);
    choose();
}

QWidget* KeyTable::makeFoot() {
    auto* foot = new QWidget(this);
    auto* row = new QHBoxLayout(foot);
    row->setContentsMargins(0, 0, 0, 0);
    row->setSpacing(8);
    m_command = new QLabel(foot);
    row->addWidget(m_command, 1);
    m_keys = new QKeySequenceEdit(foot);
    m_keys->setObjectName(u"keys-edit"_s);
    m_keys->setAccessibleName(tr("Type other keys"));
    m_keys->setToolTip(tr("Type other keys"));
    m_keys->setFixedWidth(160);
    row->addWidget(m_keys);
    m_reset = new QPushButton(tr("Reset"), foot);
    m_reset->setObjectName(u"keys-reset"_s);
    m_resetAll = new QPushButton(tr("Reset all keys"), foot);
    m_resetAll->setObjectName(u"keys-reset-all"_s);
    for (QPushButton* button : {m_reset, m_resetAll}) {
        button->setAutoDefault(false);
        row->addWidget(button);
    }
    connect(m_reset, &QPushButton::clicked, this, [this] {
        m_keys->setKeySequence(m_actions.firstKeys(chosen()));
        take();
    });
    connect(m_resetAll, &QPushButton::clicked, this, [this] {
        m_actions.resetKeys();
        fill();
        choose();
    });
    return foot;
}

QString KeyTable::chosen() const {
    return m_list->currentItem() ? m_list->currentItem()->data(CommandColumn, Qt::UserRole).toString()
                                 : QString();
}

void KeyTable::fill() {
    QPixmap clear(m_list->style()->pixelMetric(QStyle::PM_SmallIconSize), 16);
    clear.fill(Qt::transparent);
    const QIcon blank(clear); // so that all words begin in one line
    int row = 0;
    for (const QAction* action : m_actions.all()) {
        QTreeWidgetItem* item = m_list->topLevelItem(row++);
        if (!item)
            item = new QTreeWidgetItem(m_list);
        item->setData(CommandColumn, Qt::UserRole, action->objectName());
        item->setText(CommandColumn, plain(action->text()));
        item->setIcon(CommandColumn, action->icon().isNull() ? blank : action->icon());
        item->setText(KeysColumn, action->shortcut().toString(QKeySequence::NativeText));
        item->setText(MenuColumn, plain(action->property("menu").toString()));
        QFont font = m_list->font();
        font.setBold(action->shortcut() != m_actions.firstKeys(action->objectName()));
        item->setFont(KeysColumn, font);
    }
}

void KeyTable::choose() {
    m_conflict->clear();
    const QString id = chosen();
    m_keys->setEnabled(!id.isEmpty());
    if (id.isEmpty())
        return;
    m_command->setText(plain(m_actions[id]->text()));
    m_keys->setKeySequence(m_actions[id]->shortcut());
    m_reset->setEnabled(m_actions[id]->shortcut() != m_actions.firstKeys(id));
    m_resetAll->setEnabled(m_actions.anyKeysChanged());
}

void KeyTable::take() {
    const QString id = chosen();
    const QKeySequence keys = m_keys->keySequence();
    if (id.isEmpty() || keys == m_actions[id]->shortcut())
        return;
    if (const QAction* other = m_actions.withKeys(keys); other && other->objectName() != id) {
        m_keys->setKeySequence(m_actions[id]->shortcut());
        m_conflict->setText(tr("%1 belongs to %2. Give that command other keys first.")
                                .arg(keys.toString(QKeySequence::NativeText), plain(other->text())));
        return;
    }
    m_actions.setKeys(id, keys);
    fill();
    choose();
}

int KeyTable::filter(const QString& typed) {
    const QStringList parts = typed.split(u' ', Qt::SkipEmptyParts);
    int shown = 0;
    for (int row = 0; row < m_list->topLevelItemCount(); ++row) {
        QTreeWidgetItem* item = m_list->topLevelItem(row);
        const QString words =
            item->text(CommandColumn) + u' ' + item->text(KeysColumn) + u' ' + item->text(MenuColumn);
        const bool fits = std::ranges::all_of(
            parts, [&](const QString& part) { return words.contains(part, Qt::CaseInsensitive); });
        item->setHidden(!fits);
        shown += fits ? 1 : 0;
    }
    return shown;
}

} // namespace moldwright
