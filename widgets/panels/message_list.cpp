// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/message_list.h"

#include "theme/theme.h"

#include <QCoreApplication>
#include <QPainter>
#include <QStyledItemDelegate>

namespace moldwright {

namespace {

constexpr int textLeft = 72;
constexpr int linkWidth = 84;

/// Room for a message's text: the same with and without a scroll bar, since rows are measured before one
/// comes.
int textWidth(const QListView& list, const SessionMessage& message) {
    const int bar = list.style()->pixelMetric(QStyle::PM_ScrollBarExtent, nullptr, &list);
    return std::max(80, list.width() - bar - textLeft - 12 - (message.place.isEmpty() ? 0 : linkWidth));
}

/// Icon, time, text over as many lines as it needs, and the link at the right.
class MessageDelegate : public QStyledItemDelegate {
    Q_DECLARE_TR_FUNCTIONS(MessageDelegate)
public:
    MessageDelegate(MessageModel* model, QObject* parent) : QStyledItemDelegate(parent), m_model(model) {}

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                                 const QModelIndex& index) const override {
        const int width = textWidth(listOf(option), m_model->at(index.row()));
        const QRect box = option.fontMetrics.boundingRect(0, 0, width, 1000, Qt::TextWordWrap,
                                                          m_model->at(index.row()).text);
        return {width, std::max(24, box.height() + 8)};
    }

    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        const SessionMessage& message = m_model->at(index.row());
        const QPalette& palette = theme().palette;
        const QRect& r = option.rect;
        const bool selected = option.state.testFlag(QStyle::State_Selected);
        if (selected)
            painter->fillRect(r, theme().accentSoft);
        standingIcon(message.standing).paint(painter, QRect(r.left() + 10, r.top() + 4, 16, 16));
        painter->setFont(option.font);
        painter->setPen(palette.color(QPalette::PlaceholderText));
        painter->drawText(QRect(r.left() + 34, r.top() + 4, 40, 16), Qt::AlignLeft | Qt::AlignVCenter,
                          message.time.toString(QStringLiteral("HH:mm")));
        painter->setPen(palette.color(QPalette::Text));
        painter->drawText(
            QRect(r.left() + textLeft, r.top() + 4, textWidth(listOf(option), message), r.height() - 8),
            Qt::TextWordWrap, message.text);
        if (!message.place.isEmpty()) {
            painter->setPen(palette.color(QPalette::Link));
            painter->drawText(QRect(r.right() - linkWidth - 10, r.top() + 4, linkWidth, 16),
                              Qt::AlignRight | Qt::AlignVCenter, tr("Show me"));
        }
    }

private:
    static const QListView& listOf(const QStyleOptionViewItem& option) {
        return *static_cast<const QListView*>(option.widget);
    }

    MessageModel* m_model;
};

} // namespace

void MessageModel::add(const SessionMessage& message) {
    beginInsertRows({}, 0, 0);
    m_messages.insert(m_messages.begin(), message);
    endInsertRows();
}

void MessageModel::clear() {
    beginResetModel();
    m_messages.clear();
    endResetModel();
}

int MessageModel::rowCount(const QModelIndex& parent) const {
    return parent.isValid() ? 0 : static_cast<int>(m_messages.size());
}

QVariant MessageModel::data(const QModelIndex& index, int role) const {
    if (role == Qt::DisplayRole || role == Qt::AccessibleTextRole)
        return m_messages[index.row()].text;
    return {};
}

MessageList::MessageList(MessageModel* model, QWidget* parent) : QListView(parent) {
    setModel(model);
    setItemDelegate(new MessageDelegate(model, this));
    setFrameShape(QFrame::NoFrame);
    setViewportMargins(0, 4, 0, 0); // the first row keeps off the dock's title
    setBackgroundRole(QPalette::Base);
    setAutoFillBackground(true);
    setResizeMode(QListView::Adjust);
    setVerticalScrollMode(ScrollPerPixel);
    setAccessibleName(tr("Messages"));
    const auto show = [this, model](const QModelIndex& index) {
        if (const Eigen::AlignedBox3d& place = model->at(index.row()).place; !place.isEmpty())
            Q_EMIT showMe(place);
    };
    connect(this, &QListView::clicked, this, show);
    connect(this, &QListView::activated, this, show);
    connect(model, &QAbstractItemModel::rowsInserted, viewport(), qOverload<>(&QWidget::update));
}

void MessageList::paintEvent(QPaintEvent* event) {
    QListView::paintEvent(event);
    if (model()->rowCount() > 0)
        return;
    QPainter painter(viewport());
    painter.setPen(theme().palette.color(QPalette::PlaceholderText));
    painter.drawText(viewport()->rect().adjusted(12, 10, -12, 0), Qt::AlignLeft | Qt::AlignTop,
                     tr("Nothing to report."));
}

} // namespace moldwright
