// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

namespace moldwright {

/// Instruction sets that the inner loops are compiled for; the widest that the processor has is used. All
/// give the same bits: the loops are the same source, and contraction to fused multiply-add is off.
enum class VectorCode { Plain, Avx2, Avx512 };

[[nodiscard]] VectorCode vectorCode();

/// Uses nothing wider than `widest`, so that tests can run every path.
void limitVectorCode(VectorCode widest);

namespace detail {

template <class Body>
[[gnu::flatten]] void runPlain(const Body& body) {
    body();
}
#if defined(__x86_64__)
template <class Body>
[[gnu::flatten, gnu::target("avx2")]] void runAvx2(const Body& body) {
    body();
}
template <class Body>
[[gnu::flatten, gnu::target("avx512f")]] void runAvx512(const Body& body) {
    body();
}
#endif

} // namespace detail

/// Runs body(), with everything that it calls inline, as vector code. The body's loops over lanes become
/// vectors in units compiled with -O3; it must be a plain loop over arrays.
template <class Body>
void inVectorCode(const Body& body) {
#if defined(__x86_64__)
    switch (vectorCode()) {
    case VectorCode::Avx512:
        return detail::runAvx512(body);
    case VectorCode::Avx2:
        return detail::runAvx2(body);
    case VectorCode::Plain:
        break;
    }
#endif
    detail::runPlain(body);
}

} // namespace moldwright
