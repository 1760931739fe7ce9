#include "loop/answer.hpp"

#include "ground/files.hpp"
#include "ground/lines.hpp"

#include <vector>

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr std::uintmax_t longest = 1'000'000; // [bytes] a hundred times a long answer

const char *name_of(fs::file_type type) {
    switch (type) {
    case fs::file_type::directory: return "a folder";
    case fs::file_type::block:
    case fs::file_type::character: return "a device";
    case fs::file_type::fifo: return "a pipe";
    case fs::file_type::socket: return "a socket";
    default: return "no file with text";
    }
}

/// `x.hpp` of the line `#include "../y/x.hpp"`; nothing of any other line.
std::string_view included(std::string_view line) {
    line = without_blanks(line);
    if (!line.starts_with('#')) return {};
    line = without_blanks(line.substr(1));
    if (!line.starts_with("include")) return {};
    line = without_blanks(line.substr(7));
    if (!line.starts_with('"')) return {};
    const std::string_view name = line.substr(1, line.find('"', 1) - 1);
    return name.substr(name.rfind('/') + 1); // npos + 1 is 0
}

} // namespace

std::string read_answer(const fs::path &file) {
    std::error_code ignored;
    const fs::file_status status = fs::status(file, ignored);
    if (fs::exists(status) && !fs::is_regular_file(status))
        throw Complaint{file.string() + " is " + name_of(status.type()) + ", not a file with answers"};
    if (const auto size = fs::file_size(file, ignored); !ignored && size > longest)
        throw Complaint{file.string() + " has " + std::to_string(size / 1000)
                        + " KB, too much for a file with answers: at most " + std::to_string(longest / 1000)
                        + " are read"};
    return read_file(file);
}

std::optional<Verdict> diagnose_section(std::string_view text, const std::string &name, const Tree &tree,
                                        const Section &section) {
    std::optional<Verdict> verdict;
    const std::vector<Section> all = tree.sections();
    int number = 0;
    for (const auto &line : lines_of(text)) {
        ++number;
        const std::string_view header = included(line.text);
        if (header.empty()) continue;
        if (header == section.slug() + ".hpp") return {};
        for (const Section &other : all) {
            if (verdict || header != other.slug() + ".hpp") continue;
            verdict = Verdict{.kind = Kind::does_not_compile,
                              .sentence = "This file answers section " + other.short_number() + ", for it includes \""
                                          + std::string{header} + "\": ./course check " + other.short_number()
                                          + " judges it. An answer to section " + section.short_number()
                                          + " includes \"" + section.slug() + ".hpp\".",
                              .file = name,
                              .line = number};
        }
    }
    return verdict;
}

} // namespace course
