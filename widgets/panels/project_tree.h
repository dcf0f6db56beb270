// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <QAbstractItemModel>
#include <QColor>
#include <QTreeView>

#include <optional>
#include <vector>

namespace moldwright {

/// One row of the project: what it is, its value, and whether it is seen.
struct ProjectRow {
    QString id;      ///< stays the same while the project changes
    int parent = -1; ///< index of the parent among the rows; parents come first
    QString iconName;
    std::optional<QColor> tint = {}; ///< icon in one colour, for sides
    QString name;
    QString value = {};
    std::optional<bool> visible = {}; ///< none: has no eye
    bool strong = false;
    bool stale = false;
    bool renamable = false;

    bool operator==(const ProjectRow&) const = default;
};

/// The project as a tree of name, value and eye. Rows that keep their id keep their place and selection.
class ProjectModel : public QAbstractItemModel {
    Q_OBJECT
public:
    enum Column { Name, Value, Eye, ColumnCount };

    using QAbstractItemModel::QAbstractItemModel;

    void setRows(const std::vector<ProjectRow>& rows);
    [[nodiscard]] const ProjectRow& row(const QModelIndex& index) const { return m_rows[index.internalId()]; }
    [[nodiscard]] QModelIndex indexOf(const QString& id) const;

    [[nodiscard]] QModelIndex index(int row, int column, const QModelIndex& parent = {}) const override;
    [[nodiscard]] QModelIndex parent(const QModelIndex& index) const override;
    [[nodiscard]] int rowCount(const QModelIndex& parent = {}) const override;
    [[nodiscard]] int columnCount(const QModelIndex& = {}) const override { return ColumnCount; }
    [[nodiscard]] QVariant data(const QModelIndex& index, int role) const override;
    bool setData(const QModelIndex& index, const QVariant& value, int role) override;
    [[nodiscard]] Qt::ItemFlags flags(const QModelIndex& index) const override;

Q_SIGNALS:
    void renamed(const QString& id, const QString& name);

private:
    [[nodiscard]] std::vector<int> childrenOf(int parent) const;

    std::vector<ProjectRow> m_rows;
};

/// The tree in the project dock: 24 px rows, value at the right, an eye to show and hide.
class ProjectTree : public QTreeView {
    Q_OBJECT
public:
    ProjectTree(ProjectModel* model, QWidget* parent = nullptr);

    /// Chooses rows, the last one as the current one; tells nobody.
    void select(const QStringList& ids);
    [[nodiscard]] QString selectedId() const;
    /// Where the value of a row is written: what its name leaves.
    [[nodiscard]] QRect roomOfValue(const QModelIndex& value) const;
    /// Whether it is shown whole.
    [[nodiscard]] bool fits(const QModelIndex& value) const;
    /// Begins to rename a row. Precondition: it can be renamed.
    void rename(const QString& id);

Q_SIGNALS:
    /// Rows were clicked or walked to, the current one last: Ctrl toggles one, Shift takes all up to one, Alt
    /// takes one away. None: what was chosen is to stay.
    void chosen(const QStringList& ids);
    void visibilityToggled(const QString& id);
    /// Return or a double click on a row.
    void taken(const QString& id);
    /// The menu of a row is wanted, by the right button or the menu key.
    void menuRequested(const QString& id, const QPoint& place);

protected:
    [[nodiscard]] QItemSelectionModel::SelectionFlags selectionCommand(const QModelIndex& index,
                                                                       const QEvent* event) const override;
    void keyPressEvent(QKeyEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void toggle(const QModelIndex& index);
    void tellChosen();

    ProjectModel* m_model;
    bool m_quiet = false; ///< while rows are chosen by select()
};

} // namespace moldwright
