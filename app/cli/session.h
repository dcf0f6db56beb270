// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "base/task.h"
#include "cli/json.h"

#include <optional>
#include <ostream>
#include <string>

namespace moldwright::cli {

/// The options that every command takes.
struct SharedOptions {
    std::string jsonFile; ///< "-" is standard output; empty: no JSON
    int threads = 0;      ///< 0: all cores
    unsigned seed = 1;
    std::optional<double> timeLimit; ///< seconds
    bool quiet = false;
};

/// What a running command works with: its shared options, progress and cancellation, and where words go.
class Session {
public:
    Session(SharedOptions options, Task task) : m_options(std::move(options)), m_task(std::move(task)) {}

    [[nodiscard]] const Task& task() const { return m_task; }
    [[nodiscard]] unsigned seed() const { return m_options.seed; }

    /// Where results are told to a person: standard output; nowhere when --quiet, or when JSON goes there.
    [[nodiscard]] std::ostream& out() const;

    /// Tells what went wrong, or deserves attention, on standard error.
    void tell(const Message& message) const;

    /// Writes `json` where --json wants it; nothing without --json.
    [[nodiscard]] Result<void> writeJson(const Json& json) const;

private:
    SharedOptions m_options;
    Task m_task;
};

} // namespace moldwright::cli
