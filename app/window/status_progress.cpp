// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/status_progress.h"

#include "window/background.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>

#include <cmath>

namespace moldwright {

namespace {

constexpr int shownAfter = 500; ///< ms

QString elapsedText(qint64 milliseconds) {
    const qint64 seconds = milliseconds / 1000;
    return QStringLiteral("%1:%2").arg(seconds / 60).arg(seconds % 60, 2, 10, QLatin1Char('0'));
}

} // namespace

StatusProgress::StatusProgress(Background& background, QWidget* parent)
    : QWidget(parent), m_background(background) {
    auto* row = new QHBoxLayout(this);
    row->setContentsMargins(6, 0, 6, 0);
    row->setSpacing(8);
    m_bar = new QProgressBar(this);
    m_bar->setTextVisible(false);
    m_bar->setFixedSize(108, 8);
    m_bar->setRange(0, 1000);
    row->addWidget(m_bar);
    m_words = new QLabel(this);
    row->addWidget(m_words);
    m_cancel = new QToolButton(this);
    m_cancel->setText(tr("Cancel"));
    m_cancel->setAutoRaise(true);
    m_cancel->setObjectName(QStringLiteral("cancel-job"));
    row->addWidget(m_cancel);
    hide();
    m_clock.setInterval(100);
    connect(m_cancel, &QToolButton::clicked, &background, &Background::cancel);
    connect(&m_clock, &QTimer::timeout, this, &StatusProgress::tick);
    connect(&background, &Background::started, this, [this] {
        m_bar->setValue(0);
        m_clock.start();
    });
    connect(&background, &Background::progressed, this,
            [this](double fraction) { m_bar->setValue(static_cast<int>(std::lround(1000 * fraction))); });
    connect(&background, &Background::finished, this, [this] {
        if (m_background.busy())
            return;
        m_clock.stop();
        hide();
    });
    if (background.busy())
        m_clock.start();
}

void StatusProgress::tick() {
    if (m_background.elapsed() < shownAfter)
        return;
    m_words->setText(QStringLiteral("%1 %2").arg(m_background.words(), elapsedText(m_background.elapsed())));
    show();
}

} // namespace moldwright
