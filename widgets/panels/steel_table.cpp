// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/steel_table.h"

#include "theme/icons.h"
#include "theme/theme.h"

#include <QEvent>
#include <QHeaderView>
#include <QPainter>

#include <algorithm>
#include <array>
#include <cmath>

namespace moldwright {

namespace {

constexpr int lineHeight = 24;
constexpr int figureWidth = 68;

enum Column { Between, Steel, Asked, Spare };

/// Rounded down: a limit that is missed is never shown as kept.
QString millimetres(double mm) {
    return QStringLiteral("%1 mm").arg(std::floor(100 * mm + 1e-6) / 100, 0, 'f', 2);
}

QString withSign(double mm) {
    const QString figure = QString::number(std::abs(std::floor(100 * mm + 1e-6) / 100), 'f', 2);
    return (mm < 0 ? QChar(0x2212) : QChar(u'+')) + figure;
}

} // namespace

SteelTable::SteelTable(QWidget* parent) : QTableWidget(0, 4, parent) {
    setFrameShape(NoFrame);
    setShowGrid(false);
    setObjectName(QStringLiteral("steel-table"));
    setAccessibleName(tr("Steel between features"));
    setHorizontalHeaderLabels({tr("Between"), tr("Steel"), tr("Limit"), tr("Margin")});
    setSelectionBehavior(SelectRows);
    setSelectionMode(SingleSelection);
    setEditTriggers(NoEditTriggers);
    setTabKeyNavigation(false);
    setIconSize({16, 16});
    verticalHeader()->hide();
    verticalHeader()->setSectionResizeMode(QHeaderView::Fixed);
    verticalHeader()->setDefaultSectionSize(lineHeight);
    QHeaderView* header = horizontalHeader();
    header->setFixedHeight(lineHeight);
    header->setHighlightSections(false);
    header->setSectionsClickable(false);
    header->setSectionResizeMode(Between, QHeaderView::Stretch);
    horizontalHeaderItem(Between)->setTextAlignment(Qt::AlignLeft | Qt::AlignVCenter);
    for (const int column : {Steel, Asked, Spare}) {
        header->setSectionResizeMode(column, QHeaderView::Fixed);
        header->resizeSection(column, figureWidth);
        horizontalHeaderItem(column)->setTextAlignment(Qt::AlignRight | Qt::AlignVCenter);
    }
    connect(this, &QTableWidget::cellClicked, this, &SteelTable::showMe);
    connect(this, &QTableWidget::cellActivated, this, &SteelTable::showMe);
}

void SteelTable::setRows(const std::vector<SteelRow>& rows) {
    if (rows == m_rows)
        return;
    m_rows = rows;
    setRowCount(static_cast<int>(rows.size()));
    for (int row = 0; row < rowCount(); ++row)
        fill(row);
    viewport()->update();
}

void SteelTable::fill(int row) {
    const SteelRow& shown = m_rows[static_cast<std::size_t>(row)];
    const std::array<QString, 4> words = {shown.between, millimetres(shown.steel), millimetres(shown.asked),
                                          withSign(shown.steel - shown.asked)};
    for (int column = 0; column < columnCount(); ++column) {
        auto* cell = new QTableWidgetItem(words[static_cast<std::size_t>(column)]);
        cell->setTextAlignment((column == Between ? Qt::AlignLeft : Qt::AlignRight) | Qt::AlignVCenter);
        if (column == Between)
            cell->setIcon(standingIcon(shown.failing() ? Standing::Failing : Standing::Done));
        if (column == Steel) {
            QFont bold = font();
            bold.setBold(true);
            cell->setFont(bold);
        }
        if (column == Asked)
            cell->setForeground(theme().palette.color(QPalette::PlaceholderText));
        if (shown.failing() && (column == Steel || column == Spare))
            cell->setForeground(theme().error);
        setItem(row, column, cell);
    }
}

void SteelTable::changeEvent(QEvent* event) {
    QTableWidget::changeEvent(event);
    // Icons and colours are the theme's.
    if (event->type() == QEvent::PaletteChange)
        for (int row = 0; row < rowCount(); ++row)
            fill(row);
}

void SteelTable::paintEvent(QPaintEvent* event) {
    QTableWidget::paintEvent(event);
    if (rowCount() > 0)
        return;
    QPainter painter(viewport());
    painter.setPen(theme().palette.color(QPalette::PlaceholderText));
    painter.drawText(viewport()->rect().adjusted(12, 10, -12, 0),
                     Qt::AlignLeft | Qt::AlignTop | Qt::TextWordWrap,
                     tr("The steel between the features of the mold, once it is built or they are placed."));
}

} // namespace moldwright
