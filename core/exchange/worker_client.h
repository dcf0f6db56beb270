// SPDX-License-Identifier: AGPL-3.0-or-later
#pragma once

#include "base/result.h"
#include "base/task.h"

#include <cstdint>
#include <filesystem>
#include <string>

namespace moldwright {

/// What one run of the worker program may use.
struct WorkerLimits {
    std::int64_t megabytes = 1024; ///< address space; not enforced in sanitizer builds
    int seconds = 120;             ///< of processor time, and of the clock
};

/// The jobs of the worker program: its first argument.
enum class WorkerJob { Tetrahedralize, ReadMesh, Mend, Wrap };
[[nodiscard]] const char* nameOf(WorkerJob job);

/// Where the worker program lies: environment MOLDWRIGHT_WORKER, else beside the running program.
[[nodiscard]] std::filesystem::path workerProgram();

/// Runs the worker program on one request and returns the bytes of its answer (see WireReader). A worker that
/// cannot be started, crashes, exceeds its limits or answers nonsense is a value too; it is killed when the
/// task stops. Errors: Worker, Cancelled, and whatever the job itself answers.
[[nodiscard]] Result<std::string> askWorker(WorkerJob job, const std::string& request,
                                            const WorkerLimits& limits, const Task& task);

} // namespace moldwright
