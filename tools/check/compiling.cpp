#include "check/compiling.hpp"

#include "base/errors.hpp"
#include "base/lines.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <array>
#include <csignal>
#include <sys/resource.h>

namespace course {
namespace fs = std::filesystem;
namespace {

/// Whether the compiler or the linker reported an error at a place in a file: "07.cpp:12:3: error:". A fatal one may
/// stand at any place, unless it's about a file that isn't there or can't be opened.
bool finds_an_error(std::string_view line) {
    if (contains(line, "undefined reference to") || contains(line, "multiple definition of")) return true;
    const auto has = [&](std::string_view mark) {
        const std::size_t at = line.find(mark);
        if (at == line.npos) return false;
        const std::size_t before = line.find_last_not_of("0123456789", at == 0 ? 0 : at - 1);
        return before != line.npos && before + 1 < at && line[before] == ':';
    };
    const bool unopened = line.ends_with("No such file or directory") || line.ends_with("Permission denied")
                          || line.ends_with("No such device or address");
    return has(": error: ") || has(": Error: ") || (unopened && has(": fatal error: "));
}

// The words of the C library for a signal, as the drivers of GCC and Clang print them.
const Words ran_out_of_memory{"out of memory", "memory exhausted", "Cannot allocate memory", "std::bad_alloc"};
const Words wrote_too_much{"File size limit exceeded", "File too large"};
const Words killed{"Killed", "Terminated", "Hangup"};
const Words disk_full{"No space left on device", "Disk quota exceeded"};

/// The files of a rule for make, which writes `\ ` for a blank, `\#` for # and `$$` for $, and ends lines with `\`.
std::vector<std::string> files_of(std::string_view rule) {
    std::vector<std::string> files(1);
    const auto next = [&](std::size_t i) { return i + 1 < rule.size() ? rule[i + 1] : '\0'; };
    rule.remove_prefix(std::min(rule.find(": "), rule.size()));
    for (std::size_t i = 0; i < rule.size(); ++i) {
        const bool escaped =
            (rule[i] == '\\' && (next(i) == ' ' || next(i) == '#')) || (rule[i] == '$' && next(i) == '$');
        if (escaped) files.back() += rule[++i];
        else if (rule[i] == ' ' || rule[i] == '\n' || (rule[i] == '\\' && next(i) == '\n')) files.emplace_back();
        else files.back() += rule[i];
    }
    files.front().clear(); // the colon
    std::erase(files, "");
    return files;
}

bool is_below(const fs::path &file, const fs::path &folder) {
    return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

} // namespace

bool is_about_the_code(const Finished &finished, const std::string &output) {
    const auto lines = split_lines(output);
    return !finished.timed_out
           && std::ranges::any_of(lines, [](const Line &line) { return finds_an_error(line.text); });
}

std::string stopped_by_a_limit(const Finished &finished, const std::string &output) {
    if (finished.timed_out)
        return "The compiler waited for something that never came, and was stopped: does your file include something "
               "that isn't a file?";
    if (finished.code == 0 || is_about_the_code(finished, output)) return {};
    const int signal = finished.code - 128;
    if (signal == SIGXCPU || contains(output, "CPU time limit exceeded"))
        return "The compiler was stopped after " + std::to_string(compiler_limits.processor_time)
               + " s of computing: does a template or a constexpr function never end?";
    if (signal == SIGXFSZ || contains_any(output, wrote_too_much))
        return "The compiler was stopped when the program grew beyond "
               + std::to_string(compiler_limits.file_size >> 20) + " MB: does an array have gigabytes?";
    if (contains_any(output, ran_out_of_memory))
        return "The compiler was stopped when it wanted more than " + std::to_string(compiler_limits.memory >> 30)
               + " GB of memory: does an array have gigabytes, or a template no end?";
    return {};
}

void require_room(const std::string &output, const fs::path &folder) {
    std::error_code unknown;
    const auto room = fs::space(folder, unknown).available;
    if (contains_any(output, disk_full) && !unknown && room < compiler_limits.file_size)
        throw EnvironmentError{"the compiler found the disk full: " + std::to_string(room >> 10)
                               + " KB are free; make some room and try again. Nothing was judged"};
    rlimit memory{};
    if (contains_any(output, ran_out_of_memory) && ::getrlimit(RLIMIT_AS, &memory) == 0
        && memory.rlim_cur < compiler_limits.memory)
        throw EnvironmentError{"this shell gives no program more than " + std::to_string(memory.rlim_cur >> 20)
                               + " MB of memory: type `ulimit -v unlimited`, or use another shell. Nothing was judged"};
}

std::string machine_trouble_in(const Finished &finished, const std::string &output) {
    const int signal = finished.code - 128;
    if (contains_any(output, disk_full))
        return "the compiler found the disk full; make some room and try again. Nothing was judged";
    if (contains_any(output, killed) || signal == SIGKILL || signal == SIGTERM || signal == SIGHUP)
        return "the compiler was killed from outside: has the machine run out of memory? Close some programs and try "
               "again. Nothing was judged";
    return "not even an untouched exercise compiles here now: is there too little memory, disk or processor? Try again "
           "with more. Nothing was judged";
}

std::optional<fs::path> included_from_elsewhere(std::string_view rule, const fs::path &file, const fs::path &from,
                                                const std::vector<fs::path> &allowed) {
    std::error_code ignored;
    std::vector<fs::path> folders;
    for (const fs::path &folder : allowed) folders.push_back(fs::weakly_canonical(folder, ignored));
    const fs::path own = fs::weakly_canonical(file, ignored);
    for (const std::string &name : files_of(rule)) {
        const fs::path read = fs::weakly_canonical(from / name, ignored);
        const auto is_home = [&](const fs::path &folder) { return is_below(read, folder); };
        if (read != own && std::ranges::none_of(folders, is_home)) return read;
    }
    return {};
}

} // namespace course
