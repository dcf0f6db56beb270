// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/start_page.h"

#include "panels/plain_text.h"
#include "theme/icons.h"
#include "theme/theme.h"

#include <QAbstractButton>
#include <QAction>
#include <QEvent>
#include <QFileInfo>
#include <QGridLayout>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QScrollArea>
#include <QStyleOption>
#include <QVBoxLayout>

namespace moldwright {

namespace {

constexpr int leftWidth = 340;
constexpr int cardWidth = 232;
constexpr int cardHeight = 248;
constexpr int pictureHeight = 198;
constexpr int mostLost = 3; ///< at a time

QFont fontOf(const QWidget* widget, int pixels, bool bold) {
    QFont font = widget->font();
    font.setPixelSize(pixels);
    font.setBold(bold);
    return font;
}

/// A framed button with its own painting: outline, focus ring, and what a derived class draws.
class CardButton : public QAbstractButton {
public:
    explicit CardButton(QWidget* parent) : QAbstractButton(parent) {
        setFocusPolicy(Qt::StrongFocus);
        setCursor(Qt::PointingHandCursor);
        setAttribute(Qt::WA_Hover);
    }

protected:
    virtual void paintContent(QPainter& painter) = 0;

    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const QPalette& palette = theme().palette;
        QPainterPath frame;
        frame.addRoundedRect(QRectF(rect()).adjusted(0.5, 0.5, -0.5, -0.5), 4, 4);
        painter.setClipPath(frame);
        painter.fillPath(frame, palette.color(QPalette::Base));
        paintContent(painter);
        painter.setClipping(false);
        const bool marked = hasFocus() || underMouse();
        const QColor edge = hasFocus() ? palette.color(theme().dark ? QPalette::Link : QPalette::Highlight)
                            : underMouse() ? palette.color(QPalette::Mid)
                                           : palette.color(QPalette::Midlight);
        painter.strokePath(frame, QPen(edge, marked ? 2 : 1));
    }
};

class SampleButton : public CardButton {
public:
    SampleButton(const SampleCard& sample, QWidget* parent) : CardButton(parent), m_sample(sample) {
        setFixedSize(cardWidth, cardHeight);
        setText(sample.name);
        setAccessibleName(sample.name);
        setAccessibleDescription(sample.words);
        setToolTip(sample.words);
        setObjectName(QStringLiteral("sample-") + QFileInfo(sample.file).completeBaseName());
        m_picture.load(sample.picture);
    }

    [[nodiscard]] const QString& file() const { return m_sample.file; }
    void setPicture(const QPixmap& picture) {
        m_picture = picture;
        update();
    }

protected:
    void paintContent(QPainter& painter) override {
        const scene::SceneColours& colours = theme().scene;
        QLinearGradient ground(0, 0, 0, pictureHeight);
        ground.setColorAt(0, toColor(colours.viewTop));
        ground.setColorAt(1, toColor(colours.viewBottom));
        painter.fillRect(0, 0, width(), pictureHeight, ground);
        if (!m_picture.isNull()) {
            painter.setRenderHint(QPainter::SmoothPixmapTransform);
            const QSize fit = (m_picture.size() / m_picture.devicePixelRatio())
                                  .scaled(width(), pictureHeight, Qt::KeepAspectRatio);
            painter.drawPixmap(QRect((width() - fit.width()) / 2, (pictureHeight - fit.height()) / 2,
                                     fit.width(), fit.height()),
                               m_picture);
        } else {
            themeIcon(QStringLiteral("part"))
                .paint(&painter, QRect(width() / 2 - 24, pictureHeight / 2 - 24, 48, 48));
        }
        const QPalette& palette = theme().palette;
        painter.fillRect(0, pictureHeight, width(), 1, palette.color(QPalette::Midlight));
        painter.setPen(palette.color(QPalette::Text));
        painter.setFont(fontOf(this, 13, true));
        painter.drawText(QRect(12, pictureHeight + 7, width() - 24, 18), Qt::AlignLeft | Qt::AlignVCenter,
                         text());
        painter.setPen(palette.color(QPalette::PlaceholderText));
        painter.setFont(fontOf(this, 12, false));
        const QString words = painter.fontMetrics().elidedText(m_sample.words, Qt::ElideRight, width() - 24);
        painter.drawText(QRect(12, pictureHeight + 25, width() - 24, 16), Qt::AlignLeft | Qt::AlignVCenter,
                         words);
    }

private:
    SampleCard m_sample;
    QPixmap m_picture;
};

class RecentButton : public CardButton {
public:
    RecentButton(const RecentFile& recent, QWidget* parent) : CardButton(parent), m_recent(recent) {
        setFixedHeight(48);
        setText(QFileInfo(recent.file).fileName());
        setAccessibleName(text());
        setAccessibleDescription(recent.file);
        setToolTip(recent.file);
    }

protected:
    void paintContent(QPainter& painter) override {
        const QPalette& palette = theme().palette;
        const bool project = m_recent.file.endsWith(QStringLiteral(".moldwright"));
        themeIcon(project ? QStringLiteral("mold") : QStringLiteral("part"))
            .paint(&painter, QRect(14, 12, 24, 24));
        painter.setPen(palette.color(QPalette::Text));
        painter.setFont(fontOf(this, 12, true));
        const int room = width() - 52 - 96;
        painter.drawText(QRect(52, 6, room, 18), Qt::AlignLeft | Qt::AlignVCenter,
                         painter.fontMetrics().elidedText(text(), Qt::ElideMiddle, room));
        painter.setPen(palette.color(QPalette::PlaceholderText));
        painter.setFont(fontOf(this, 11, false));
        painter.drawText(
            QRect(52, 24, width() - 64, 16), Qt::AlignLeft | Qt::AlignVCenter,
            painter.fontMetrics().elidedText(QFileInfo(m_recent.file).path(), Qt::ElideMiddle, width() - 66));
        painter.drawText(QRect(width() - 100, 6, 88, 18), Qt::AlignRight | Qt::AlignVCenter, m_recent.when);
    }

private:
    RecentFile m_recent;
};

QPushButton* wideButton(QAction* action, bool primary, QWidget* parent) {
    auto* button = new QPushButton(parent);
    button->setProperty("primary", primary);
    button->setMinimumHeight(36);
    button->setText(plainText(action->text()));
    button->setIcon(primary ? tintedIcon(action->property("iconName").toString(), Qt::white)
                            : action->icon());
    button->setToolTip(action->toolTip());
    button->setObjectName(QStringLiteral("start-") + action->objectName());
    QObject::connect(button, &QPushButton::clicked, action, &QAction::trigger);
    return button;
}

} // namespace

StartPage::StartPage(QAction* open, QAction* tour, const std::vector<SampleCard>& samples, QWidget* parent)
    : QWidget(parent) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(40, 32, 20, 0);
    row->setSpacing(40);
    row->addWidget(makeLeft(open, tour));
    row->addWidget(makeRight(samples), 1);
}

QWidget* StartPage::makeLeft(QAction* open, QAction* tour) {
    auto* left = new QWidget(this);
    left->setFixedWidth(leftWidth);
    auto* column = new QVBoxLayout(left);
    column->setContentsMargins(0, 0, 0, 12);
    column->setSpacing(6);
    auto* title = new QLabel(tr("Start"), left);
    title->setFont(fontOf(left, 20, true));
    column->addWidget(title);
    auto* hint = new QLabel(tr("Or drop a file anywhere: STL, OBJ, PLY, OFF, Moldwright projects."), left);
    hint->setForegroundRole(QPalette::PlaceholderText);
    hint->setWordWrap(true);
    column->addWidget(hint);
    column->addSpacing(6);
    column->addWidget(wideButton(open, true, left));
    column->addWidget(wideButton(tour, false, left));
    column->addSpacing(20);
    m_lost = new QVBoxLayout;
    m_lost->setSpacing(8);
    column->addLayout(m_lost);
    m_recentHead = new QWidget(left);
    auto* head = new QHBoxLayout(m_recentHead);
    head->setContentsMargins(0, 0, 0, 0);
    auto* recentTitle = new QLabel(tr("Recent"), m_recentHead);
    recentTitle->setFont(fontOf(left, 15, true));
    head->addWidget(recentTitle, 1);
    m_clear = new QLabel(m_recentHead);
    m_clear->setTextInteractionFlags(Qt::LinksAccessibleByMouse | Qt::LinksAccessibleByKeyboard);
    writeClearLink();
    head->addWidget(m_clear);
    connect(m_clear, &QLabel::linkActivated, this, &StartPage::clearRecent);
    column->addWidget(m_recentHead);
    m_recent = new QVBoxLayout;
    m_recent->setSpacing(6);
    column->addLayout(m_recent);
    column->addStretch(1);
    return left;
}

QWidget* StartPage::makeRight(const std::vector<SampleCard>& samples) {
    auto* right = new QWidget(this);
    auto* column = new QVBoxLayout(right);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(12);
    auto* head = new QHBoxLayout;
    head->setSpacing(12);
    auto* title = new QLabel(tr("Samples"), right);
    title->setFont(fontOf(right, 20, true));
    head->addWidget(title);
    auto* hint = new QLabel(tr("Closed parts that you would really cast. Each opens as a copy."), right);
    hint->setForegroundRole(QPalette::PlaceholderText);
    head->addWidget(hint, 1, Qt::AlignBottom);
    column->addLayout(head);

    auto* scroll = new QScrollArea(right);
    scroll->setFrameShape(QFrame::NoFrame);
    scroll->setWidgetResizable(true);
    scroll->setFocusPolicy(Qt::NoFocus);
    auto* field = new QWidget(scroll);
    m_grid = new QGridLayout(field);
    m_grid->setContentsMargins(2, 2, 2, 20);
    m_grid->setSpacing(16);
    m_grid->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    for (const SampleCard& sample : samples) {
        auto* card = new SampleButton(sample, field);
        connect(card, &QAbstractButton::clicked, this,
                [this, sample] { Q_EMIT sampleChosen(sample.file, sample.name); });
        m_cards.push_back(card);
    }
    scroll->setWidget(field);
    scroll->viewport()->setAutoFillBackground(false);
    field->setAutoFillBackground(false);
    column->addWidget(scroll, 1);
    return right;
}

void StartPage::arrangeCards() {
    const int room = width() - 40 - leftWidth - 40 - 20;
    const int columns = std::clamp(room / (cardWidth + 16), 2, 4);
    for (std::size_t i = 0; i < m_cards.size(); ++i)
        m_grid->addWidget(m_cards[i], static_cast<int>(i) / columns, static_cast<int>(i) % columns);
}

void StartPage::resizeEvent(QResizeEvent* event) {
    QWidget::resizeEvent(event);
    arrangeCards();
}

void StartPage::writeClearLink() {
    m_clear->setText({}); // the same text again would keep its colour
    m_clear->setText(
        QStringLiteral("<a href=\"#\" style=\"text-decoration:none\">%1</a>").arg(tr("Clear list")));
}

void StartPage::changeEvent(QEvent* event) {
    QWidget::changeEvent(event);
    if (event->type() == QEvent::PaletteChange && m_clear)
        writeClearLink(); // a link keeps the colour it was written in
}

void StartPage::setRecent(const std::vector<RecentFile>& files) {
    while (QLayoutItem* item = m_recent->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    m_recentHead->setVisible(!files.empty());
    for (const RecentFile& file : files) {
        auto* button = new RecentButton(file, this);
        connect(button, &QAbstractButton::clicked, this, [this, file] { Q_EMIT fileChosen(file.file); });
        m_recent->addWidget(button);
    }
}

void StartPage::setLost(const std::vector<LostCard>& cards) {
    if (cards == m_lostCards)
        return; // a button keeps the keyboard
    m_lostCards = cards;
    while (QLayoutItem* item = m_lost->takeAt(0)) {
        delete item->widget();
        delete item;
    }
    for (int i = 0; i < std::min(static_cast<int>(cards.size()), mostLost); ++i) {
        auto* card = new LostCardFrame(cards[static_cast<std::size_t>(i)], this);
        connect(card, &LostCardFrame::reopenChosen, this, [this, i] { Q_EMIT lostChosen(i); });
        connect(card, &LostCardFrame::discardChosen, this, [this, i] { Q_EMIT lostDiscarded(i); });
        connect(card, &LostCardFrame::showChosen, this, [this, i] { Q_EMIT lostShown(i); });
        m_lost->addWidget(card);
    }
    if (!cards.empty())
        m_lost->addSpacing(20);
}

void StartPage::setPicture(const QString& file, const QPixmap& picture) {
    for (QWidget* card : m_cards)
        if (auto* sample = static_cast<SampleButton*>(card); sample->file() == file)
            sample->setPicture(picture);
}

} // namespace moldwright
