// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/picture_list.h"

#include "theme/theme.h"

#include <QPainter>
#include <QPainterPath>
#include <QSignalBlocker>
#include <QStyledItemDelegate>

namespace moldwright {

namespace {

constexpr int captionHeight = 38;
constexpr int gap = 6;
constexpr int columns = 2;
constexpr QSize card{PictureList::pictureSize.width() + 2, PictureList::pictureSize.height() + captionHeight};

constexpr int textWidth = card.width() - 14;

enum Role { PictureRole = Qt::UserRole, DetailsRole };

QFont captionFont(QFont font) {
    font.setPixelSize(12);
    font.setBold(true);
    return font;
}

QFont detailsFont(QFont font) {
    font.setPixelSize(11);
    font.setBold(false);
    return font;
}

/// Draws a card as those of the start page: picture on the view's ground, two lines, an outline.
class CardDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const override {
        return card;
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        painter->save();
        painter->setRenderHint(QPainter::Antialiasing);
        painter->setRenderHint(QPainter::SmoothPixmapTransform);
        const QPalette& palette = theme().palette;
        const QRect area(option.rect.topLeft(), card);
        QPainterPath frame;
        frame.addRoundedRect(QRectF(area).adjusted(1, 1, -1, -1), 4, 4);
        painter->setClipPath(frame);
        painter->fillPath(frame, palette.color(QPalette::Base));
        const QRect top(area.topLeft() + QPoint(1, 1), PictureList::pictureSize);
        QLinearGradient ground(top.topLeft(), top.bottomLeft());
        ground.setColorAt(0, toColor(theme().scene.viewTop));
        ground.setColorAt(1, toColor(theme().scene.viewBottom));
        painter->fillRect(top, ground);
        painter->drawImage(top, index.data(PictureRole).value<QImage>());
        write(*painter, area, palette, index, option.font);
        painter->setClipping(false);
        const bool chosen = option.state.testFlag(QStyle::State_Selected);
        const bool under = option.state.testFlag(QStyle::State_MouseOver);
        const QColor edge = chosen  ? palette.color(theme().dark ? QPalette::Link : QPalette::Highlight)
                            : under ? palette.color(QPalette::Mid)
                                    : palette.color(QPalette::Midlight);
        painter->strokePath(frame, QPen(edge, chosen || under ? 2 : 1));
        painter->restore();
    }

private:
    static void write(QPainter& painter, const QRect& area, const QPalette& palette, const QModelIndex& index,
                      const QFont& font) {
        const QRect line(area.left() + 8, area.top() + PictureList::pictureSize.height() + 4, textWidth, 16);
        const auto text = [&](const QRect& where, const QString& words) {
            painter.drawText(where, Qt::AlignLeft | Qt::AlignVCenter,
                             painter.fontMetrics().elidedText(words, Qt::ElideRight, where.width()));
        };
        painter.setFont(captionFont(font));
        painter.setPen(palette.color(QPalette::Text));
        text(line, index.data().toString());
        painter.setFont(detailsFont(font));
        painter.setPen(palette.color(QPalette::PlaceholderText));
        text(line.translated(0, 15), index.data(DetailsRole).toString());
    }
};

} // namespace

PictureList::PictureList(const std::vector<PictureChoice>& choices, QWidget* parent) : QListWidget(parent) {
    setViewMode(IconMode);
    setMovement(Static);
    setResizeMode(Adjust);
    setSpacing(0);
    setMinimumWidth(columns * (card.width() + gap));
    setGridSize(card + QSize(gap, gap));
    setFrameShape(NoFrame);
    setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setItemDelegate(new CardDelegate(this));
    setMouseTracking(true);
    setSelectionMode(SingleSelection);
    setTabKeyNavigation(false);
    QPalette clear = palette();
    clear.setColor(QPalette::Base, Qt::transparent);
    setPalette(clear);
    for (const PictureChoice& choice : choices) {
        auto* item = new QListWidgetItem(choice.caption, this);
        item->setData(PictureRole, choice.picture);
        item->setData(DetailsRole, choice.details);
        item->setData(Qt::AccessibleTextRole, QStringLiteral("%1. %2").arg(choice.caption, choice.details));
        item->setToolTip(choice.help);
    }
    connect(this, &QListWidget::currentRowChanged, this, [this](int row) {
        if (row >= 0)
            Q_EMIT chosen(row);
    });
    // Where the one that is marked was left by another way, a click takes it again.
    connect(this, &QListWidget::itemClicked, this,
            [this](QListWidgetItem* item) { Q_EMIT chosen(row(item)); });
}

void PictureList::setChosen(int index) {
    if (index == currentRow() && (index < 0 || item(index)->isSelected()))
        return;
    const QSignalBlocker quiet(this);
    if (index < 0) {
        setCurrentItem(nullptr);
        clearSelection();
    } else {
        setCurrentRow(index);
    }
    viewport()->update();
}

bool PictureList::fits(int index) const {
    const QListWidgetItem* it = item(index);
    return QFontMetrics(captionFont(font())).horizontalAdvance(it->text()) <= textWidth &&
           QFontMetrics(detailsFont(font())).horizontalAdvance(it->data(DetailsRole).toString()) <= textWidth;
}

int PictureList::heightForWidth(int) const {
    return sizeHint().height();
}

QSize PictureList::sizeHint() const {
    const int rows = (count() + columns - 1) / columns;
    return {columns * (card.width() + gap), rows * (card.height() + gap)};
}

} // namespace moldwright
