// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/render_client.h"

#include "cli/json.h"

#include <chrono>
#include <csignal>
#include <cstdlib>
#include <fstream>
#include <iterator>
#include <thread>

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

namespace moldwright::cli {

namespace {

namespace fs = std::filesystem;

/// A folder for the order and the answer, gone with this.
class ExchangeFolder {
public:
    ExchangeFolder() {
        std::string pattern = (fs::temp_directory_path() / "moldwright-render-XXXXXX").string();
        if (mkdtemp(pattern.data()))
            m_path = pattern;
    }
    ~ExchangeFolder() {
        std::error_code ignored;
        if (!m_path.empty())
            fs::remove_all(m_path, ignored);
    }
    ExchangeFolder(const ExchangeFolder&) = delete;
    ExchangeFolder& operator=(const ExchangeFolder&) = delete;

    [[nodiscard]] bool made() const { return !m_path.empty(); }
    [[nodiscard]] std::string file(const char* name) const { return (m_path / name).string(); }
    [[nodiscard]] std::string text(const char* name) const {
        std::ifstream in(file(name));
        std::string all(std::istreambuf_iterator<char>(in), {});
        while (!all.empty() && all.back() == '\n')
            all.pop_back();
        return all;
    }

private:
    fs::path m_path;
};

std::string renderProgram() {
    if (const char* given = std::getenv("MOLDWRIGHT_RENDER")) // NOLINT(concurrency-mt-unsafe)
        return given;
    std::error_code ignored;
    return (fs::read_symlink("/proc/self/exe", ignored).parent_path() / "moldwright-render").string();
}

/// Starts the program on the order in the folder; its words go to files there. 0 when it did not start.
pid_t start(const ExchangeFolder& folder) {
    std::string program = renderProgram();
    std::string order = folder.file("order.json");
    char* arguments[] = {program.data(), order.data(), nullptr};
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    const int flags = O_WRONLY | O_CREAT | O_TRUNC;
    posix_spawn_file_actions_addopen(&actions, STDIN_FILENO, "/dev/null", O_RDONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, folder.file("answer").c_str(), flags, 0600);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, folder.file("complaint").c_str(), flags, 0600);
    pid_t pid = 0;
    if (posix_spawn(&pid, program.c_str(), &actions, nullptr, arguments, environ) != 0)
        pid = 0;
    posix_spawn_file_actions_destroy(&actions);
    return pid;
}

/// Waits for the program, and ends it when the task stops. Its wait status, or none when stopped.
std::optional<int> waitFor(pid_t pid, const Task& task) {
    int status = 0;
    while (waitpid(pid, &status, WNOHANG) == 0) {
        if (task.stopped()) {
            kill(pid, SIGTERM);
            waitpid(pid, &status, 0);
            return std::nullopt;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(20));
    }
    return status;
}

Result<RenderedReport> answerIn(const ExchangeFolder& folder, int status) {
    if (!WIFEXITED(status))
        return failure(ErrorCode::Worker,
                       MW_TEXT("cli", "The report was not written: moldwright-render failed."));
    if (WEXITSTATUS(status) != 0) {
        const std::string complaint = folder.text("complaint");
        const std::string sentence = complaint.substr(complaint.rfind('\n') + 1);
        const ErrorCode code = WEXITSTATUS(status) == 2   ? ErrorCode::Usage
                               : WEXITSTATUS(status) == 3 ? ErrorCode::BadInput
                                                          : ErrorCode::Worker;
        return failure(code, MW_TEXT("cli", "The report was not written. {0}"), {sentence});
    }
    const Json answer = Json::parse(folder.text("answer"), nullptr, false);
    if (!answer.is_object())
        return failure(ErrorCode::Worker, MW_TEXT("cli", "moldwright-render gave no answer."));
    return RenderedReport{answer.value("pages", 0), answer.value("missing", "")};
}

} // namespace

Result<RenderedReport> renderReport(const ReportOrder& order, const Task& task) {
    const ExchangeFolder folder;
    if (!folder.made())
        return failure(ErrorCode::WriteFailed, MW_TEXT("cli", "No temporary folder could be made."));
    std::ofstream(folder.file("order.json")) << Json{{"task", "report"},
                                                     {"project", order.project.string()},
                                                     {"out", order.pdf.string()},
                                                     {"variant", order.variant},
                                                     {"language", order.language}};
    const pid_t pid = start(folder);
    if (pid == 0)
        return failure(ErrorCode::Worker,
                       MW_TEXT("cli", "{0} could not be started. Reports need it beside this program."),
                       {renderProgram()});
    const std::optional<int> status = waitFor(pid, task);
    if (!status)
        return failure(ErrorCode::Cancelled, MW_TEXT("cli", "The report was stopped before it was written."));
    return answerIn(folder, *status);
}

} // namespace moldwright::cli
