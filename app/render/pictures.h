// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "project/pipeline.h"
#include "render/job.h"

#include <filesystem>

namespace moldwright::render {

/// File names of a report's pictures; a file that is missing is a picture that could not be drawn.
constexpr const char* partPicture = "part.png";
constexpr const char* castPicture = "cast.png";
constexpr const char* draftPicture = "draft.png";
constexpr const char* halvesPicture = "halves.png";
constexpr const char* openedPicture = "opened.png";
constexpr const char* steelPicture = "steel.png";

/// Draws the pictures of a report into `folder`, on white: the part with red undercuts, the cast, its draft
/// map, the halves side by side with their parting faces up, the same painted by the steel behind their
/// walls, and the opened mold; those that the project has. Errors:
/// Internal when this machine cannot draw, WriteFailed.
[[nodiscard]] Result<void> drawReportPictures(const Project& project, const Evaluation& evaluation,
                                              const std::filesystem::path& folder);

/// Draws the picture that stands for a project in lists: the cast, or the part. Errors: as above.
[[nodiscard]] Result<void> drawThumbnail(const Project& project, const std::filesystem::path& file, int width,
                                         int height);

/// Draws one surface on white. Errors: as above.
[[nodiscard]] Result<void> drawSurface(const SharedMesh& mesh, const SurfaceLook& look,
                                       const std::filesystem::path& file);

} // namespace moldwright::render
