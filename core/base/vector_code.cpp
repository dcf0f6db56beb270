// SPDX-License-Identifier: AGPL-3.0-or-later
#include "base/vector_code.h"

#include <algorithm>
#include <atomic>

namespace moldwright {

namespace {

VectorCode widestOfProcessor() {
#if defined(__x86_64__)
    if (__builtin_cpu_supports("avx512f"))
        return VectorCode::Avx512;
    if (__builtin_cpu_supports("avx2"))
        return VectorCode::Avx2;
#endif
    return VectorCode::Plain;
}

std::atomic<VectorCode> inUse = widestOfProcessor();

} // namespace

VectorCode vectorCode() {
    return inUse.load(std::memory_order_relaxed);
}

void limitVectorCode(VectorCode widest) {
    inUse = std::min(widest, widestOfProcessor());
}

} // namespace moldwright
