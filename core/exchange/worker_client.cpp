// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/worker_client.h"

#include "exchange/wire.h"

#include <array>
#include <cerrno>
#include <chrono>
#include <csignal>
#include <cstdlib>
#include <system_error>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

namespace moldwright {

namespace {

using Clock = std::chrono::steady_clock;

constexpr int pollMilliseconds = 20;

/// A running worker and our end of the socket that is its standard input and output. Never outlives this.
class WorkerProcess {
public:
    WorkerProcess(pid_t pid, int socket) : m_pid(pid), m_socket(socket) {}
    WorkerProcess(const WorkerProcess&) = delete;
    WorkerProcess& operator=(const WorkerProcess&) = delete;
    ~WorkerProcess() {
        if (m_pid > 0)
            kill(m_pid, SIGKILL);
        end();
    }

    [[nodiscard]] int socket() const { return m_socket; }

    /// Closes the socket, waits for the process and returns its wait status.
    int end() {
        if (m_socket >= 0)
            close(std::exchange(m_socket, -1));
        while (m_pid > 0 && waitpid(m_pid, &m_status, 0) < 0 && errno == EINTR) {
        }
        m_pid = -1;
        return m_status;
    }

private:
    pid_t m_pid;
    int m_socket;
    int m_status = 0;
};

std::unexpected<Error> workerFailure(std::string text, std::vector<std::string> arguments = {}) {
    return failure(ErrorCode::Worker, std::move(text), std::move(arguments));
}

std::unexpected<Error> cancelled() {
    return failure(ErrorCode::Cancelled, MW_TEXT("exchange", "Stopped before the end."));
}

std::unexpected<Error> tookTooLong(const WorkerLimits& limits) {
    return workerFailure(MW_TEXT("exchange",
                                 "The worker program was stopped after {0} seconds. A smaller mesh "
                                 "needs less time."),
                         {std::to_string(limits.seconds)});
}

/// Starts the program; its standard input and output are `socket`, which it alone inherits.
int spawn(const std::filesystem::path& program, WorkerJob job, const WorkerLimits& limits, int socket,
          pid_t& pid) {
    std::array<std::string, 4> words = {program.string(), nameOf(job), std::to_string(limits.megabytes),
                                        std::to_string(limits.seconds)};
    std::array<char*, 5> arguments = {words[0].data(), words[1].data(), words[2].data(), words[3].data(),
                                      nullptr};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, socket, STDIN_FILENO);
    posix_spawn_file_actions_adddup2(&actions, socket, STDOUT_FILENO);
    const int failed = posix_spawn(&pid, program.c_str(), &actions, nullptr, arguments.data(), environ);
    posix_spawn_file_actions_destroy(&actions);
    return failed;
}

/// Sends what the socket takes now of `request` from `sent` on; false once the worker needs no more, be it
/// that it has all or that it no longer listens.
bool sendSome(int socket, const std::string& request, std::size_t& sent) {
    const ssize_t n = send(socket, request.data() + sent, request.size() - sent, MSG_NOSIGNAL | MSG_DONTWAIT);
    if (n < 0)
        return errno == EAGAIN || errno == EINTR;
    sent += static_cast<std::size_t>(n);
    if (sent == request.size())
        shutdown(socket, SHUT_WR);
    return sent < request.size();
}

enum class Received { Some, End };

Received receiveSome(int socket, std::string& answer) {
    std::array<char, 1 << 16> buffer;
    const ssize_t n = recv(socket, buffer.data(), buffer.size(), MSG_DONTWAIT);
    if (n > 0)
        answer.append(buffer.data(), static_cast<std::size_t>(n));
    const bool again = n < 0 && (errno == EAGAIN || errno == EINTR);
    return n > 0 || again ? Received::Some : Received::End;
}

/// Sends the request and gathers the answer until the worker closes its end.
Result<std::string> converse(int socket, const std::string& request, const WorkerLimits& limits,
                             const Task& task) {
    const auto end = Clock::now() + std::chrono::seconds(limits.seconds);
    const std::size_t answerLimit = static_cast<std::size_t>(limits.megabytes) << 20;
    std::string answer;
    std::size_t sent = 0;
    bool sending = true;
    while (true) {
        if (task.stopped())
            return cancelled();
        if (Clock::now() > end)
            return tookTooLong(limits);
        pollfd waiting = {socket, static_cast<short>(sending ? POLLIN | POLLOUT : POLLIN), 0};
        if (poll(&waiting, 1, pollMilliseconds) <= 0)
            continue;
        if (sending && (waiting.revents & POLLOUT))
            sending = sendSome(socket, request, sent);
        if ((waiting.revents & (POLLIN | POLLHUP | POLLERR)) && receiveSome(socket, answer) == Received::End)
            return answer;
        if (answer.size() > answerLimit)
            return workerFailure(MW_TEXT("exchange",
                                         "The worker program's answer is larger than its limit of "
                                         "{0} MB."),
                                 {std::to_string(limits.megabytes)});
    }
}

/// What a worker without a whole answer died of.
std::unexpected<Error> causeOfDeath(int status, const WorkerLimits& limits) {
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGXCPU)
        return tookTooLong(limits);
    if (WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL)
        return workerFailure(MW_TEXT("exchange", "The worker program was killed. The computer may be out of "
                                                 "memory."));
    if (WIFSIGNALED(status))
        return workerFailure(MW_TEXT("exchange", "The worker program crashed on this mesh (signal {0})."),
                             {std::to_string(WTERMSIG(status))});
    return workerFailure(MW_TEXT("exchange", "The worker program ended without an answer (code {0})."),
                         {std::to_string(WIFEXITED(status) ? WEXITSTATUS(status) : -1)});
}

} // namespace

const char* nameOf(WorkerJob job) {
    constexpr std::array<const char*, 4> names = {"tetrahedralize", "read-mesh", "mend", "wrap"};
    return names.at(static_cast<std::size_t>(job));
}

std::filesystem::path workerProgram() {
    if (const char* chosen = std::getenv("MOLDWRIGHT_WORKER")) // NOLINT(concurrency-mt-unsafe)
        return chosen;
    std::error_code unknown;
    return std::filesystem::read_symlink("/proc/self/exe", unknown).parent_path() / "moldwright-worker";
}

Result<std::string> askWorker(WorkerJob job, const std::string& request, const WorkerLimits& limits,
                              const Task& task) {
    if (task.stopped())
        return cancelled();
    const std::filesystem::path program = workerProgram();
    std::array<int, 2> ends = {-1, -1};
    pid_t pid = -1;
    int failed = socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) == 0 ? 0 : errno;
    if (failed == 0) {
        failed = spawn(program, job, limits, ends[1], pid);
        close(ends[1]);
        if (failed != 0)
            close(ends[0]);
    }
    if (failed != 0)
        return workerFailure(MW_TEXT("exchange", "The worker program {0} could not be started: {1}."),
                             {program.string(), std::generic_category().message(failed)});
    WorkerProcess worker(pid, ends[0]);
    const Result<std::string> conversation = converse(worker.socket(), request, limits, task);
    if (!conversation)
        return conversation;
    const int status = worker.end();
    WireReader answer(*conversation);
    const bool succeeded = answer.number() == 1;
    if (succeeded)
        if (std::string bytes = answer.text(); answer.whole())
            return bytes;
    Error error = answer.error();
    if (succeeded || !answer.whole())
        return causeOfDeath(status, limits);
    return std::unexpected(std::move(error));
}

} // namespace moldwright
