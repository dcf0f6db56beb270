// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/progress_printer.h"

#include <algorithm>

namespace moldwright::cli {

using namespace std::chrono_literals;

namespace {

constexpr int barWidth = 30;
constexpr const char* clearLine = "\r\033[K";

int percent(double fraction) {
    return static_cast<int>(100 * std::clamp(fraction, 0.0, 1.0));
}

} // namespace

void ProgressPrinter::show(double fraction, const std::string& stage) {
    const Clock::time_point now = Clock::now();
    const bool newStage = stage != m_stage;
    if (!newStage && now - m_last < (m_terminal ? Clock::duration(100ms) : Clock::duration(10s)))
        return;
    m_last = now;
    m_stage = stage;
    if (m_terminal)
        showBar(fraction, stage);
    else
        m_out << percent(fraction) << " % " << stage << std::endl;
}

void ProgressPrinter::showBar(double fraction, const std::string& stage) {
    const int filled = barWidth * percent(fraction) / 100;
    m_out << clearLine << '[' << std::string(static_cast<std::size_t>(filled), '#')
          << std::string(static_cast<std::size_t>(barWidth - filled), ' ') << "] " << percent(fraction)
          << " % " << stage << std::flush;
    m_barShown = true;
}

void ProgressPrinter::finish() {
    if (m_barShown)
        m_out << clearLine << std::flush;
    m_barShown = false;
}

} // namespace moldwright::cli
