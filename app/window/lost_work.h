// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "scene/colours.h"
#include "window/recovery_folder.h"

#include <QDateTime>
#include <QImage>
#include <QString>

#include <memory>
#include <string>

namespace moldwright {

/// Work of a program that ended before it was saved.
struct LostWork {
    std::shared_ptr<RecoveryFolder> folder;
    std::shared_ptr<const Project> project; ///< null where it cannot be read
    QString name;
    QString file; ///< that it was opened from or saved to; empty for none
    QDateTime when;
    QImage picture;
};

/// A project as it is written aside: with its file, the time now, and a picture of its shape in these
/// colours.
[[nodiscard]] StoredProject copyOf(const Project& project, const QString& file,
                                   const scene::SceneColours& colours);

/// The newest whole copy in a folder. Where none can be read, or where that ended the program twice, one
/// without a project.
[[nodiscard]] LostWork readLostWork(const std::shared_ptr<RecoveryFolder>& folder);

} // namespace moldwright
