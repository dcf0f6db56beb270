// SPDX-License-Identifier: AGPL-3.0-or-later
#include "window/recovery.h"

#include <QDir>
#include <QFile>

namespace moldwright {

Recovery::Recovery(QObject* parent) : QObject(parent), m_thread(QStringLiteral("recovery")) {}

Recovery::~Recovery() = default;

void Recovery::look() {
    m_thread.post([this] {
        std::vector<LostWork> found;
        for (const std::shared_ptr<RecoveryFolder>& folder : RecoveryFolder::left())
            found.push_back(readLostWork(folder));
        QMetaObject::invokeMethod(this, [this, found = std::move(found)] {
            m_found.insert(m_found.end(), found.begin(), found.end());
            if (!found.empty())
                Q_EMIT changed();
        });
    });
}

void Recovery::reopen(std::size_t which) {
    const LostWork work = m_found.at(which);
    m_found.erase(m_found.begin() + static_cast<std::ptrdiff_t>(which));
    work.folder->setFailures(work.folder->failures() + 1); // until a copy of it is written again
    Q_EMIT reopened(work);
    Q_EMIT changed();
}

void Recovery::discard(std::size_t which) {
    const LostWork work = m_found.at(which);
    m_found.erase(m_found.begin() + static_cast<std::ptrdiff_t>(which));
    QFile::moveToTrash(work.folder->path());
    work.folder->clear();
    Q_EMIT changed();
}

} // namespace moldwright
