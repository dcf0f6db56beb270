// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <string>
#include <string_view>

namespace moldwright {

/// SHA-256 of `bytes` as 64 hexadecimal digits (FIPS 180-4): how a report names the file that it speaks of.
[[nodiscard]] std::string sha256(std::string_view bytes);

} // namespace moldwright
