// SPDX-License-Identifier: AGPL-3.0-or-later
#include "exchange/worker_client.h"

#include "exchange/tetrahedralize.h"
#include "support/folders.h"
#include "support/shapes.h"

#include <gtest/gtest.h>

#include <chrono>
#include <cstdlib>
#include <fstream>
#include <thread>

using namespace moldwright;
namespace fs = std::filesystem;

namespace {

/// A worker that is a shell script, for as long as this lives.
class ScriptedWorker {
public:
    explicit ScriptedWorker(const std::string& script) {
        const fs::path program = m_folder.path() / "worker";
        std::ofstream(program) << "#!/bin/sh\n" << script << "\n";
        fs::permissions(program, fs::perms::owner_all);
        setenv("MOLDWRIGHT_WORKER", program.c_str(), 1); // NOLINT(concurrency-mt-unsafe)
    }
    ~ScriptedWorker() { unsetenv("MOLDWRIGHT_WORKER"); } // NOLINT(concurrency-mt-unsafe)
    ScriptedWorker(const ScriptedWorker&) = delete;
    ScriptedWorker& operator=(const ScriptedWorker&) = delete;

private:
    test::ScratchFolder m_folder;
};

Result<std::string> ask(const WorkerLimits& limits = {}, const Task& task = {}) {
    return askWorker(WorkerJob::Tetrahedralize, std::string(1 << 20, 'x'), limits, task);
}

double secondsOf(const auto& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

void expectWorkerError(const Result<std::string>& answer, const std::string& part) {
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().code, ErrorCode::Worker);
    EXPECT_NE(answer.error().english().find(part), std::string::npos) << answer.error().english();
}

} // namespace

TEST(WorkerClient, AMissingProgramIsNamed) {
    setenv("MOLDWRIGHT_WORKER", "/nowhere/worker", 1); // NOLINT(concurrency-mt-unsafe)
    expectWorkerError(ask(), "/nowhere/worker");
    unsetenv("MOLDWRIGHT_WORKER"); // NOLINT(concurrency-mt-unsafe)
}

TEST(WorkerClient, ACrashIsAValue) {
    const ScriptedWorker worker("kill -SEGV $$");
    expectWorkerError(ask(), "crashed");
}

TEST(WorkerClient, BeingKilledIsAValue) {
    const ScriptedWorker worker("kill -KILL $$");
    expectWorkerError(ask(), "killed");
}

TEST(WorkerClient, NonsenseIsAValue) {
    const ScriptedWorker worker("cat > /dev/null; head -c 5000 /dev/zero | tr '\\0' '\\377'");
    expectWorkerError(ask(), "without an answer");
}

TEST(WorkerClient, AnAnswerWithoutEndIsCutOff) {
    const ScriptedWorker worker("exec cat /dev/zero");
    expectWorkerError(ask({.megabytes = 4, .seconds = 60}), "larger than its limit");
}

TEST(WorkerClient, AWorkerThatStallsIsStoppedInTime) {
    const ScriptedWorker worker("exec sleep 100");
    Result<std::string> answer;
    EXPECT_LT(secondsOf([&] { answer = ask({.megabytes = 64, .seconds = 1}); }), 5);
    expectWorkerError(answer, "stopped after 1 seconds");
}

TEST(WorkerClient, CancellingStopsAStalledWorkerAtOnce) {
    const ScriptedWorker worker("exec sleep 100");
    const Task task;
    std::thread canceller([&] {
        std::this_thread::sleep_for(std::chrono::milliseconds(100));
        task.cancel();
    });
    Result<std::string> answer;
    EXPECT_LT(secondsOf([&] { answer = ask({}, task); }), 3);
    canceller.join();
    ASSERT_FALSE(answer);
    EXPECT_EQ(answer.error().code, ErrorCode::Cancelled);
}

TEST(WorkerClient, TheRealWorkerRefusesAnEmptyRequest) {
    expectWorkerError(askWorker(WorkerJob::Tetrahedralize, "", {}, {}), "asked for nothing");
}
