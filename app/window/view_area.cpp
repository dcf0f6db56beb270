// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/view_area.h"

#include "view/part_view.h"
#include "window/view_pane.h"

#include <QGridLayout>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QScopedValueRollback>

#include <algorithm>
#include <array>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr int gap = 1;
constexpr std::size_t freeView = 1; ///< of four, the one that looks as the hand turned it

/// Row and column of each of four views: seen from above over seen from the front, as drawings have it.
constexpr std::array<std::array<int, 2>, 4> places = {{{0, 0}, {0, 1}, {1, 0}, {1, 1}}};

std::map<ViewLayout, std::vector<ViewSettings>> firstSettings() {
    const ViewSettings part{.content = ViewContent::Part};
    const ViewSettings mine{.mode = DisplayMode::Difference};
    const ViewSettings other{.content = ViewContent::Compared, .mode = DisplayMode::Difference};
    return {{ViewLayout::One, std::vector<ViewSettings>(1)},
            {ViewLayout::Two, {part, ViewSettings()}},
            {ViewLayout::Compared, {mine, other}},
            {ViewLayout::Four, std::vector<ViewSettings>(4)}};
}

QJsonObject jsonOf(const ViewSettings& settings) {
    return {{u"part"_s, settings.content == ViewContent::Part},
            {u"mode"_s, displayModeCommand(settings.mode)},
            {u"edges"_s, settings.edges},
            {u"seeThrough"_s, settings.seeThrough}};
}

ViewSettings settingsFrom(const QJsonObject& json) {
    ViewSettings settings;
    settings.content = json[u"part"_s].toBool() ? ViewContent::Part : ViewContent::Newest;
    for (int mode = 0; mode < displayModeCount; ++mode)
        if (json[u"mode"_s].toString() == displayModeCommand(static_cast<DisplayMode>(mode)))
            settings.mode = static_cast<DisplayMode>(mode);
    settings.edges = json[u"edges"_s].toBool();
    settings.seeThrough = json[u"seeThrough"_s].toBool();
    return settings;
}

} // namespace

ViewArea::ViewArea(QWidget* parent)
    : QWidget(parent), m_settings(firstSettings()), m_grid(new QGridLayout(this)) {
    m_grid->setContentsMargins(0, 0, 0, 0);
    m_grid->setSpacing(gap);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Midlight);
}

ViewPane* ViewArea::pane(std::size_t number) {
    while (m_panes.size() <= number) {
        auto* made = new ViewPane(u"view-%1"_s.arg(m_panes.size() + 1), this);
        made->hide();
        m_panes.push_back(made);
        connect(made, &ViewPane::touched, this, [this, made] { activate(made); });
        connect(made, &ViewPane::settingsChosen, this, &ViewArea::settingsChanged);
        connect(&made->view(), &PartView::cameraMoved, this, [this, made] { follow(*made); });
        Q_EMIT paneMade(*made);
    }
    return m_panes[number];
}

void ViewArea::keepSettings() {
    std::vector<ViewSettings>& kept = m_settings[m_layout];
    for (std::size_t i = 0; i < m_shown.size(); ++i)
        kept[i] = m_shown[i]->settings();
}

void ViewArea::setViewLayout(ViewLayout layout) {
    if (layout == m_layout)
        return;
    keepSettings();
    const scene::Camera camera = m_active->view().camera();
    m_layout = layout;
    place();
    const QScopedValueRollback together(m_following, true);
    for (ViewPane* shown : m_shown)
        shown->view().followCamera(camera);
    turnToPlaces();
    m_active->view().setFocus();
    Q_EMIT settingsChanged();
    Q_EMIT layoutChanged();
}

void ViewArea::place() {
    for (ViewPane* shown : m_shown) {
        m_grid->removeWidget(shown);
        shown->hide();
    }
    m_shown.clear();
    const auto& settings = m_settings[m_layout];
    for (std::size_t i = 0; i < settings.size(); ++i) {
        ViewPane* shown = pane(i);
        shown->setSettings(settings[i]);
        shown->setHeaderShown(settings.size() > 1);
        m_grid->addWidget(shown, places[i][0], places[i][1]);
        shown->show();
        m_shown.push_back(shown);
    }
    m_grid->activate();
    for (std::size_t i = m_shown.size(); i < m_panes.size(); ++i)
        m_panes[i]->view().scene().setSurface(nullptr, {}); // what is not in sight need not be held
    // Of the part and its cast it is the cast that is worked on, of two variants the current one, of four the
    // view that can be turned.
    activate(m_shown.size() > 1 && m_layout != ViewLayout::Compared ? m_shown[1] : m_shown[0]);
}

void ViewArea::turnToPlaces() {
    if (m_layout != ViewLayout::Four)
        return;
    const std::array<Eigen::Vector3d, 4> from = {Eigen::Vector3d::UnitZ(), Eigen::Vector3d::Zero(),
                                                 -Eigen::Vector3d::UnitY(), Eigen::Vector3d::UnitX()};
    for (std::size_t i = 0; i < m_shown.size(); ++i)
        if (i != freeView)
            m_shown[i]->view().followCamera(scene::lookingFrom(m_shown[i]->view().camera(), from[i]));
}

void ViewArea::lookAtAll() {
    const QScopedValueRollback together(m_following, true);
    for (ViewPane* shown : m_shown)
        shown->view().lookHome(true);
    turnToPlaces();
    fitAll();
}

void ViewArea::fitAll() {
    const QScopedValueRollback fitting(m_following, true);
    double farthest = 0;
    for (ViewPane* shown : m_shown) {
        shown->view().fitAll(true);
        farthest = std::max(farthest, shown->view().camera().distance);
    }
    for (ViewPane* shown : m_shown)
        if (linked()) {
            scene::Camera camera = shown->view().camera();
            camera.distance = farthest;
            shown->view().followCamera(camera);
        }
}

void ViewArea::activate(ViewPane* pane) {
    if (pane == m_active)
        return;
    m_active = pane;
    for (ViewPane* shown : m_shown)
        shown->setActive(shown == pane);
    Q_EMIT activeChanged();
}

void ViewArea::setActiveSettings(const ViewSettings& settings) {
    m_active->setSettings(settings);
    Q_EMIT settingsChanged();
}

void ViewArea::setLinked(bool linked) {
    (m_layout == ViewLayout::Compared ? m_comparedLinked : m_linked) = linked;
    if (linked)
        follow(*m_active);
}

void ViewArea::follow(const ViewPane& moved) {
    if (!linked() || m_following)
        return;
    const QScopedValueRollback following(m_following, true);
    const scene::Camera& camera = moved.view().camera();
    for (ViewPane* shown : m_shown) {
        if (shown == &moved)
            continue;
        scene::Camera same = camera;
        if (m_layout == ViewLayout::Four)
            same.turn = shown->view().camera().turn;
        shown->view().followCamera(same);
    }
}

bool ViewArea::showsPart() const {
    return std::ranges::any_of(
        m_shown, [](const ViewPane* shown) { return shown->settings().content == ViewContent::Part; });
}

QByteArray ViewArea::saved() const {
    QJsonObject all{{u"layout"_s, static_cast<int>(m_layout)}, {u"linked"_s, m_linked}};
    for (const auto& [layout, settings] : m_settings) {
        if (layout == ViewLayout::Compared)
            continue;
        QJsonArray views;
        for (std::size_t i = 0; i < settings.size(); ++i)
            views.append(jsonOf(layout == m_layout ? m_shown[i]->settings() : settings[i]));
        all[u"views-%1"_s.arg(static_cast<int>(layout))] = views;
    }
    return QJsonDocument(all).toJson(QJsonDocument::Compact);
}

void ViewArea::restore(const QByteArray& saved) {
    const QJsonObject all = QJsonDocument::fromJson(saved).object();
    for (auto& [layout, settings] : m_settings) {
        const QJsonArray views = all[u"views-%1"_s.arg(static_cast<int>(layout))].toArray();
        for (std::size_t i = 0; i < settings.size() && i < static_cast<std::size_t>(views.size()); ++i)
            settings[i] = settingsFrom(views[static_cast<qsizetype>(i)].toObject());
    }
    m_linked = all[u"linked"_s].toBool();
    const int layout = all[u"layout"_s].toInt(1);
    if (layout == 1 || layout == 2 || layout == 4)
        m_layout = static_cast<ViewLayout>(layout);
    place();
    Q_EMIT settingsChanged();
}

} // namespace moldwright
