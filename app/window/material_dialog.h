// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "materials/material_table.h"

#include <QDialog>
#include <QTimer>

#include <string>
#include <vector>

class QLabel;
class QListWidget;
class QPushButton;

namespace moldwright {

class MaterialForm;

/// The table of materials: the program's, and the user's own, which are added, changed and removed here. What
/// is typed holds at once, as a file of the user's; a changed material of the program becomes the user's own,
/// and is as it was when that is removed.
class MaterialDialog : public QDialog {
    Q_OBJECT
public:
    explicit MaterialDialog(MaterialPlaces places, QWidget* parent = nullptr);

    void done(int result) override;

Q_SIGNALS:
    void tableChanged();

private:
    QWidget* makeList();
    QWidget* makeDetails();
    void load(const std::string& chosen);
    void showChosen();
    void keep();
    void addNew();
    void removeChosen();
    [[nodiscard]] bool isOwn(const std::string& id) const;
    void tell(const QString& words, bool failing);
    void tellStanding();

    MaterialPlaces m_places;
    std::vector<Material> m_table;
    std::vector<Material> m_own;
    Material m_chosen; ///< as it is kept
    QListWidget* m_list = nullptr;
    MaterialForm* m_form = nullptr;
    QPushButton* m_remove = nullptr;
    QLabel* m_told = nullptr;
    QTimer m_typing;
};

} // namespace moldwright
