// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/banner.h"

#include "theme/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QToolButton>

namespace moldwright {

Banner::Banner(QWidget* parent) : QFrame(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(12, 8, 12, 8);
    row->setSpacing(12);
    m_icon = new QLabel(this);
    row->addWidget(m_icon);
    auto* words = new QVBoxLayout;
    words->setSpacing(0);
    m_headline = new QLabel(this);
    QFont font = m_headline->font();
    font.setPixelSize(13);
    font.setBold(true);
    m_headline->setFont(font);
    m_text = new QLabel(this);
    m_text->setWordWrap(true);
    m_headline->setWordWrap(true);
    words->addWidget(m_headline);
    words->addWidget(m_text);
    row->addLayout(words, 1);
    for (int i = 0; i < static_cast<int>(m_actions.size()); ++i) {
        QPushButton*& action = m_actions[static_cast<std::size_t>(i)];
        action = new QPushButton(this);
        action->setProperty("primary", i == 0);
        action->setMinimumHeight(28);
        action->setObjectName(i == 0 ? QStringLiteral("banner-action") : QStringLiteral("banner-action-2"));
        row->addWidget(action);
        connect(action, &QPushButton::clicked, this, [this, i] { Q_EMIT actionChosen(i); });
    }
    auto* closeButton = new QToolButton(this);
    closeButton->setIcon(themeIcon(QStringLiteral("close")));
    closeButton->setAutoRaise(true);
    closeButton->setToolTip(tr("Close this message"));
    closeButton->setAccessibleName(closeButton->toolTip());
    row->addWidget(closeButton);
    closeButton->setObjectName(QStringLiteral("banner-close"));
    connect(closeButton, &QToolButton::clicked, this, [this] {
        hide();
        Q_EMIT closed();
    });
    hide();
}

void Banner::showMessage(Standing standing, const QString& headline, const QString& text,
                         const QStringList& actions) {
    m_standing = standing;
    m_icon->setPixmap(standingIcon(standing).pixmap(24, 24));
    m_headline->setText(headline);
    m_text->setText(text);
    m_text->setVisible(!text.isEmpty());
    for (int i = 0; i < static_cast<int>(m_actions.size()); ++i) {
        m_actions[static_cast<std::size_t>(i)]->setText(actions.value(i));
        m_actions[static_cast<std::size_t>(i)]->setVisible(i < actions.size());
    }
    setAccessibleName(headline);
    setAccessibleDescription(text);
    show();
}

QString Banner::headline() const {
    return m_headline->text();
}

void Banner::paintEvent(QPaintEvent*) {
    const Theme& t = theme();
    const QColor ground = m_standing == Standing::Failing ? t.bannerRed
                          : m_standing == Standing::Done  ? t.bannerGreen
                                                          : t.bannerAmber;
    QPainter painter(this);
    painter.fillRect(rect(), ground);
    painter.fillRect(0, height() - 1, width(), 1, standingColour(m_standing));
}

} // namespace moldwright
