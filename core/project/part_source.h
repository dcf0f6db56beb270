// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "project/archive.h"

#include <nlohmann/json_fwd.hpp>

#include <cstddef>
#include <optional>
#include <string>

namespace moldwright {

/// More than the largest honest part of a project file; one that inflates beyond is damaged or hostile.
inline constexpr std::size_t textLimit = std::size_t{4} << 20;
inline constexpr std::size_t meshLimit = std::size_t{1} << 30;

/// The parts of one project file; remembers its name for messages. Errors: BadInput, naming file and part.
class PartSource {
public:
    PartSource(ArchiveReader archive, std::string fileName)
        : m_archive(std::move(archive)), m_fileName(std::move(fileName)) {}

    [[nodiscard]] bool has(const std::string& name) const { return m_archive.has(name); }
    /// Whether all these parts are there.
    [[nodiscard]] Result<void> require(const nlohmann::ordered_json& names) const;

    [[nodiscard]] Result<std::string> bytes(const std::string& name, std::size_t limit) const;
    [[nodiscard]] Result<nlohmann::ordered_json> json(const std::string& name) const;

    /// A binary part through its reader.
    template <class T>
    [[nodiscard]] Result<T> part(const std::string& name,
                                 std::optional<T> (*read)(const std::string&)) const {
        const Result<std::string> raw = bytes(name, meshLimit);
        if (!raw)
            return std::unexpected(raw.error());
        if (std::optional<T> value = read(*raw))
            return *std::move(value);
        return damaged(name);
    }

    /// That a part is missing or cannot be read.
    [[nodiscard]] std::unexpected<Error> damaged(const std::string& part) const;
    [[nodiscard]] const std::string& fileName() const { return m_fileName; }

private:
    ArchiveReader m_archive;
    std::string m_fileName;
};

} // namespace moldwright
