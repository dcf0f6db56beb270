// SPDX-License-Identifier: AGPL-3.0-or-later
// moldwright-worker JOB MEGABYTES SECONDS: one request on standard input, one answer on standard output.
#include "exchange/wire.h"
#include "exchange/worker_client.h"
#include "worker/jobs.h"
#include "worker/limits.h"

#include <array>
#include <cstdio>
#include <cstdlib>
#include <map>
#include <new>

#include <fcntl.h>
#include <unistd.h>

using namespace moldwright;

namespace {

using Job = Result<std::string> (*)(const std::string&);

const std::map<std::string, Job> jobs = {
    {nameOf(WorkerJob::Tetrahedralize), tetrahedralizeJob},
    {nameOf(WorkerJob::ReadMesh), readMeshJob},
    {nameOf(WorkerJob::Mend), mendJob},
    {nameOf(WorkerJob::Wrap), wrapJob},
};

std::string readAll(int file) {
    std::string bytes;
    std::array<char, 1 << 16> buffer;
    for (ssize_t n = 0; (n = read(file, buffer.data(), buffer.size())) > 0;)
        bytes.append(buffer.data(), static_cast<std::size_t>(n));
    return bytes;
}

bool writeAll(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t n = write(file, bytes.data(), bytes.size());
        if (n < 0)
            return false;
        bytes.remove_prefix(static_cast<std::size_t>(n));
    }
    return true;
}

/// What the libraries print must mix neither with the answer nor with the words of the program that asked.
int takeStandardOutput() {
    const int answers = fcntl(STDOUT_FILENO, F_DUPFD_CLOEXEC, 3);
    const int nowhere = open("/dev/null", O_WRONLY | O_CLOEXEC);
    dup2(nowhere, STDOUT_FILENO);
    if (!sanitized)
        dup2(nowhere, STDERR_FILENO);
    return answers;
}

Result<std::string> run(Job job, const std::string& request) {
    try {
        return job(request);
    } catch (const std::bad_alloc&) {
        return failure(ErrorCode::Worker,
                       MW_TEXT("exchange", "The worker program reached its memory limit on this mesh."));
    }
}

} // namespace

int main(int argc, char** argv) {
    const auto job = argc == 4 ? jobs.find(argv[1]) : jobs.end();
    if (job == jobs.end()) {
        std::fputs("This program works for moldwright and moldwright-cli and is not started by hand.\n",
                   stderr);
        return 2;
    }
    const int answers = takeStandardOutput();
    limitThisProcess(std::strtoll(argv[2], nullptr, 10), std::strtoll(argv[3], nullptr, 10));
    const Result<std::string> result = run(job->second, readAll(STDIN_FILENO));
    WireWriter answer;
    answer.number(result ? 1 : 0);
    if (result)
        answer.text(*result);
    else
        answer.error(result.error());
    // No destructors: a library that broke its heap must not take the answer down with it.
    _exit(writeAll(answers, answer.bytes()) ? 0 : 1);
}
