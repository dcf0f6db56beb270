// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/project_tree.h"

#include "theme/icons.h"
#include "theme/theme.h"

#include <QContextMenuEvent>
#include <QHeaderView>
#include <QKeyEvent>
#include <QMouseEvent>
#include <QPainter>
#include <QStyledItemDelegate>

#include <algorithm>
#include <utility>

namespace moldwright {

namespace {

class RowDelegate : public QStyledItemDelegate {
public:
    using QStyledItemDelegate::QStyledItemDelegate;

    [[nodiscard]] QSize sizeHint(const QStyleOptionViewItem& option,
                                 const QModelIndex& index) const override {
        return {QStyledItemDelegate::sizeHint(option, index).width(), 24};
    }

    void initStyleOption(QStyleOptionViewItem* option, const QModelIndex& index) const override {
        QStyledItemDelegate::initStyleOption(option, index);
        // The selected row keeps its colours when the focus is elsewhere.
        option->state |= QStyle::State_Active;
    }

    /// A value may reach to the left as far as the name of its row leaves room.
    void paint(QPainter* painter, const QStyleOptionViewItem& option,
               const QModelIndex& index) const override {
        if (index.column() != ProjectModel::Value)
            return QStyledItemDelegate::paint(painter, option, index);
        QStyleOptionViewItem cell = option;
        initStyleOption(&cell, index);
        const QString words = std::exchange(cell.text, QString());
        const QStyle* style = cell.widget->style();
        style->drawControl(QStyle::CE_ItemViewItem, &cell, painter, cell.widget);
        const QRect room = static_cast<const ProjectTree*>(cell.widget)->roomOfValue(index);
        const bool selected = cell.state.testFlag(QStyle::State_Selected);
        painter->setFont(cell.font);
        painter->setPen(cell.palette.color(selected ? QPalette::HighlightedText : QPalette::Text));
        painter->drawText(room, Qt::AlignRight | Qt::AlignVCenter,
                          cell.fontMetrics.elidedText(words, Qt::ElideRight, room.width()));
    }
};

} // namespace

std::vector<int> ProjectModel::childrenOf(int parent) const {
    std::vector<int> children;
    for (int i = 0; i < static_cast<int>(m_rows.size()); ++i)
        if (m_rows[i].parent == parent)
            children.push_back(i);
    return children;
}

void ProjectModel::setRows(const std::vector<ProjectRow>& rows) {
    const auto sameShape = [](const ProjectRow& a, const ProjectRow& b) {
        return a.id == b.id && a.parent == b.parent;
    };
    if (!std::ranges::equal(rows, m_rows, sameShape)) {
        beginResetModel();
        m_rows = rows;
        endResetModel();
        return;
    }
    for (std::size_t i = 0; i < rows.size(); ++i) {
        if (rows[i] == m_rows[i])
            continue;
        m_rows[i] = rows[i];
        const QModelIndex changed = indexOf(rows[i].id);
        Q_EMIT dataChanged(changed, changed.siblingAtColumn(Eye));
    }
}

QModelIndex ProjectModel::indexOf(const QString& id) const {
    for (std::size_t i = 0; i < m_rows.size(); ++i)
        if (m_rows[i].id == id) {
            const std::vector<int> siblings = childrenOf(m_rows[i].parent);
            const auto at = std::ranges::find(siblings, static_cast<int>(i));
            return createIndex(static_cast<int>(at - siblings.begin()), Name, static_cast<quintptr>(i));
        }
    return {};
}

QModelIndex ProjectModel::index(int row, int column, const QModelIndex& parent) const {
    const std::vector<int> children =
        childrenOf(parent.isValid() ? static_cast<int>(parent.internalId()) : -1);
    if (row < 0 || row >= static_cast<int>(children.size()) || column < 0 || column >= ColumnCount)
        return {};
    return createIndex(row, column, static_cast<quintptr>(children[row]));
}

QModelIndex ProjectModel::parent(const QModelIndex& index) const {
    if (!index.isValid() || m_rows[index.internalId()].parent < 0)
        return {};
    return indexOf(m_rows[m_rows[index.internalId()].parent].id);
}

int ProjectModel::rowCount(const QModelIndex& parent) const {
    if (parent.column() > 0)
        return 0;
    return static_cast<int>(childrenOf(parent.isValid() ? static_cast<int>(parent.internalId()) : -1).size());
}

QVariant ProjectModel::data(const QModelIndex& index, int role) const {
    const ProjectRow& row = m_rows[index.internalId()];
    switch (role) {
    case Qt::DisplayRole:
    case Qt::EditRole:
        if (index.column() == Eye)
            return {};
        return index.column() == Name ? row.name : row.value;
    case Qt::AccessibleTextRole:
        if (index.column() == Eye)
            return row.visible.value_or(true) ? tr("shown") : tr("hidden");
        return index.column() == Name ? row.name : row.value;
    case Qt::DecorationRole:
        if (index.column() == Name)
            return row.tint ? tintedIcon(row.iconName, *row.tint) : themeIcon(row.iconName);
        if (index.column() == Eye && row.visible)
            return themeIcon(*row.visible ? QStringLiteral("eye") : QStringLiteral("eye-off"));
        return {};
    case Qt::TextAlignmentRole:
        return QVariant(index.column() == Value ? Qt::AlignRight | Qt::AlignVCenter
                                                : Qt::AlignLeft | Qt::AlignVCenter);
    case Qt::ForegroundRole:
        if (index.column() == Value || row.stale)
            return theme().palette.color(QPalette::PlaceholderText);
        return {};
    case Qt::FontRole: {
        QFont font;
        font.setBold(row.strong && index.column() == Name);
        return font;
    }
    default:
        return {};
    }
}

bool ProjectModel::setData(const QModelIndex& index, const QVariant& value, int role) {
    const QString name = value.toString().trimmed();
    if (role != Qt::EditRole || index.column() != Name || name.isEmpty() || name == row(index).name)
        return false;
    Q_EMIT renamed(row(index).id, name);
    return true;
}

Qt::ItemFlags ProjectModel::flags(const QModelIndex& index) const {
    Qt::ItemFlags flags = Qt::ItemIsEnabled | Qt::ItemIsSelectable;
    if (index.isValid() && index.column() == Name && row(index).renamable)
        flags |= Qt::ItemIsEditable;
    return flags;
}

ProjectTree::ProjectTree(ProjectModel* model, QWidget* parent) : QTreeView(parent), m_model(model) {
    setModel(model);
    setHeaderHidden(true);
    setFrameShape(QFrame::NoFrame);
    setViewportMargins(0, 4, 0, 0); // the first row keeps off the dock's title
    setBackgroundRole(QPalette::Base);
    setAutoFillBackground(true);
    setIndentation(14);
    setUniformRowHeights(true);
    setItemDelegate(new RowDelegate(this));
    setEditTriggers(EditKeyPressed);
    setIconSize({16, 16});
    setAccessibleName(tr("Project"));
    header()->setStretchLastSection(false);
    header()->setMinimumSectionSize(24);
    header()->setSectionResizeMode(ProjectModel::Name, QHeaderView::ResizeToContents);
    header()->setSectionResizeMode(ProjectModel::Value, QHeaderView::Stretch);
    header()->setSectionResizeMode(ProjectModel::Eye, QHeaderView::Fixed);
    header()->resizeSection(ProjectModel::Eye, 28);
    connect(model, &QAbstractItemModel::modelReset, this, &QTreeView::expandAll);
    connect(this, &QTreeView::clicked, this, [this](const QModelIndex& index) {
        if (index.column() == ProjectModel::Eye)
            toggle(index);
    });
    connect(this, &QTreeView::doubleClicked, this, [this](const QModelIndex& index) {
        if (index.column() != ProjectModel::Eye)
            Q_EMIT taken(m_model->row(index).id);
    });
    setSelectionMode(ExtendedSelection);
    connect(selectionModel(), &QItemSelectionModel::selectionChanged, this, &ProjectTree::tellChosen);
}

QRect ProjectTree::roomOfValue(const QModelIndex& value) const {
    const QModelIndex name = value.siblingAtColumn(ProjectModel::Name);
    const int margin = style()->pixelMetric(QStyle::PM_FocusFrameHMargin, nullptr, this) + 1;
    QRect room = visualRect(value);
    room.setRight(room.right() - margin);
    room.setLeft(visualRect(name).left() + sizeHintForIndex(name).width() + margin);
    return room;
}

bool ProjectTree::fits(const QModelIndex& value) const {
    return roomOfValue(value).width() >= fontMetrics().horizontalAdvance(value.data().toString());
}

void ProjectTree::toggle(const QModelIndex& index) {
    if (index.isValid() && m_model->row(index).visible)
        Q_EMIT visibilityToggled(m_model->row(index).id);
}

void ProjectTree::tellChosen() {
    if (m_quiet)
        return;
    QStringList ids;
    for (const QModelIndex& index : selectionModel()->selectedRows())
        ids << m_model->row(index).id;
    if (const QString current = selectedId(); ids.removeOne(current))
        ids << current;
    Q_EMIT chosen(ids);
}

void ProjectTree::select(const QStringList& ids) {
    QItemSelection rows;
    for (const QString& id : ids)
        if (const QModelIndex index = m_model->indexOf(id); index.isValid())
            rows.select(index, index.siblingAtColumn(ProjectModel::Eye));
    if (rows.isEmpty())
        return;
    m_quiet = true;
    if (const QModelIndex last = m_model->indexOf(ids.back());
        last.isValid() && last != currentIndex().siblingAtColumn(0))
        setCurrentIndex(last);
    selectionModel()->select(rows, QItemSelectionModel::ClearAndSelect);
    m_quiet = false;
}

QItemSelectionModel::SelectionFlags ProjectTree::selectionCommand(const QModelIndex& index,
                                                                  const QEvent* event) const {
    const auto* mouse =
        event && event->type() == QEvent::MouseButtonPress ? static_cast<const QMouseEvent*>(event) : nullptr;
    if (mouse && mouse->modifiers().testFlag(Qt::AltModifier))
        return QItemSelectionModel::Deselect | QItemSelectionModel::Rows;
    return QTreeView::selectionCommand(index, event);
}

void ProjectTree::rename(const QString& id) {
    const QModelIndex index = m_model->indexOf(id);
    setFocus();
    setCurrentIndex(index);
    edit(index);
}

void ProjectTree::contextMenuEvent(QContextMenuEvent* event) {
    const bool byKey = event->reason() == QContextMenuEvent::Keyboard;
    const QModelIndex index = byKey ? currentIndex() : indexAt(event->pos());
    if (!index.isValid())
        return;
    const QPoint place = byKey ? visualRect(index).bottomLeft() : event->pos();
    Q_EMIT menuRequested(m_model->row(index).id, viewport()->mapToGlobal(place));
}

QString ProjectTree::selectedId() const {
    return currentIndex().isValid() ? m_model->row(currentIndex()).id : QString();
}

void ProjectTree::keyPressEvent(QKeyEvent* event) {
    const bool enter = event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter;
    if (event->key() == Qt::Key_Space)
        toggle(currentIndex());
    else if (enter && state() != EditingState && currentIndex().isValid())
        Q_EMIT taken(selectedId());
    else
        QTreeView::keyPressEvent(event);
}

} // namespace moldwright
