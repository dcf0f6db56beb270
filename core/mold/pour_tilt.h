// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "mold/mold_settings.h"

#include <Eigen/Core>

#include <functional>
#include <optional>
#include <string>

namespace moldwright {

/// How far a mold can lean and still be filled, degrees: shop practice, with liquid to the spout's brim.
inline constexpr double mostPourTilt = 30;

/// Up, in the mold's frame (unit), of a mold whose top leans `degrees` towards a way about its axis (see
/// PourTilt). Exactly +y or +z where it does not lean.
[[nodiscard]] Eigen::Vector3d upWhenLeaning(Resting resting, double degrees, double towards);

/// That way in words: "half 1 and the right", by eighths of a turn. English.
[[nodiscard]] std::string leaningWords(Resting resting, double towards);

/// A way to lean and the air that stays then.
struct TiltFound {
    PourTilt tilt;
    double air = 0; ///< mm³
};

/// The way to lean, by eighths of a turn and whole degrees up to mostPourTilt, that leaves least air: by
/// steps of 5° first, then about the best of them; of ways that leave as little but for `negligible` mm³ the
/// one that leans least. `air` gives the mm³ that stay, or an error where the mold cannot be built so; it is
/// called from several threads. None where no way can be built. The same for any number of threads.
[[nodiscard]] std::optional<TiltFound> leastAirTilt(const std::function<Result<double>(const PourTilt&)>& air,
                                                    double negligible);

} // namespace moldwright
