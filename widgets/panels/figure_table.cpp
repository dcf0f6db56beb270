// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/figure_table.h"

#include "theme/theme.h"

#include <QHeaderView>
#include <QKeyEvent>
#include <QScrollBar>
#include <QSignalBlocker>

#include <algorithm>

namespace moldwright {

namespace {

constexpr int lineHeight = 24;   ///< px
constexpr int room = 14;         ///< px beside a text in its cell
constexpr int least = 56;        ///< px of a column
constexpr int scrollBarRoom = 4; ///< px between the last row and a scroll bar

QFont textFont(QFont font, bool bold) {
    font.setPixelSize(12);
    font.setBold(bold);
    return font;
}

QTableWidgetItem* plainItem(const QString& text, bool bold, Qt::Alignment alignment) {
    auto* item = new QTableWidgetItem(text);
    item->setFlags(Qt::ItemIsEnabled | Qt::ItemIsSelectable);
    item->setFont(textFont(item->font(), bold));
    item->setTextAlignment(alignment);
    return item;
}

} // namespace

FigureTable::FigureTable(const QStringList& rows, QWidget* parent) : QTableWidget(parent) {
    setFrameShape(NoFrame);
    setStyleSheet(QStringLiteral(
        "QTableView { background: transparent; }"
        "QTableView::item { border: none; border-bottom: 1px solid palette(midlight); padding: 0 4px; }"
        "QTableView::item:selected { background: palette(highlight); color: palette(highlighted-text); }"
        "QHeaderView { background: transparent; }"
        "QHeaderView::section { background: transparent; border: none; padding: 0 4px;"
        " border-bottom: 1px solid palette(midlight); }"
        "QHeaderView::section:vertical { padding-left: 0; }"
        "QTableCornerButton::section { background: transparent; border: none; }"));
    setShowGrid(false);
    setSelectionBehavior(SelectColumns);
    setSelectionMode(SingleSelection);
    setEditTriggers(NoEditTriggers);
    setTabKeyNavigation(false);
    setCornerButtonEnabled(false);
    setVerticalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
    setHorizontalScrollMode(ScrollPerPixel);
    setRowCount(static_cast<int>(rows.size()));
    for (int row = 0; row < rowCount(); ++row)
        setVerticalHeaderItem(row, plainItem(rows[row], false, Qt::AlignLeft | Qt::AlignVCenter));
    for (QHeaderView* header : {verticalHeader(), horizontalHeader()}) {
        header->setFont(textFont(header->font(), false));
        header->setHighlightSections(false);
    }
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setDefaultSectionSize(lineHeight);
    verticalHeader()->setSectionsClickable(false);
    horizontalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    horizontalHeader()->setFixedHeight(lineHeight);
    horizontalHeader()->setMinimumSectionSize(least);
    connect(this, &QTableWidget::currentCellChanged, this, [this](int, int column, int, int before) {
        if (column >= 0 && column != before)
            Q_EMIT chosen(column);
    });
    connect(horizontalHeader(), &QHeaderView::sectionClicked, this,
            [this](int column) { setCurrentCell(std::max(currentRow(), 0), column); });
    connect(this, &QTableWidget::cellDoubleClicked, this, [this](int, int column) { Q_EMIT taken(column); });
    connect(horizontalHeader(), &QHeaderView::sectionDoubleClicked, this, &FigureTable::taken);
}

void FigureTable::setFigures(const std::vector<FigureColumn>& columns, int chosenColumn) {
    const QSignalBlocker quiet(this);
    if (columns != m_columns) {
        m_columns = columns;
        setColumnCount(static_cast<int>(columns.size()));
        for (int c = 0; c < columnCount(); ++c) {
            const FigureColumn& column = columns[static_cast<std::size_t>(c)];
            auto* head = plainItem(column.name, column.current, Qt::AlignRight | Qt::AlignVCenter);
            if (column.current)
                head->setForeground(theme().palette.color(QPalette::Link));
            head->setToolTip(column.current ? tr("%1, the current one").arg(column.name) : column.name);
            setHorizontalHeaderItem(c, head);
            for (int row = 0; row < rowCount(); ++row) {
                auto* cell =
                    plainItem(column.figures.value(row), column.current, Qt::AlignRight | Qt::AlignVCenter);
                if (row == column.failing)
                    cell->setForeground(theme().error);
                cell->setToolTip(column.figures.value(row));
                setItem(row, c, cell);
            }
        }
        spread();
    }
    if (chosenColumn != currentColumn())
        setCurrentCell(std::max(currentRow(), 0), chosenColumn);
}

void FigureTable::spread() {
    // All columns alike, so that figures can be compared along a row.
    int widest = least;
    for (int c = 0; c < columnCount(); ++c) {
        const QFontMetrics bold(textFont(font(), true));
        widest = std::max(widest, bold.horizontalAdvance(horizontalHeaderItem(c)->text()) + room);
        for (int row = 0; row < rowCount(); ++row)
            widest = std::max(widest, bold.horizontalAdvance(item(row, c)->text()) + room);
    }
    const int there = columnCount() > 0 ? viewport()->width() / columnCount() : 0;
    for (int c = 0; c < columnCount(); ++c)
        setColumnWidth(c, std::max(widest, there));
    updateGeometry();
}

bool FigureTable::fits() const {
    for (int c = 0; c < columnCount(); ++c)
        for (int row = 0; row < rowCount(); ++row)
            if (QFontMetrics(item(row, c)->font()).horizontalAdvance(item(row, c)->text()) > columnWidth(c))
                return false;
    for (int row = 0; row < rowCount(); ++row)
        if (QFontMetrics(verticalHeaderItem(row)->font()).horizontalAdvance(verticalHeaderItem(row)->text()) >
            verticalHeader()->width())
            return false;
    return true;
}

QSize FigureTable::sizeHint() const {
    int all = verticalHeader()->width();
    for (int c = 0; c < columnCount(); ++c)
        all += columnWidth(c);
    const int bar = all > width() ? horizontalScrollBar()->sizeHint().height() + scrollBarRoom : 0;
    return {120, (rowCount() + 1) * lineHeight + bar};
}

void FigureTable::resizeEvent(QResizeEvent* event) {
    QTableWidget::resizeEvent(event);
    spread();
}

void FigureTable::keyPressEvent(QKeyEvent* event) {
    if ((event->key() == Qt::Key_Return || event->key() == Qt::Key_Enter) && currentColumn() >= 0)
        Q_EMIT taken(currentColumn());
    else
        QTableWidget::keyPressEvent(event);
}

} // namespace moldwright
