// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/autosave.h"

#include "theme/theme.h"
#include "window/lost_work.h"

#include <algorithm>

namespace moldwright {

namespace {

constexpr int pauses = 5; ///< times what a copy takes: so much of the time at least nothing is written

} // namespace

Autosave::Autosave(const Document& document, QObject* parent)
    : QObject(parent), m_document(document), m_folder(std::make_shared<RecoveryFolder>()) {
    m_thread.emplace(QStringLiteral("autosave"));
    m_timer.setSingleShot(true);
    connect(&m_timer, &QTimer::timeout, this, &Autosave::write);
    connect(&document, &Document::historyChanged, this, &Autosave::follow);
}

Autosave::~Autosave() {
    m_thread.reset(); // what it was writing is written
    m_folder->clear();
}

void Autosave::goOnIn(std::shared_ptr<RecoveryFolder> folder) {
    m_thread->post([old = m_folder] { old->clear(); });
    m_folder = std::move(folder);
}

void Autosave::follow() {
    if (m_document.isChanged()) {
        writeSoon();
        return;
    }
    m_timer.stop();
    m_waiting.invalidate();
    m_thread->post([folder = m_folder] { folder->clear(); });
}

void Autosave::writeSoon() {
    if (!m_waiting.isValid())
        m_waiting.start();
    const std::chrono::milliseconds left = longest - std::chrono::milliseconds(m_waiting.elapsed());
    m_timer.start(std::clamp(left, std::chrono::milliseconds(0), m_pause));
}

void Autosave::write() {
    if (m_writing)
        return; // tell() begins anew
    m_writing = true;
    m_waiting.invalidate();
    m_thread->post([this, folder = m_folder, project = m_document.committed(), file = m_document.file(),
                    colours = theme().scene] {
        QElapsedTimer clock;
        clock.start();
        const Result<void> result = folder->write(copyOf(project, file, colours));
        folder->setFailures(0); // what was opened again did not end the program
        QMetaObject::invokeMethod(this, [=, this, took = clock.elapsed()] { tell(result, took); });
    });
}

void Autosave::tell(const Result<void>& result, qint64 milliseconds) {
    m_writing = false;
    m_pause = std::max(quiet, std::chrono::milliseconds(pauses * milliseconds));
    if (result)
        Q_EMIT written();
    else if (!m_failing)
        Q_EMIT failed(result.error());
    m_failing = !result;
    if (m_waiting.isValid() || m_failing)
        writeSoon(); // edits came meanwhile, or the disk has room again
}

} // namespace moldwright
