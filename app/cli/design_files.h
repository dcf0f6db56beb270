// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "cli/json.h"
#include "design/design.h"

#include <filesystem>
#include <string>

namespace moldwright::cli {

/// design.json: what was asked, what came out, and the proof. Keys are a contract.
[[nodiscard]] Json designJson(const std::string& inputFile, const DesignRequest& request,
                              const DesignResult& result);

/// timings.json: seconds a stage; every key of the contract is there.
[[nodiscard]] Json timingsJson(const DesignResult& result);

/// Writes cast.ply, cast.stl, design.json and timings.json into `folder`, which is made when missing.
[[nodiscard]] Result<void> writeDesign(const std::filesystem::path& folder, const std::string& inputFile,
                                       const DesignRequest& request, const DesignResult& result);

} // namespace moldwright::cli
