// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "window/lost_work.h"
#include "window/work_thread.h"

#include <QObject>

#include <vector>

namespace moldwright {

/// Finds work that programs before this one did not come to save, and offers it.
class Recovery : public QObject {
    Q_OBJECT
public:
    explicit Recovery(QObject* parent = nullptr);
    ~Recovery() override;

    /// Looks for it, in the background; changed() follows.
    void look();

    /// What was found and not yet dealt with, newest first.
    [[nodiscard]] const std::vector<LostWork>& found() const { return m_found; }

    /// Hands one of them over by reopened(). Precondition: it could be read.
    void reopen(std::size_t which);
    /// Puts one of them into the desktop's trash, or removes it where there is none.
    void discard(std::size_t which);

Q_SIGNALS:
    void changed();
    void reopened(const moldwright::LostWork& work);

private:
    std::vector<LostWork> m_found;
    WorkThread m_thread;
};

} // namespace moldwright
