// SPDX-License-Identifier: AGPL-3.0-or-later
#include "panels/workflow_bar.h"

#include "panels/step_button.h"
#include "theme/theme.h"

#include <QButtonGroup>
#include <QPainter>
#include <QPainterPath>
#include <QStyleOption>

namespace moldwright {

namespace {

constexpr int chevronWidth = 10;
constexpr int spare = 24; ///< what the bar's own layout takes

/// The sign between two steps.
class Chevron : public QWidget {
public:
    explicit Chevron(QWidget* parent) : QWidget(parent) { setFixedWidth(chevronWidth); }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        painter.setPen(QPen(theme().palette.color(QPalette::Midlight).darker(115), 1.4));
        const double middle = height() / 2.0;
        painter.drawPolyline(QPolygonF({{2.5, middle - 8}, {7.5, middle}, {2.5, middle + 8}}));
    }
};

QFont sized(QFont font, int pixels, bool bold) {
    font.setPixelSize(pixels);
    font.setBold(bold);
    return font;
}

} // namespace

VerdictButton::VerdictButton(QWidget* parent) : QToolButton(parent) {
    setAutoRaise(true);
    setFocusPolicy(Qt::TabFocus);
    setObjectName(QStringLiteral("verdict"));
}

void VerdictButton::setVerdict(Standing standing, const QString& sentence, const QString& reason) {
    m_standing = standing;
    m_sentence = sentence;
    m_reason = reason;
    setAccessibleName(sentence);
    setAccessibleDescription(reason);
    setToolTip(reason);
    updateGeometry();
    update();
}

QSize VerdictButton::sizeHint() const {
    const int words = std::max(QFontMetrics(sized(font(), 13, true)).horizontalAdvance(m_sentence),
                               QFontMetrics(sized(font(), 11, false)).horizontalAdvance(m_reason));
    return {46 + words + 16, 58};
}

QSize VerdictButton::minimumSizeHint() const {
    return {46 + QFontMetrics(sized(font(), 13, true)).horizontalAdvance(m_sentence) + 16, 58};
}

void VerdictButton::paintEvent(QPaintEvent*) {
    QPainter painter(this);
    const Theme& t = theme();
    if (underMouse())
        painter.fillRect(rect().adjusted(1, 4, 0, -3), t.palette.color(QPalette::Midlight));
    painter.setPen(t.palette.color(QPalette::Midlight));
    painter.drawLine(0, 6, 0, height() - 7);
    standingIcon(m_standing).paint(&painter, QRect(14, (height() - 24) / 2, 24, 24));
    painter.setPen(t.palette.color(QPalette::WindowText));
    painter.setFont(sized(font(), 13, true));
    painter.drawText(QRect(46, 12, width() - 46, 17), Qt::AlignLeft | Qt::AlignVCenter, m_sentence);
    painter.setPen(t.palette.color(QPalette::PlaceholderText));
    painter.setFont(sized(font(), 11, false));
    const QString reason = painter.fontMetrics().elidedText(m_reason, Qt::ElideRight, width() - 54);
    painter.drawText(QRect(46, 31, width() - 46, 16), Qt::AlignLeft | Qt::AlignVCenter, reason);
    if (hasFocus()) {
        QStyleOptionFocusRect ring;
        ring.initFrom(this);
        style()->drawPrimitive(QStyle::PE_FrameFocusRect, &ring, &painter, this);
    }
}

WorkflowBar::WorkflowBar(const std::vector<Step>& steps, QWidget* parent) : QToolBar(parent) {
    setObjectName(QStringLiteral("workflow"));
    setWindowTitle(tr("Workflow"));
    setMovable(false);
    setFloatable(false);
    setContextMenuPolicy(Qt::PreventContextMenu);
    setFixedHeight(58);
    auto* group = new QButtonGroup(this);
    for (const Step& step : steps) {
        if (!m_steps.empty())
            addWidget(new Chevron(this));
        auto* button = new StepButton(step.iconName, step.name, this);
        group->addButton(button, static_cast<int>(m_steps.size()));
        m_steps.push_back(button);
        addWidget(button);
    }
    auto* room = new QWidget(this);
    room->setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
    addWidget(room);
    m_verdict = new VerdictButton(this);
    addWidget(m_verdict);
    connect(group, &QButtonGroup::idClicked, this, &WorkflowBar::stepChosen);
    connect(m_verdict, &QToolButton::clicked, this, &WorkflowBar::verdictClicked);
}

void WorkflowBar::setStanding(int step, Standing standing, const QString& words) {
    m_steps[step]->setStanding(standing, words);
    fitSteps();
}

void WorkflowBar::setCurrentStep(int step) {
    m_steps[step]->setChecked(true);
}

void WorkflowBar::setStepsEnabled(bool enabled) {
    for (StepButton* step : m_steps)
        step->setEnabled(enabled);
}

void WorkflowBar::resizeEvent(QResizeEvent* event) {
    QToolBar::resizeEvent(event);
    fitSteps();
}

void WorkflowBar::fitSteps() {
    // A tool bar puts what has not its whole size behind an arrow, and that must never be the verdict.
    int needed = m_verdict->sizeHint().width() + spare;
    for (const StepButton* step : m_steps)
        needed += step->wideWidth() + chevronWidth;
    for (StepButton* step : m_steps)
        step->setNarrow(width() < needed);
}

} // namespace moldwright
