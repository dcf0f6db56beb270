// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/interrupt.h"

#include <atomic>
#include <csignal>

namespace moldwright::cli {

namespace {

std::atomic<const Task*> running = nullptr;

/// Only what a signal handler may do: two loads and a store of lock-free atomics.
void cancelRunning(int) {
    if (const Task* task = running.load())
        task->cancel();
}

void handle(int signal, void (*handler)(int), int flags) {
    struct sigaction action = {};
    action.sa_handler = handler;
    action.sa_flags = flags;
    sigaction(signal, &action, nullptr);
}

} // namespace

CancelOnInterrupt::CancelOnInterrupt(Task task) : m_task(std::move(task)) {
    running = &m_task;
    for (const int signal : {SIGINT, SIGTERM})
        handle(signal, cancelRunning, static_cast<int>(SA_RESETHAND) | SA_RESTART);
}

CancelOnInterrupt::~CancelOnInterrupt() {
    for (const int signal : {SIGINT, SIGTERM})
        handle(signal, SIG_DFL, 0);
    running = nullptr;
}

} // namespace moldwright::cli
