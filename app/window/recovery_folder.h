// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "project/project_file.h"

#include <QString>

#include <memory>
#include <vector>

namespace moldwright {

/// Where one program writes aside what is in no file yet: a folder of its own in the user's state folder,
/// with the last copies of the project, each a whole project file. While the program lives it holds a lock on
/// the folder, which the system takes back whatever way it ends: so programs tell the work that was left from
/// each other's. Not for two threads at once.
class RecoveryFolder {
public:
    static constexpr int copiesKept = 3;

    /// A new one. Nothing is on the disk before the first copy.
    RecoveryFolder() = default;
    /// Gives the lock back. The copies stay.
    ~RecoveryFolder();
    RecoveryFolder(const RecoveryFolder&) = delete;
    RecoveryFolder& operator=(const RecoveryFolder&) = delete;

    /// Those with copies whose programs have ended, newest first; they are this program's from now on.
    [[nodiscard]] static std::vector<std::shared_ptr<RecoveryFolder>> left();

    /// In which all of them lie: `$XDG_STATE_HOME/Moldwright/recovery`.
    [[nodiscard]] static QString root();

    /// Empty before the first copy.
    [[nodiscard]] const QString& path() const { return m_path; }

    /// Writes another copy, atomically, and drops those beyond copiesKept. Errors: WriteFailed.
    [[nodiscard]] Result<void> write(const StoredProject& stored);
    /// The copies, newest first: by their numbers, not by the times of the files.
    [[nodiscard]] std::vector<QString> copies() const;
    /// Removes all, from the disk too. The next copy begins another folder.
    void clear();

    /// How often programs ended while they had the folder open, and have another such end counted, or
    /// forgotten.
    [[nodiscard]] int failures() const;
    void setFailures(int count) const;

private:
    [[nodiscard]] bool lock(const QString& path);
    void unlock();
    [[nodiscard]] Result<void> begin();

    QString m_path;
    int m_lock = -1; ///< descriptor of the lock's file
};

} // namespace moldwright
