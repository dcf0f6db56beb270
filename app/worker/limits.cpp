// SPDX-License-Identifier: AGPL-3.0-or-later
#include "worker/limits.h"

#include <csignal>

#include <sys/prctl.h>
#include <sys/resource.h>

namespace moldwright {

namespace {

void limit(__rlimit_resource resource, std::int64_t amount) {
    const rlimit both = {static_cast<rlim_t>(amount), static_cast<rlim_t>(amount)};
    setrlimit(resource, &both);
}

} // namespace

void limitThisProcess(std::int64_t megabytes, std::int64_t seconds) {
    prctl(PR_SET_PDEATHSIG, SIGKILL);
    // Ctrl+C in a terminal reaches every program there; the one that asked decides what becomes of this one.
    std::signal(SIGINT, SIG_IGN);
    limit(RLIMIT_CORE, 0);
    limit(RLIMIT_CPU, seconds);
    if (!sanitized)
        limit(RLIMIT_AS, megabytes << 20);
}

} // namespace moldwright
