// SPDX-License-Identifier: AGPL-3.0-or-later
#include "cli/program.h"

#include "base/parallel.h"
#include "cli/command.h"
#include "cli/interrupt.h"
#include "cli/option_values.h"
#include "cli/progress_printer.h"

#include <CLI/CLI.hpp>

#include <exception>
#include <iostream>
#include <memory>

#include <unistd.h>

namespace moldwright::cli {

namespace {

constexpr const char* description =
    "Moldwright takes a closed mesh to a castable shape and a proved two-piece rigid mold.\n"
    "A parting plane is n·x = o; side 1 is n·x > o, and its half opens along d1. Lengths are\n"
    "in mm, or in the file's own unit where no unit was given; angles are in degrees.";

constexpr const char* exitCodes = "Exit codes:\n"
                                  "  0   done, and the answer is yes\n"
                                  "  1   done, and the answer is no\n"
                                  "  2   wrong usage\n"
                                  "  3   an input cannot be used, or an output cannot be written\n"
                                  "  4   impossible with these choices: an obstruction was named\n"
                                  "  5   cancelled or out of time\n"
                                  "  70  an error inside the program";

constexpr std::size_t optionColumn = 32;

void addSharedOptions(CLI::App& app, SharedOptions& shared) {
    const std::string group = "Options of every command";
    app.add_option("--json", shared.jsonFile, "Write the results as JSON; - is standard output")
        ->type_name("FILE")
        ->group(group);
    app.add_option("--threads", shared.threads,
                   "Use at most N threads; 0 is all cores. Results never depend on it")
        ->type_name("N")
        ->check(atLeast0())
        ->group(group);
    app.add_option("--seed", shared.seed, "Start random choices from N; the default is 1")
        ->type_name("N")
        ->group(group);
    app.add_option("--time-limit", shared.timeLimit, "Stop after this time, with exit code 5")
        ->type_name("SECONDS")
        ->check(above0())
        ->group(group);
    app.add_flag("--quiet", shared.quiet, "Show neither progress nor results, only what went wrong")
        ->group(group);
    app.set_help_flag("-h,--help", "Show this help")->group(group);
}

/// The parsed command line: which action to run, with which options.
struct Request {
    SharedOptions shared;
    Action action;
};

void addCommand(CLI::App& program, const Command& command, Request& request) {
    CLI::App& app = *program.add_subcommand(command.name, command.summary);
    app.footer(command.manual + "\n\n" + exitCodes);
    Action action = command.declare(app);
    addSharedOptions(app, request.shared);
    app.final_callback([&request, action = std::move(action)] { request.action = action; });
}

std::chrono::steady_clock::time_point deadlineAfter(double seconds) {
    using Clock = std::chrono::steady_clock;
    constexpr double longest = 1e9; // 30 years
    return Clock::now() + std::chrono::duration_cast<Clock::duration>(
                              std::chrono::duration<double>(std::min(seconds, longest)));
}

ExitCode run(const Request& request) {
    ProgressPrinter progress(std::cerr, isatty(STDERR_FILENO) != 0);
    const Task task(request.shared.quiet ? Task::Report{} : [&](double fraction, const std::string& stage) {
        progress.show(fraction, stage);
    });
    if (request.shared.timeLimit)
        task.setDeadline(deadlineAfter(*request.shared.timeLimit));
    setThreadCount(request.shared.threads);
    const CancelOnInterrupt cancelOnInterrupt(task);
    const Session session(request.shared, task);
    const Result<ExitCode> result = request.action(session);
    progress.finish();
    if (result)
        return *result;
    session.tell(result.error().message);
    return exitCodeOf(result.error().code);
}

ExitCode parseAndRun(int argc, const char* const* argv) {
    CLI::App program(description, "moldwright-cli");
    program.require_subcommand(1);
    program.get_formatter()->column_width(optionColumn);
    program.set_version_flag("--version", "moldwright-cli " MOLDWRIGHT_VERSION, "Show the version");
    program.set_help_flag("-h,--help", "Show this help");
    program.footer(std::string("moldwright-cli COMMAND --help explains a command.\n\n") + exitCodes);
    program.failure_message([](const CLI::App*, const CLI::Error& error) {
        return std::string("moldwright-cli: ") + error.what() +
               "\nmoldwright-cli COMMAND --help tells what there is.\n";
    });
    Request request;
    for (const Command& command : commands())
        addCommand(program, command, request);
    try {
        program.parse(argc, argv);
    } catch (const CLI::ParseError& stop) {
        return program.exit(stop) == 0 ? ExitCode::Yes : ExitCode::Usage;
    }
    return run(request);
}

} // namespace

int runProgram(int argc, const char* const* argv) {
    try {
        return static_cast<int>(parseAndRun(argc, argv));
    } catch (const std::bad_alloc&) {
        std::cerr << "moldwright-cli: There is not enough memory for this mesh.\n";
    } catch (const std::exception& fault) {
        std::cerr << "moldwright-cli: An error inside the program: " << fault.what() << "\n";
    }
    return static_cast<int>(ExitCode::Internal);
}

} // namespace moldwright::cli
