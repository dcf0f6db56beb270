// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/lost_card.h"

#include "theme/icons.h"
#include "theme/theme.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>

namespace moldwright {

namespace {

constexpr QSize pictureSize(72, 54);
constexpr int padding = 12;

QLabel* pictureOf(const LostCard& card, QWidget* parent) {
    auto* label = new QLabel(parent);
    label->setFixedSize(pictureSize);
    label->setAlignment(Qt::AlignCenter);
    if (card.picture.isNull()) {
        label->setPixmap(themeIcon(QStringLiteral("warn")).pixmap(32, 32));
    } else {
        const qreal ratio = parent->devicePixelRatioF();
        QPixmap picture = QPixmap::fromImage(
            card.picture.scaled(pictureSize * ratio, Qt::KeepAspectRatio, Qt::SmoothTransformation));
        picture.setDevicePixelRatio(ratio);
        label->setPixmap(picture);
    }
    return label;
}

} // namespace

LostCardFrame::LostCardFrame(const LostCard& card, QWidget* parent) : QFrame(parent) {
    setToolTip(card.path);
    setAccessibleName(card.name);
    setAccessibleDescription(card.words);
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(padding, padding, padding, padding);
    row->setSpacing(padding);
    row->addWidget(pictureOf(card, this), 0, Qt::AlignTop);
    auto* column = new QVBoxLayout;
    column->setSpacing(2);
    auto* name = new QLabel(card.name, this);
    QFont bold = name->font();
    bold.setPixelSize(13);
    bold.setBold(true);
    name->setFont(bold);
    name->setTextFormat(Qt::PlainText);
    auto* words = new QLabel(card.words, this);
    words->setWordWrap(true);
    column->addWidget(name);
    column->addWidget(words);
    column->addSpacing(6);
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(8);
    auto* open = new QPushButton(card.readable ? tr("Recover") : tr("Show the folder"), this);
    open->setObjectName(QStringLiteral("lost-open"));
    auto* discard = new QPushButton(tr("Discard"), this);
    discard->setObjectName(QStringLiteral("lost-discard"));
    discard->setToolTip(tr("Puts it into the trash."));
    buttons->addWidget(open);
    buttons->addWidget(discard);
    buttons->addStretch(1);
    column->addLayout(buttons);
    row->addLayout(column, 1);
    connect(open, &QPushButton::clicked, this,
            card.readable ? &LostCardFrame::reopenChosen : &LostCardFrame::showChosen);
    connect(discard, &QPushButton::clicked, this, &LostCardFrame::discardChosen);
}

void LostCardFrame::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    painter.setBrush(theme().bannerAmber);
    painter.setPen(QPen(theme().warning, 1));
    painter.drawRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
}

} // namespace moldwright
