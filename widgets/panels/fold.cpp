// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/fold.h"

#include <QToolButton>
#include <QVBoxLayout>

namespace moldwright {

Fold::Fold(const QString& title, bool open, QWidget* parent)
    : QWidget(parent), m_title(new QToolButton(this)), m_body(new QWidget(this)),
      m_content(new QVBoxLayout(m_body)) {
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(6);
    m_title->setText(title);
    m_title->setObjectName(QStringLiteral("fold-title"));
    m_title->setAccessibleName(title);
    m_title->setAutoRaise(true);
    m_title->setCheckable(true);
    m_title->setChecked(open);
    m_title->setFocusPolicy(Qt::StrongFocus);
    m_title->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
    QFont bold = m_title->font();
    bold.setBold(true);
    bold.setPixelSize(12);
    m_title->setFont(bold);
    column->addWidget(m_title, 0, Qt::AlignLeft);
    m_content->setContentsMargins(0, 0, 0, 0);
    m_content->setSpacing(6);
    column->addWidget(m_body);
    setOpen(open);
    connect(m_title, &QToolButton::toggled, this, [this](bool shown) {
        setOpen(shown);
        Q_EMIT toggled(shown);
    });
}

void Fold::setOpen(bool open) {
    m_title->setArrowType(open ? Qt::DownArrow : Qt::RightArrow);
    m_body->setVisible(open);
}

} // namespace moldwright
