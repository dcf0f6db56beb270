// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "window/document.h"
#include "window/recovery_folder.h"
#include "window/work_thread.h"

#include <QElapsedTimer>
#include <QObject>
#include <QTimer>

#include <chrono>
#include <memory>
#include <optional>

namespace moldwright {

/// Writes the open project aside as long as it has changes that are in no file: some seconds after the last
/// edit, and now and then while edits go on. On a thread of its own, and never to the project's file. What
/// was written goes once the project is saved, or given up, and when the program ends in order.
class Autosave : public QObject {
    Q_OBJECT
public:
    static constexpr std::chrono::milliseconds quiet{3000};    ///< after the last edit
    static constexpr std::chrono::milliseconds longest{30000}; ///< after the first one

    explicit Autosave(const Document& document, QObject* parent = nullptr);
    ~Autosave() override;

    /// Goes on in the folder of work that is about to be opened again; what is there stays until it is saved.
    void goOnIn(std::shared_ptr<RecoveryFolder> folder);

Q_SIGNALS:
    /// What is open is aside.
    void written();
    /// It could not be; told once until it can again.
    void failed(const moldwright::Error& error);

private:
    void follow();
    void writeSoon();
    void write();
    void tell(const Result<void>& result, qint64 milliseconds);

    const Document& m_document;
    QTimer m_timer;
    QElapsedTimer m_waiting; ///< since the first edit that is not aside
    bool m_writing = false;
    bool m_failing = false;
    std::chrono::milliseconds m_pause = quiet; ///< longer where a copy takes its time
    std::shared_ptr<RecoveryFolder> m_folder;  ///< touched by the thread only
    std::optional<WorkThread> m_thread;
};

} // namespace moldwright
