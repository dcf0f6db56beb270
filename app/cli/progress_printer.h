// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include <chrono>
#include <ostream>
#include <string>

namespace moldwright::cli {

/// Shows progress: on a terminal a bar that stays in its line, elsewhere a line at each new stage and at most
/// every ten seconds within one.
class ProgressPrinter {
public:
    ProgressPrinter(std::ostream& out, bool terminal) : m_out(out), m_terminal(terminal) {}

    void show(double fraction, const std::string& stage);

    /// Clears the bar, so that words can follow.
    void finish();

private:
    void showBar(double fraction, const std::string& stage);

    using Clock = std::chrono::steady_clock;
    std::ostream& m_out;
    bool m_terminal;
    bool m_barShown = false;
    std::string m_stage;
    Clock::time_point m_last;
};

} // namespace moldwright::cli
