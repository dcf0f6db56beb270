// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/command_search.h"

#include "panels/plain_text.h"
#include "theme/icons.h"
#include "theme/theme.h"

#include <QAction>
#include <QKeyEvent>
#include <QPainter>

#include <algorithm>

namespace moldwright {

namespace {

constexpr int mostShown = 10;

/// All words typed occur in the command's menu path, text or hint.
bool fits(const QAction* command, const QString& typed) {
    const QString words =
        command->property("menu").toString() + u' ' + command->text() + u' ' + command->statusTip();
    const QStringList parts = typed.split(u' ', Qt::SkipEmptyParts);
    return std::ranges::all_of(
        parts, [&](const QString& part) { return plainText(words).contains(part, Qt::CaseInsensitive); });
}

} // namespace

CommandSearch::CommandSearch(QWidget* parent) : QLineEdit(parent), m_list(new QListWidget(this)) {
    setPlaceholderText(tr("Find a command"));
    setAccessibleName(tr("Find a command"));
    setFixedSize(252, 22);
    setTextMargins(22, 0, 44, 0);
    m_list->setWindowFlags(Qt::ToolTip);
    m_list->setFocusPolicy(Qt::NoFocus);
    m_list->setFocusProxy(this);
    m_list->setIconSize({16, 16});
    m_list->hide();
    connect(this, &QLineEdit::textChanged, this, &CommandSearch::list);
    connect(m_list, &QListWidget::itemClicked, this, &CommandSearch::run);
}

void CommandSearch::setOwnCommand(QAction* command) {
    m_own = command;
    connect(command, &QAction::changed, this, qOverload<>(&QWidget::update));
}

void CommandSearch::list() {
    m_list->clear();
    for (QAction* command : m_commands) {
        if (m_list->count() == mostShown || !fits(command, text()))
            continue;
        const QString shortcut = command->shortcut().toString(QKeySequence::NativeText);
        auto* item = new QListWidgetItem(command->icon(), plainText(command->text()), m_list);
        item->setText(shortcut.isEmpty() ? item->text()
                                         : QStringLiteral("%1    %2").arg(item->text(), shortcut));
        item->setData(Qt::UserRole, QVariant::fromValue(command));
        item->setToolTip(command->statusTip());
        if (!command->isEnabled())
            item->setForeground(theme().palette.color(QPalette::Disabled, QPalette::Text));
    }
    if (!hasFocus() || m_list->count() == 0) {
        m_list->hide();
        return;
    }
    m_list->setCurrentRow(0);
    m_list->setFixedSize(std::max(width(), 340), m_list->count() * m_list->sizeHintForRow(0) + 6);
    m_list->move(mapToGlobal(QPoint(width() - m_list->width(), height() + 2)));
    m_list->show();
}

void CommandSearch::run(QListWidgetItem* item) {
    auto* command = item ? item->data(Qt::UserRole).value<QAction*>() : nullptr;
    m_list->hide();
    clear();
    if (window())
        window()->setFocus();
    clearFocus();
    if (command)
        command->trigger();
}

void CommandSearch::keyPressEvent(QKeyEvent* event) {
    switch (event->key()) {
    case Qt::Key_Down:
    case Qt::Key_Up: {
        const int step = event->key() == Qt::Key_Down ? 1 : -1;
        m_list->setCurrentRow(std::clamp(m_list->currentRow() + step, 0, std::max(0, m_list->count() - 1)));
        return;
    }
    case Qt::Key_Return:
    case Qt::Key_Enter:
        run(m_list->currentItem());
        return;
    case Qt::Key_Escape:
        run(nullptr);
        return;
    default:
        QLineEdit::keyPressEvent(event);
    }
}

void CommandSearch::focusInEvent(QFocusEvent* event) {
    QLineEdit::focusInEvent(event);
    if (event->reason() == Qt::ShortcutFocusReason || event->reason() == Qt::MouseFocusReason)
        list();
}

void CommandSearch::focusOutEvent(QFocusEvent* event) {
    QLineEdit::focusOutEvent(event);
    m_list->hide();
}

void CommandSearch::paintEvent(QPaintEvent* event) {
    QLineEdit::paintEvent(event);
    QPainter painter(this);
    themeIcon(QStringLiteral("search")).paint(&painter, QRect(6, (height() - 14) / 2, 14, 14));
    if (!text().isEmpty())
        return;
    QFont font = this->font();
    font.setPixelSize(11);
    painter.setFont(font);
    painter.setPen(palette().color(QPalette::PlaceholderText));
    painter.drawText(rect().adjusted(0, 0, -8, 0), Qt::AlignRight | Qt::AlignVCenter,
                     m_own ? m_own->shortcut().toString(QKeySequence::NativeText) : QString());
}

} // namespace moldwright
