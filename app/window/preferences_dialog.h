// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "theme/theme.h"

#include <QDialog>

#include <vector>

class QFormLayout;
class QLabel;
class QLineEdit;
class QVBoxLayout;

namespace moldwright {

class Actions;
class KeyTable;

/// What the user likes, on one page with a search: every choice holds at once, nothing is to be confirmed.
class PreferencesDialog : public QDialog {
    Q_OBJECT
public:
    explicit PreferencesDialog(Actions& actions, QWidget* parent = nullptr);

Q_SIGNALS:
    void themeChosen(moldwright::ThemeChoice choice);
    void languageChosen(const QString& language);
    void navigationChosen(const QString& id);

private:
    /// A row of the page: what it is searched by, and what goes when it does not fit.
    struct Row {
        QString words;
        std::vector<QWidget*> widgets;
        QWidget* section;
    };

    QFormLayout* addSection(const QString& title, QVBoxLayout* column);
    void addRow(QFormLayout* form, const QString& label, QWidget* field, const QString& objectName);
    void addAppearance(QVBoxLayout* column);
    void addDefaults(QVBoxLayout* column);
    void search(const QString& typed);

    std::vector<Row> m_rows;
    QLineEdit* m_search;
    KeyTable* m_keys;
    QLabel* m_nothing;
};

} // namespace moldwright
