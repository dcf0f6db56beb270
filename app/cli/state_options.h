// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "castability/direction_limits.h"
#include "castability/mold_state.h"
#include "cli/json.h"
#include "mesh/indexed_mesh.h"

#include <optional>
#include <string>
#include <vector>

namespace CLI {
class App;
}

namespace moldwright::cli {

/// Options that say where a part is parted and how its halves open. Normals and directions are made unit.
struct StateOptions {
    std::vector<std::string> plane; ///< four numbers, or "auto"
    std::vector<double> d1;
    std::vector<double> d2;
    double draft = 1;

    /// Declares --plane, --d1, --d2 and --draft on `app`; `planeRequired` makes --plane four numbers that
    /// must be given.
    void declare(CLI::App& app, bool planeRequired);

    /// The plane given; none for "auto" or nothing. Errors: Usage.
    [[nodiscard]] Result<std::optional<PartingPlane>> givenPlane() const;

    /// The directions given; none when neither is. Errors: Usage (one alone, or one that does not leave the
    /// plane).
    [[nodiscard]] Result<std::optional<Directions>>
    givenDirections(const std::optional<PartingPlane>& plane) const;

    /// Plane and directions together; directions that are not given are normal to the plane. Errors: Usage
    /// (no plane too).
    [[nodiscard]] Result<MoldState> moldState() const;
};

/// Options that say where removal directions may point.
struct LimitOptions {
    double maxTilt = 30;
    std::vector<double> axis; ///< three numbers, or none
    double cone = 0;

    /// Declares --max-tilt, --axis and --cone on `app`.
    void declare(CLI::App& app);

    /// Errors: Usage (an axis of length zero).
    [[nodiscard]] Result<DirectionLimits> limits() const;
};

/// The plane that was given, with the directions given, or the best ones within the limits. Precondition: a
/// plane was given. Errors: Usage (no direction is allowed there, too).
[[nodiscard]] Result<MoldState> bestStateAt(const StateOptions& state, const LimitOptions& limits,
                                            const IndexedMesh& part);

/// A plane as [nx, ny, nz, o].
[[nodiscard]] Json jsonOf(const PartingPlane& plane);

} // namespace moldwright::cli
