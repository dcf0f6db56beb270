// SPDX-License-Identifier: AGPL-3.0-or-later
#include "report/sha256.h"

#include <array>
#include <bit>
#include <cmath>
#include <cstdint>

namespace moldwright {

namespace {

using Words = std::array<std::uint32_t, 8>;

/// First 32 bits of the fractional part of the cube or square root of the first primes: how the standard
/// defines its constants. Long double holds them with bits to spare.
template <std::size_t N>
std::array<std::uint32_t, N> fractionsOfRoots(long double (*root)(long double)) {
    std::array<std::uint32_t, N> words{};
    std::size_t count = 0;
    for (unsigned candidate = 2; count < N; ++candidate) {
        bool prime = true;
        for (unsigned divisor = 2; divisor * divisor <= candidate; ++divisor)
            prime = prime && candidate % divisor != 0;
        if (!prime)
            continue;
        const long double value = root(static_cast<long double>(candidate));
        words[count++] = static_cast<std::uint32_t>((value - std::floor(value)) * 4294967296.0L);
    }
    return words;
}

void addBlock(Words& state, const unsigned char* block) {
    static const auto constants = fractionsOfRoots<64>([](long double x) { return std::cbrt(x); });
    std::array<std::uint32_t, 64> w{};
    for (std::size_t i = 0; i < 16; ++i)
        for (std::size_t k = 0; k < 4; ++k)
            w[i] = w[i] << 8 | block[4 * i + k];
    for (std::size_t i = 16; i < 64; ++i) {
        const std::uint32_t s0 = std::rotr(w[i - 15], 7) ^ std::rotr(w[i - 15], 18) ^ w[i - 15] >> 3;
        const std::uint32_t s1 = std::rotr(w[i - 2], 17) ^ std::rotr(w[i - 2], 19) ^ w[i - 2] >> 10;
        w[i] = w[i - 16] + s0 + w[i - 7] + s1;
    }
    auto [a, b, c, d, e, f, g, h] = state;
    for (std::size_t i = 0; i < 64; ++i) {
        const std::uint32_t s1 = std::rotr(e, 6) ^ std::rotr(e, 11) ^ std::rotr(e, 25);
        const std::uint32_t t1 = h + s1 + ((e & f) ^ (~e & g)) + constants[i] + w[i];
        const std::uint32_t s0 = std::rotr(a, 2) ^ std::rotr(a, 13) ^ std::rotr(a, 22);
        const std::uint32_t t2 = s0 + ((a & b) ^ (a & c) ^ (b & c));
        h = g;
        g = f;
        f = e;
        e = d + t1;
        d = c;
        c = b;
        b = a;
        a = t1 + t2;
    }
    const Words mixed = {a, b, c, d, e, f, g, h};
    for (std::size_t i = 0; i < 8; ++i)
        state[i] += mixed[i];
}

} // namespace

std::string sha256(std::string_view bytes) {
    std::string padded(bytes);
    padded += '\x80';
    padded.append((64 + 56 - padded.size() % 64) % 64, '\0');
    const std::uint64_t bits = 8 * static_cast<std::uint64_t>(bytes.size());
    for (int shift = 56; shift >= 0; shift -= 8)
        padded += static_cast<char>(bits >> shift & 0xff);
    Words state = fractionsOfRoots<8>([](long double x) { return std::sqrt(x); });
    for (std::size_t at = 0; at < padded.size(); at += 64)
        addBlock(state, reinterpret_cast<const unsigned char*>(padded.data() + at));
    std::string hex;
    for (const std::uint32_t word : state)
        for (int shift = 28; shift >= 0; shift -= 4)
            hex += "0123456789abcdef"[word >> shift & 0xf];
    return hex;
}

} // namespace moldwright
