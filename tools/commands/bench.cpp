// `course dev bench`: what is claimed of the course's speed, measured on this machine, side by side in one run.

#include "base/files.hpp"
#include "base/process.hpp"
#include "check/build_config.hpp"
#include "commands/commands.hpp"

#include <algorithm>
#include <chrono>
#include <fmt/format.h>
#include <iostream>

namespace course {
namespace {

namespace fs = std::filesystem;

double median(std::vector<double> times) {
    std::ranges::sort(times);
    return times[times.size() / 2];
}

/// What the command takes [s].
double time_of(const std::vector<std::string> &command) {
    const auto start = std::chrono::steady_clock::now();
    if (const auto done = run(command); done.code > 1)
        throw UserError{"`" + command.front() + "` failed: " + done.err + done.out};
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// Save to verdict, for a finished solution, against a bare compilation of the same file with the same flags.
void bench_loop(const Workspace &workspace, const Section &section, int runs) {
    workspace.require_solution(section, "There's nothing to measure without them");
    const fs::path object = workspace.build / "loop" / "bench.o", solution = workspace.solution(section);
    const std::vector<std::string> check{(workspace.root / "course").string(), "check", section.name, "--file",
                                         solution.string()};
    const std::vector<std::string> nothing{(workspace.root / "course").string(), "check", "--help"};
    const BuildConfig config = build_config(workspace, section);
    Compiler bare = config.compiler;
    bare.precompiled.clear();
    const auto by = [&](const Compiler &compiler) { return compiler.command(workspace, section, solution, object); };
    std::vector<std::pair<const char *, std::vector<std::string>>> commands{
        {"bare compilation", by(bare)}, {"the same, with the precompiled header", by(config.compiler)}};
    if (config.quick) commands.emplace_back("by Clang, which is asked first", by(*config.quick));
    commands.emplace_back("save to verdict: ./course check", check);
    commands.emplace_back("of which the course program starts and reads", nothing);
    time_of(check); // what a first run alone has to do
    std::vector<std::vector<double>> times(commands.size());
    for (int i = 0; i < runs; ++i) // in turns, so that a busy moment meets all of them
        for (std::size_t each = 0; each < commands.size(); ++each)
            times[each].push_back(time_of(commands[each].second));
    fs::remove(object);
    fmt::print("Section {}, its finished solution; medians of {} runs, and their ratio to the first:\n",
               section.short_number(), runs);
    for (std::size_t each = 0; each < commands.size(); ++each)
        fmt::print("{:<46}{:6.0f} ms   {:.2f}\n", commands[each].first, 1e3 * median(times[each]),
                   median(times[each]) / median(times[0]));
}

/// A section's chapters/NN_slug/bench.cpp, and the subcommand that runs it.
struct Benchmark {
    const char *name, *section, *what;
};
constexpr Benchmark benchmarks[] = {
    {"particles", "particles", "Three pools of particles, against the machine's memory"},
    {"pairs", "nt_collisions", "All pairs of balls compared, against a grid"},
};

/// A section's benchmark prints a table, and writes a trace: cmake/Section.cmake knows how it is built and run.
void bench_program(const Workspace &workspace, const Section &section) {
    workspace.require_solution(section, "The chapter has our numbers");
    std::cout << "This takes about a minute; let the machine do nothing else.\n" << std::flush;
    if (run({"cmake", "--build", workspace.build.string(), "--target", section.name + "_measure"}, {.quiet = false})
            .code)
        throw ExitRequest{something_to};
    std::cout << "The trace is in " << (workspace.build / "bench").string() << '\n';
}

/// The online edition, in Chromium: tests/online/bench.test.mjs.
void bench_page(const Workspace &workspace) {
    std::cout << "This takes some minutes; let the machine do nothing else.\n" << std::flush;
    if (run({(workspace.root / "tests" / "online" / "run").string(), "bench"}, {.quiet = false}).code)
        throw ExitRequest{something_to};
}

} // namespace

void add_bench(CLI::App &app, const Workspace &workspace) {
    CLI::App *command = app.add_subcommand("bench", "Measure how fast the course is on this machine");
    command->require_subcommand(1);
    command->footer("Example: ./course dev bench loop 7");
    auto section = std::make_shared<std::string>("7");
    auto runs = std::make_shared<int>(15);
    CLI::App *loop = command->add_subcommand("loop", "From saving a file to its verdict, against a bare compilation");
    loop->add_option("section", *section, "the section whose solution is judged")->capture_default_str();
    loop->add_option("--runs", *runs, "how often")->check(CLI::Range(1, 1000))->capture_default_str();
    loop->footer("Example: ./course dev bench loop 7 --runs 31");
    loop->callback([&workspace, section, runs] { bench_loop(workspace, workspace.section(*section), *runs); });

    CLI::App *page = command->add_subcommand("page", "What a check in the online edition costs: bytes, time, memory");
    page->footer("Example: ./course dev bench page");
    page->callback([&workspace] { bench_page(workspace); });

    for (const Benchmark &each : benchmarks) {
        CLI::App *program = command->add_subcommand(each.name, each.what);
        program->footer("Example: ./course dev bench " + std::string{each.name});
        program->callback([&workspace, each] { bench_program(workspace, workspace.section(each.section)); });
    }
}

} // namespace course
