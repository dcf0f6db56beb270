// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/tour.h"

#include "theme/theme.h"

#include <QEvent>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QVBoxLayout>

namespace moldwright {

using namespace Qt::StringLiterals;

namespace {

constexpr int cardWidth = 320;
constexpr int overStatus = 34;

/// A frame about a widget that lets everything through.
class TargetFrame : public QWidget {
public:
    explicit TargetFrame(QWidget* window) : QWidget(window) {
        setAttribute(Qt::WA_TransparentForMouseEvents);
        setFocusPolicy(Qt::NoFocus);
    }

protected:
    void paintEvent(QPaintEvent*) override {
        QPainter painter(this);
        painter.setRenderHint(QPainter::Antialiasing);
        const QPalette& colours = theme().palette;
        painter.setPen(QPen(colours.color(theme().dark ? QPalette::Link : QPalette::Highlight), 2));
        painter.drawRoundedRect(QRectF(rect()).adjusted(1, 1, -1, -1), 4, 4);
    }
};

QLabel* makeLabel(QWidget* parent, int pixels, bool bold) {
    auto* label = new QLabel(parent);
    QFont font = label->font();
    font.setPixelSize(pixels);
    font.setBold(bold);
    label->setFont(font);
    label->setWordWrap(true);
    return label;
}

} // namespace

Tour::Tour(std::vector<TourStep> steps, QWidget* window)
    : QFrame(window), m_steps(std::move(steps)), m_frame(new TargetFrame(window)) {
    setObjectName(u"tour"_s);
    setFrameShape(QFrame::StyledPanel);
    setAutoFillBackground(true);
    setBackgroundRole(QPalette::Base);
    setFixedWidth(cardWidth);
    setAccessibleName(tr("Tour"));
    auto* column = new QVBoxLayout(this);
    column->setContentsMargins(16, 12, 16, 12);
    column->setSpacing(6);
    m_count = makeLabel(this, 11, false);
    m_count->setForegroundRole(QPalette::PlaceholderText);
    m_title = makeLabel(this, 15, true);
    m_text = makeLabel(this, 12, false);
    for (QLabel* label : {m_count, m_title, m_text})
        column->addWidget(label);
    auto* row = new QHBoxLayout;
    row->setSpacing(8);
    auto* end = new QPushButton(tr("End the tour"), this);
    end->setObjectName(u"tour-end"_s);
    m_back = new QPushButton(tr("Back"), this);
    m_back->setObjectName(u"tour-back"_s);
    m_next = new QPushButton(this);
    m_next->setObjectName(u"tour-next"_s);
    row->addWidget(end);
    row->addStretch(1);
    row->addWidget(m_back);
    row->addWidget(m_next);
    column->addSpacing(6);
    column->addLayout(row);
    connect(end, &QPushButton::clicked, this, &Tour::ended);
    connect(m_back, &QPushButton::clicked, this, [this] { go(m_step - 1); });
    connect(m_next, &QPushButton::clicked, this, [this] { go(m_step + 1); });
    window->installEventFilter(this);
    go(0);
    show();
}

Tour::~Tour() {
    delete m_frame;
}

void Tour::go(int step) {
    if (step >= static_cast<int>(m_steps.size())) {
        Q_EMIT ended();
        return;
    }
    m_step = step;
    const TourStep& now = m_steps[static_cast<std::size_t>(step)];
    m_wasDone = now.done();
    const auto count = static_cast<int>(m_steps.size());
    m_count->setText(tr("Step %1 of %2").arg(step + 1).arg(count));
    m_title->setText(now.title);
    m_text->setText(now.text);
    m_back->setEnabled(step > 0);
    m_next->setText(step + 1 < count ? tr("Next") : tr("Finish"));
    place();
}

void Tour::follow() {
    // What was done before the step came up does not end it: one may have gone back to read it.
    if (!m_wasDone && m_steps[static_cast<std::size_t>(m_step)].done())
        go(m_step + 1);
    else
        place();
}

void Tour::place() {
    QWidget* window = parentWidget();
    adjustSize();
    move((window->width() - width()) / 2, window->height() - height() - overStatus);
    const QString& name = m_steps[static_cast<std::size_t>(m_step)].target;
    QWidget* target = name.isEmpty() ? nullptr : window->findChild<QWidget*>(name);
    const bool seen = target && target->isVisible();
    if (seen)
        m_frame->setGeometry(
            QRect(target->mapTo(window, QPoint(0, 0)), target->size()).adjusted(-3, -3, 3, 3));
    m_frame->setVisible(seen);
    m_frame->raise();
    raise();
}

bool Tour::eventFilter(QObject* watched, QEvent* event) {
    if (event->type() == QEvent::Resize || event->type() == QEvent::LayoutRequest)
        QMetaObject::invokeMethod(this, &Tour::place, Qt::QueuedConnection);
    return QFrame::eventFilter(watched, event);
}

void Tour::keyPressEvent(QKeyEvent* event) {
    if (event->key() == Qt::Key_Escape)
        Q_EMIT ended();
    else
        QFrame::keyPressEvent(event);
}

} // namespace moldwright
