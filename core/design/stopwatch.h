// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <map>
#include <string>

namespace moldwright {

/// Adds the wall-clock time of its life to an entry of a table of seconds.
class Stopwatch {
public:
    Stopwatch(std::map<std::string, double>& seconds, std::string entry)
        : m_seconds(seconds), m_entry(std::move(entry)), m_start(std::chrono::steady_clock::now()) {}
    ~Stopwatch() {
        m_seconds[m_entry] +=
            std::chrono::duration<double>(std::chrono::steady_clock::now() - m_start).count();
    }
    Stopwatch(const Stopwatch&) = delete;
    Stopwatch& operator=(const Stopwatch&) = delete;

private:
    std::map<std::string, double>& m_seconds;
    std::string m_entry;
    std::chrono::steady_clock::time_point m_start;
};

} // namespace moldwright
