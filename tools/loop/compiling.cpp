#include "loop/compiling.hpp"

#include "ground/complaint.hpp"
#include "ground/lines.hpp"
#include "ground/text.hpp"

#include <algorithm>
#include <array>
#include <csignal>

namespace course {
namespace fs = std::filesystem;
namespace {

/// Whether something is wrong with the code, whatever else happened: then a file cannot blame the machine by choosing
/// the words of its errors.
bool blames_the_code(std::string_view line) {
    constexpr std::array marks{": error: ", ": fatal error: ", ": Error: "};
    if (contains(line, "undefined reference to") || contains(line, "multiple definition of")) return true;
    return std::ranges::any_of(marks, [&](std::string_view mark) {
        const std::size_t at = line.find(mark);
        return at != line.npos && at > 0 && is_digit(line[at - 1]); // file:12: error:
    });
}

/// Whether the compiler could not write its output. A file cannot say so: the words of its errors stand elsewhere, or
/// more follows them.
bool found_the_disk_full(std::string_view line) {
    constexpr std::string_view mark = ": fatal error: ";
    const std::size_t at = line.find(mark);
    if (at == line.npos || !(line.ends_with("No space left on device") || line.ends_with("Disk quota exceeded")))
        return false;
    const std::string_view what = line.substr(at + mark.size());
    return what.starts_with("error writing to ") || what.starts_with("when writing output to ");
}

// The words of the C library for a signal, as the drivers of GCC and Clang print them.
const Words ran_out_of_memory{"out of memory", "memory exhausted", "Cannot allocate memory", "std::bad_alloc"};
const Words wrote_too_much{"File size limit exceeded", "File too large"};
const Words killed{"Killed", "Terminated", "Hangup"};

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

std::string stopped_by_a_limit(const Finished &finished, const std::string &said) {
    if (finished.timed_out)
        return "The compiler waited for something that never came, and was stopped: does your file include something "
               "that isn't a file?";
    if (finished.code == 0) return {};
    const auto lines = lines_of(said);
    const bool disk_full = std::ranges::any_of(lines, [](const Line &line) { return found_the_disk_full(line.text); });
    if (!disk_full && std::ranges::any_of(lines, [](const Line &line) { return blames_the_code(line.text); }))
        return {};

    const int signal = finished.code - 128;
    if (signal == SIGXCPU || contains(said, "CPU time limit exceeded"))
        return "The compiler was stopped after " + std::to_string(compiler_limits.processor_time)
               + " s of computing: does a template or a constexpr function never end?";
    if (signal == SIGXFSZ || contains_any(said, wrote_too_much))
        return "The compiler was stopped when the program grew beyond "
               + std::to_string(compiler_limits.file_size >> 20) + " MB: does an array have gigabytes?";
    if (contains_any(said, ran_out_of_memory))
        return "The compiler was stopped when it wanted more than " + std::to_string(compiler_limits.memory >> 30)
               + " GB of memory: does an array have gigabytes, or a template no end?";
    if (disk_full || contains(said, "No space left on device") || contains(said, "Disk quota exceeded"))
        throw MachineTrouble{"the compiler found the disk full; make some room and try again. Nothing was judged"};
    if (signal == SIGKILL || signal == SIGTERM || signal == SIGHUP || std::ranges::any_of(lines, [](const Line &line) {
            return contains(line.text, " signal terminated program ") && contains_any(line.text, killed);
        }))
        throw MachineTrouble{"the compiler was killed from outside: has the machine run out of memory? Close some "
                             "programs and try again. Nothing was judged"};
    return {};
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
