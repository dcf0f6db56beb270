// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "project/project.h"

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

namespace moldwright {

/// The further parts of a variant's mold: different parts in one mold. They are the mold's, as its layout is:
/// they stay when the variant's own cast is dropped or its part is moved, a variant's copy has them too, and
/// they go with withPart(). Counted from 0.

/// A part for a mold, with one cavity: the finished cast of a project file, or of a folder that `design`
/// wrote, of the variant that was current there. It goes by the project's name; where that is among `taken`,
/// by the file's or folder's. Errors: as projectAt(); BadInput without a finished cast, naming the file.
[[nodiscard]] Result<TrayPart> readTrayPart(const std::filesystem::path& input,
                                            const std::vector<std::string>& taken);

/// The names of all parts of a tray, the first part's too.
[[nodiscard]] std::vector<std::string> namesTaken(const Tray& tray);

/// The least draft of any face along the direction of its side, degrees. O(m).
[[nodiscard]] double leastDraftDegrees(const CertifiedCast& cast);

/// Edits: pure functions, see edits.h. Numbers are those of further parts that there are.

/// One more, after the others.
[[nodiscard]] Project withFurtherPart(Project project, TrayPart part);
[[nodiscard]] Project withoutFurtherPart(Project project, std::size_t number);
/// Another number of its cavities, from 1 to mostCavities.
[[nodiscard]] Project withFurtherCount(Project project, std::size_t number, int count);
/// An empty name changes nothing.
[[nodiscard]] Project withFurtherName(Project project, std::size_t number, const std::string& name);
/// Its cast as it was read again; name and count stay. One that is the same in every value changes nothing.
[[nodiscard]] Project withFurtherCast(Project project, std::size_t number,
                                      const std::shared_ptr<const CertifiedCast>& cast);

} // namespace moldwright
