// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "panels/figure_table.h"
#include "panels/picture_list.h"

#include <QScrollArea>
#include <QVariant>

#include <map>
#include <set>
#include <variant>
#include <vector>

class QAction;
class QComboBox;
class QLabel;
class QLineEdit;
class QSlider;
class QVBoxLayout;

namespace moldwright {

class QuantitySpinBox;

/// A number with its range; with a slider when it is something one tries out.
struct NumberProperty {
    QString unit;
    double minimum = 0;
    double maximum = 1;
    double step = 1;
    int decimals = 1;
    bool slider = false;
};

/// One of several named choices; the value is the index.
struct ChoiceProperty {
    QStringList choices;
};

/// A short text; what stands in the field while it is empty.
struct TextProperty {
    QString placeholder;
};

/// A measured value with the goal beside it. Values are given as QStringList {value, goal}.
struct ReadingProperty {
    bool withGoal = false;
};

/// Pictures to choose from, across the whole panel; the value is the index, −1 for none.
struct PicturesProperty {
    std::vector<PictureChoice> pictures;
};

/// Figures of several things, across the whole panel; the value is the column chosen. See setColumns().
struct TableProperty {
    QStringList rows;
};

/// One row of the panel.
struct Property {
    QString id;
    QString label;
    QString help;
    std::variant<NumberProperty, ChoiceProperty, TextProperty, ReadingProperty, PicturesProperty,
                 TableProperty>
        kind;
};

/// A section: rows, then paragraphs, then its buttons, two side by side. The first action of a primary
/// section is the filled one. One that folds shows its title alone until that is clicked.
struct PropertySection {
    QString title;
    std::vector<Property> rows;
    std::vector<QAction*> buttons;
    bool primary = false;
    QStringList notes = {};
    bool folds = false; ///< has rows, then
};

struct PropertyPage {
    QString id;
    QString iconName;
    QString title;
    QString owner; ///< what it belongs to, under the title
    std::vector<PropertySection> sections;
    QString layout = {}; ///< another word for the same page: it is laid out anew
};

/// Shows and edits what is selected, made from a table. Values preview while a slider is dragged and are
/// committed once, on release.
class PropertyPanel : public QScrollArea {
    Q_OBJECT
public:
    explicit PropertyPanel(QWidget* parent = nullptr);

    /// Lays out another page; the same page (id and layout) is kept as it is.
    void showPage(const PropertyPage& page, bool evenIfSame = false);
    [[nodiscard]] const QString& pageId() const { return m_pageId; }

    /// Sets what a row shows; tells nobody. A number that is none stands for several that differ.
    void setValue(const QString& id, const QVariant& value);

    /// Sets what a table shows; tells nobody.
    void setColumns(const QString& id, const std::vector<FigureColumn>& columns, int chosen);

    /// A reading's value is written in red while it misses its goal.
    void setMissesGoal(const QString& id, bool misses);
    void setOwner(const QString& words);

Q_SIGNALS:
    void previewed(const QString& id, const QVariant& value);
    void committed(const QString& id, const QVariant& value);
    /// A column of a table was taken, not only chosen.
    void taken(const QString& id, int column);

private:
    struct Row {
        QuantitySpinBox* field = nullptr;
        QSlider* slider = nullptr;
        QComboBox* choice = nullptr;
        QLineEdit* text = nullptr;
        QLabel* reading = nullptr;
        QLabel* goal = nullptr;
        PictureList* pictures = nullptr;
        FigureTable* table = nullptr;
        NumberProperty number;
    };

    [[nodiscard]] QString nameOfFocused() const;
    void addHead(const PropertyPage& page, QVBoxLayout* column);
    void addSection(const PropertySection& section, QVBoxLayout* column);
    void addRows(const std::vector<Property>& rows, QVBoxLayout* column);
    QWidget* makeNumber(const Property& property, const NumberProperty& number, Row& row);
    QWidget* makeChoice(const Property& property, const ChoiceProperty& choice, Row& row);
    QWidget* makeText(const Property& property, const TextProperty& text, Row& row);
    QWidget* makeReading(const ReadingProperty& reading, Row& row);
    QWidget* makePictures(const Property& property, const PicturesProperty& pictures, Row& row);
    QWidget* makeTable(const Property& property, const TableProperty& table, Row& row);
    QWidget* makeEditor(const Property& property, Row& row);
    void connectSlider(const QString& id, const Row& row);

    QString m_pageId;
    QString m_layout;
    std::set<QString> m_unfolded; ///< sections, by their first row
    QLabel* m_owner = nullptr;
    std::map<QString, Row> m_rows;
};

} // namespace moldwright
