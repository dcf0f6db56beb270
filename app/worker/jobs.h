// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"

#include <string>

namespace moldwright {

/// The jobs of the worker program. Each takes the bytes of a request and returns the bytes of its answer
/// (see exchange/wire.h); none is trusted by the program that asks.

/// Request: switches, V, F. Answer: V, T, as TetGen gives them.
[[nodiscard]] Result<std::string> tetrahedralizeJob(const std::string& request);

/// Request: V, F. Answer: V, F, and the counts of MendedSurface.
[[nodiscard]] Result<std::string> mendJob(const std::string& request);

/// Request: V, F, alpha and offset. Answer: V, F of the skin.
[[nodiscard]] Result<std::string> wrapJob(const std::string& request);

/// Request: path and name of a mesh file. Answer: V, F, the number of notes and the notes.
[[nodiscard]] Result<std::string> readMeshJob(const std::string& request);

} // namespace moldwright
