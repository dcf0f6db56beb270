// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "window/display_mode.h"

#include <QByteArray>
#include <QWidget>

#include <map>
#include <vector>

class QGridLayout;

namespace moldwright {

class ViewPane;

/// How many views there are: one; two beside each other, the part and what becomes of it, or the current
/// variant and one that is compared with it; or four, from above, from the front, from the right, and free.
enum class ViewLayout { One = 1, Two = 2, Compared = 3, Four = 4 };

/// The views of the window. One of them is active: the one that was touched last. Each layout remembers what
/// its views showed and how.
class ViewArea : public QWidget {
    Q_OBJECT
public:
    /// Without views until restore() says which.
    explicit ViewArea(QWidget* parent = nullptr);

    [[nodiscard]] ViewLayout viewLayout() const { return m_layout; }
    void setViewLayout(ViewLayout layout);

    /// All views there are, in sight or not.
    [[nodiscard]] const std::vector<ViewPane*>& made() const { return m_panes; }
    /// The views in sight, the active one among them.
    [[nodiscard]] const std::vector<ViewPane*>& shown() const { return m_shown; }
    [[nodiscard]] ViewPane& active() const { return *m_active; }

    /// While linked, two views move together; of four, place and size follow each other, not the way they
    /// look.
    /// Compared variants have a link of their own, which holds at first.
    void setLinked(bool linked);
    [[nodiscard]] bool linked() const {
        return m_layout == ViewLayout::Compared ? m_comparedLinked : m_linked;
    }

    /// How the active view shows it.
    void setActiveSettings(const ViewSettings& settings);

    /// Whether a view in sight shows the part as it was opened.
    [[nodiscard]] bool showsPart() const;

    /// All views bring everything into sight; lookAtAll() also turns them to where their layout wants them.
    void fitAll();
    void lookAtAll();

    /// Layout and settings of all views, for the next session, but what was compared. What cannot be read is
    /// passed over.
    [[nodiscard]] QByteArray saved() const;
    void restore(const QByteArray& saved);

Q_SIGNALS:
    /// A view was made; it is never taken away.
    void paneMade(moldwright::ViewPane& pane);
    /// Another view is active.
    void activeChanged();
    /// What views show, or which are in sight, is another.
    void settingsChanged();
    void layoutChanged();

private:
    [[nodiscard]] ViewPane* pane(std::size_t number);
    void keepSettings();
    void place();
    void activate(ViewPane* pane);
    void follow(const ViewPane& moved);
    void turnToPlaces();

    ViewLayout m_layout = ViewLayout::One;
    std::map<ViewLayout, std::vector<ViewSettings>> m_settings;
    std::vector<ViewPane*> m_panes; ///< as many as were ever needed
    std::vector<ViewPane*> m_shown;
    ViewPane* m_active = nullptr;
    bool m_linked = false;
    bool m_comparedLinked = true;
    bool m_following = false; ///< views move because one moved
    QGridLayout* m_grid;
};

} // namespace moldwright
