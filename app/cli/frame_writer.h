// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "cli/json.h"
#include "design/design.h"

#include <filesystem>

namespace moldwright::cli {

/// Writes the shapes that a design goes through, in the order in which they come: `folder`/0001.ply, …
/// (doubles, mm, part frame), and frames.json with the mold state and the numbers of each.
class FrameWriter {
public:
    explicit FrameWriter(std::filesystem::path folder);

    /// A sink for design(); refers to this object. After a failed write it does nothing.
    [[nodiscard]] FrameSink sink();

    /// Writes the list once the design has ended. Errors: WriteFailed, of a shape or of the list.
    [[nodiscard]] Result<void> finish() const;

private:
    [[nodiscard]] Result<void> write(const DesignFrame& frame);

    std::filesystem::path m_folder;
    Json m_list = Json::array();
    Result<void> m_written;
};

} // namespace moldwright::cli
