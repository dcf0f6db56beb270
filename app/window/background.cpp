// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/background.h"

#include <exception>

namespace moldwright {

Background::Background(QObject* parent) : QObject(parent), m_thread(QStringLiteral("job")) {}

Background::~Background() {
    m_task.cancel();
}

void Background::start(const QString& words, Work work) {
    Q_ASSERT(!m_busy);
    m_busy = true;
    m_words = words;
    m_clock.start();
    m_task = Task([this](double fraction, const std::string& stage) {
        QMetaObject::invokeMethod(this, [this, fraction, text = QString::fromStdString(stage)] {
            Q_EMIT progressed(fraction, text);
        });
    });
    Q_EMIT started();
    m_thread.post([this, work = std::move(work), task = m_task] {
        Finish finish;
        try {
            finish = work(task);
        } catch (const std::exception& error) {
            const QString what = QString::fromUtf8(error.what());
            finish = [this, what] { Q_EMIT failed(what); };
        }
        QMetaObject::invokeMethod(this, [this, finish = std::move(finish)] {
            m_busy = false;
            if (finish)
                finish();
            Q_EMIT finished();
        });
    });
}

void Background::cancel() {
    m_task.cancel();
}

} // namespace moldwright
