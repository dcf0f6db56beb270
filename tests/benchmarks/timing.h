// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <benchmark/benchmark.h>

#include <algorithm>
#include <chrono>
#include <limits>
#include <string>
#include <vector>

namespace moldwright::bench {

/// Wall-clock time of one call.
template <class Work>
double secondsOf(const Work& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Times one way of ours again and again; counter `best_ms`: what the machine does when left alone.
class Best {
public:
    explicit Best(benchmark::State& state) : m_state(state) {}

    template <class Work>
    void round(const Work& work) {
        const double seconds = secondsOf(work);
        m_state.SetIterationTime(seconds);
        m_best = std::min(m_best, seconds);
        m_state.counters["best_ms"] = 1e3 * m_best;
    }

    [[nodiscard]] double seconds() const { return m_best; }

private:
    benchmark::State& m_state;
    double m_best = std::numeric_limits<double>::infinity();
};

/// Times our way and another one (a peer, or a bound of the machine) in turns, so that both meet the same
/// weather of a shared machine, and compares the best of each: what the machine does when left alone.
class Contest {
public:
    explicit Contest(benchmark::State& state) : m_state(state) {}

    template <class Ours, class Other>
    void round(const Ours& ours, const Other& other) {
        m_ours.push_back(secondsOf(ours));
        m_other.push_back(secondsOf(other));
        m_state.SetIterationTime(m_ours.back());
    }

    /// Counters `best_<unit>`, `<other>_<unit>` and `ratio` = ours over other. `scale`: units of the
    /// counters in a second, over the number of things that a call does.
    void conclude(const std::string& other, const std::string& unit, double scale) {
        const double ours = *std::min_element(m_ours.begin(), m_ours.end());
        const double others = *std::min_element(m_other.begin(), m_other.end());
        m_state.counters["best_" + unit] = ours * scale;
        m_state.counters[other + "_" + unit] = others * scale;
        m_state.counters["ratio"] = ours / others;
    }

private:
    benchmark::State& m_state;
    std::vector<double> m_ours;
    std::vector<double> m_other;
};

} // namespace moldwright::bench
