// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QStringList>
#include <QTableWidget>

#include <vector>

namespace moldwright {

/// One thing among others in a table of figures.
struct FigureColumn {
    QString name;
    bool current = false; ///< it is the one that is worked on
    QStringList figures;  ///< one for each row
    int failing = -1;     ///< the row that tells of a failure, written in red; −1 for none

    bool operator==(const FigureColumn&) const = default;
};

/// Figures of several things side by side: a row for each figure, a column for each thing, one of which is
/// chosen by a click or the arrow keys; Return or a double click takes it. As high as its rows.
class FigureTable : public QTableWidget {
    Q_OBJECT
public:
    /// `rows`: names of the figures.
    explicit FigureTable(const QStringList& rows, QWidget* parent = nullptr);

    /// Shows these columns, one of them chosen; tells nobody.
    void setFigures(const std::vector<FigureColumn>& columns, int chosenColumn);

    /// Whether all names and figures are shown whole.
    [[nodiscard]] bool fits() const;

    [[nodiscard]] QSize sizeHint() const override;
    [[nodiscard]] QSize minimumSizeHint() const override { return sizeHint(); }

Q_SIGNALS:
    void chosen(int column);
    void taken(int column);

protected:
    void keyPressEvent(QKeyEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;

private:
    void spread();

    std::vector<FigureColumn> m_columns;
};

} // namespace moldwright
