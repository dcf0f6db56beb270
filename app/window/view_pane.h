// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "window/display_mode.h"

#include <QFrame>

class QComboBox;
class QLabel;

namespace moldwright {

class PartView;
class SectionBar;

/// One view with its header: what it looks from, what it shows, and how. Keeps its settings; the picture is
/// made by whoever listens.
class ViewPane : public QFrame {
    Q_OBJECT
public:
    /// `name` is the object's name; the fields of its header are named after it.
    explicit ViewPane(const QString& name, QWidget* parent = nullptr);

    [[nodiscard]] PartView& view() const { return *m_view; }

    [[nodiscard]] const ViewSettings& settings() const { return m_settings; }
    void setSettings(const ViewSettings& settings);

    void setHeaderShown(bool shown);
    /// Between which offsets a section meets what is shown, mm.
    void setCutRange(double lowest, double highest);
    /// The active view is the one that keys and tool bar act on.
    void setActive(bool active);

    /// "Top", or "Free view" when it looks along no axis.
    [[nodiscard]] QString standpoint() const;

Q_SIGNALS:
    /// A hand was laid on this view.
    void touched();
    /// Others were chosen in its header or section bar.
    void settingsChosen();

protected:
    bool eventFilter(QObject* watched, QEvent* event) override;

private:
    void buildHeader(const QString& name);
    void choose();
    void refreshHeader();

    ViewSettings m_settings;
    PartView* m_view;
    QFrame* m_header;
    QFrame* m_mark; ///< the line under the header, in accent when active
    QLabel* m_name;
    QComboBox* m_content;
    QComboBox* m_mode;
    SectionBar* m_section;
};

} // namespace moldwright
