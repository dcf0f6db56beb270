// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"

#include <cstddef>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace moldwright {

/// A part of a zip archive in memory.
struct ArchiveEntry {
    std::string name;
    std::string bytes;
    bool stored = false; ///< not compressed
};

/// The bytes of a zip archive with these entries in this order; the same input gives the same bytes: every
/// date is 1980-01-01. Errors: Internal.
[[nodiscard]] Result<std::string> archiveBytes(const std::vector<ArchiveEntry>& entries);

/// Reads single parts of a zip archive in memory by name; nothing is ever written to a disk.
class ArchiveReader {
public:
    /// None when `bytes` are no zip archive. They must outlive the reader.
    [[nodiscard]] static std::optional<ArchiveReader> open(const std::string& bytes);

    [[nodiscard]] bool has(const std::string& name) const;

    /// The part, or none when it is missing, damaged (its checksum is tested), or longer than `limit` bytes;
    /// that is counted while inflating, whatever the archive says.
    [[nodiscard]] std::optional<std::string> read(const std::string& name, std::size_t limit) const;

private:
    explicit ArchiveReader(void* archive);
    std::shared_ptr<void> m_archive;
};

} // namespace moldwright
