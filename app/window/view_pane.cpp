// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/view_pane.h"

#include "view/part_view.h"
#include "window/section_bar.h"

#include <QComboBox>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

QFrame* line(QWidget* parent, int height) {
    auto* frame = new QFrame(parent);
    frame->setFixedHeight(height);
    frame->setAutoFillBackground(true);
    frame->setBackgroundRole(QPalette::Window);
    return frame;
}

QComboBox* headerField(const QString& objectName, const QString& accessibleName, const QStringList& items,
                       QWidget* parent) {
    auto* field = new QComboBox(parent);
    field->addItems(items);
    field->setFixedHeight(22);
    field->setSizeAdjustPolicy(QComboBox::AdjustToContents);
    field->setMinimumWidth(60); // in a narrow view they give way
    field->setObjectName(objectName);
    field->setAccessibleName(accessibleName);
    return field;
}

} // namespace

ViewPane::ViewPane(const QString& name, QWidget* parent) : QFrame(parent), m_view(new PartView(this)) {
    setObjectName(name);
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(0, 0, 0, 0);
    column->setSpacing(0);
    m_header = line(this, 26);
    m_mark = line(this, 2);
    column->addWidget(m_header);
    column->addWidget(m_mark);
    m_section = new SectionBar(name, this);
    m_section->hide();
    column->addWidget(m_section);
    column->addWidget(m_view, 1);
    buildHeader(name);
    connect(m_section, &SectionBar::cutChosen, this, [this](const SectionCut& cut) {
        m_settings.cut = cut;
        Q_EMIT touched();
        Q_EMIT settingsChosen();
    });
    connect(m_section, &SectionBar::closed, this, [this] {
        m_settings.cut.reset();
        m_section->hide();
        Q_EMIT touched();
        Q_EMIT settingsChosen();
    });
    m_view->scene().setCubeWords({tr("Front").toStdString(), tr("Back").toStdString(),
                                  tr("Left").toStdString(), tr("Right").toStdString(),
                                  tr("Top").toStdString(), tr("Bottom").toStdString()});
    m_view->installEventFilter(this);
    connect(m_view, &PartView::cameraMoved, this, &ViewPane::refreshHeader);
    refreshHeader();
    setActive(false);
}

void ViewPane::buildHeader(const QString& name) {
    auto* row = new QHBoxLayout(m_header);
    row->setContentsMargins(10, 0, 6, 0);
    row->setSpacing(6);
    m_name = new QLabel(m_header);
    QFont bold = m_name->font();
    bold.setBold(true);
    m_name->setFont(bold);
    row->addWidget(m_name, 1);
    m_content = headerField(name + u"-content"_s, tr("What this view shows"),
                            {tr("Newest shape"), tr("Part as opened"), tr("Compared variant")}, m_header);
    m_mode =
        headerField(name + u"-mode"_s, tr("What the faces of this view show"), displayModeNames(), m_header);
    for (QComboBox* field : {m_content, m_mode}) {
        row->addWidget(field);
        connect(field, &QComboBox::activated, this, &ViewPane::choose);
    }
}

void ViewPane::choose() {
    m_settings.content = static_cast<ViewContent>(m_content->currentIndex());
    m_settings.mode = static_cast<DisplayMode>(m_mode->currentIndex());
    Q_EMIT touched();
    Q_EMIT settingsChosen();
}

void ViewPane::setSettings(const ViewSettings& settings) {
    m_settings = settings;
    m_content->setCurrentIndex(static_cast<int>(settings.content));
    m_mode->setCurrentIndex(static_cast<int>(settings.mode));
    m_section->setVisible(settings.cut.has_value());
    if (settings.cut)
        m_section->setCut(*settings.cut);
}

void ViewPane::setCutRange(double lowest, double highest) {
    m_section->setRange(lowest, highest);
}

void ViewPane::setHeaderShown(bool shown) {
    m_header->setVisible(shown);
    m_mark->setVisible(shown);
}

void ViewPane::setActive(bool active) {
    m_mark->setBackgroundRole(active ? QPalette::Highlight : QPalette::Midlight);
    m_mark->update();
}

QString ViewPane::standpoint() const {
    const QStringList names = {tr("Front"), tr("Back"), tr("Left"), tr("Right"), tr("Top"), tr("Bottom")};
    const int face = scene::faceSeen(m_view->camera());
    return face < 0 ? tr("Free view") : names[face];
}

void ViewPane::refreshHeader() {
    m_name->setText(standpoint());
}

bool ViewPane::eventFilter(QObject* watched, QEvent* event) {
    if (watched == m_view && (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::FocusIn))
        Q_EMIT touched();
    return QFrame::eventFilter(watched, event);
}

} // namespace moldwright
