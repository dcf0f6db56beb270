// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <cstdint>

namespace moldwright {

/// True in builds whose sanitizer reserves terabytes of address space and reports to standard error.
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
constexpr bool sanitized = true;
#else
constexpr bool sanitized = false;
#endif

/// Ties this process down before it touches foreign bytes: address space (unless sanitized), processor time,
/// no core dump, and death together with the program that started it.
void limitThisProcess(std::int64_t megabytes, std::int64_t seconds);

} // namespace moldwright
