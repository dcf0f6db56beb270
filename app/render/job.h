// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "castability/mold_state.h"
#include "project/project.h"

#include <Eigen/Core>

#include <filesystem>
#include <optional>
#include <string>
#include <vector>

namespace moldwright::render {

/// How one surface is drawn.
struct SurfaceLook {
    std::optional<MoldState> state; ///< coloured by draft in it; none: in the part's colour
    double draftDegrees = 1;
    Eigen::Vector3d from{1, -1.7, 0.8}; ///< from the middle towards the eye
    bool seeThrough = false;
    std::vector<Eigen::Vector3d> pins; ///< in the mesh's frame; with a state also their feet on its plane
    std::vector<Eigen::Vector3d> suggested; ///< as suggested pins are drawn
    int width = 320;                        ///< pixels
    int height = 240;
};

/// One order to the program, as JSON: {"task": "report" | "pictures" | "thumbnail", "project": FILE,
/// "out": FILE or folder, "variant": NAME, "language": "de", "width": 320, "height": 240}; or {"task":
/// "surface", "mesh": FILE, "out": FILE} and what of these is wanted: "plane": [nx, ny, nz, offset] with
/// "d1", "d2": [x, y, z] and "draft": degrees; "from": [x, y, z], "see_through": true, "pins" and
/// "suggested": [[x, y, z], …], "width", "height".
struct Job {
    enum class Task { Report, Pictures, Thumbnail, Surface };
    Task task = Task::Report;
    std::filesystem::path source; ///< a project; for Surface a mesh
    std::filesystem::path out;
    int width = 320; ///< of a thumbnail, pixels
    int height = 240;
    SurfaceLook look{};     ///< of a surface
    std::string variant{};  ///< of the project; empty: its current one
    std::string language{}; ///< of a report, as "de"; empty: English
};

/// The project of a job, the wanted variant as the current one. Errors: as openProject(); Usage.
[[nodiscard]] Result<Project> projectOf(const Job& job);

/// Errors: Usage when the text is no job.
[[nodiscard]] Result<Job> readJob(const std::string& json);

/// The text of a job for a project: what a program that orders one writes.
[[nodiscard]] std::string jobText(const Job& job);

} // namespace moldwright::render
