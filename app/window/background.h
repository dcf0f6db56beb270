// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/task.h"
#include "window/work_thread.h"

#include <QElapsedTimer>
#include <QObject>

#include <functional>

namespace moldwright {

/// Runs one long job at a time on a thread of its own. A job copies its inputs, computes, and hands back what
/// is to be done with the result on the interface thread.
class Background : public QObject {
    Q_OBJECT
public:
    using Finish = std::function<void()>;
    using Work = std::function<Finish(const Task& task)>;

    explicit Background(QObject* parent = nullptr);
    ~Background() override;

    /// Starts a job; precondition: not busy. `words` says what is going on.
    void start(const QString& words, Work work);

    /// Asks the job to end; its Finish still comes.
    void cancel();

    [[nodiscard]] bool busy() const { return m_busy; }
    [[nodiscard]] const QString& words() const { return m_words; }
    [[nodiscard]] qint64 elapsed() const { return m_clock.elapsed(); }

Q_SIGNALS:
    void started();
    void progressed(double fraction, const QString& stage);
    void finished();
    /// A job threw: a promise inside the program broke.
    void failed(const QString& what);

private:
    Task m_task;
    QString m_words;
    QElapsedTimer m_clock;
    bool m_busy = false;
    WorkThread m_thread;
};

} // namespace moldwright
