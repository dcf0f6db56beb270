// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QString>
#include <QTableWidget>

#include <vector>

namespace moldwright {

/// The steel between two features of a mold.
struct SteelRow {
    QString between;
    double steel = 0; ///< mm; 0: they meet
    double asked = 0; ///< mm

    [[nodiscard]] bool failing() const { return steel < asked - 1e-3; }
    bool operator==(const SteelRow&) const = default;
};

/// The steel between features, row by row: how much there is, how much is asked for, and what is to spare. A
/// click or Return shows where.
class SteelTable : public QTableWidget {
    Q_OBJECT
public:
    explicit SteelTable(QWidget* parent = nullptr);

    void setRows(const std::vector<SteelRow>& rows);
    [[nodiscard]] const std::vector<SteelRow>& rows() const { return m_rows; }

Q_SIGNALS:
    void showMe(int row);

protected:
    void paintEvent(QPaintEvent* event) override;
    void changeEvent(QEvent* event) override;

private:
    void fill(int row);

    std::vector<SteelRow> m_rows;
};

} // namespace moldwright
