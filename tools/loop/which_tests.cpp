#include "loop/which_tests.hpp"

#include "ground/files.hpp"
#include "ground/lines.hpp"
#include "ground/process.hpp"
#include "ground/text.hpp"

#include <algorithm>

namespace course {
namespace {

constexpr std::string_view stamp_begins = "// Handed out with tests ";
constexpr std::size_t enough_digits = 12, longest_version = 20;

std::optional<WhichTests> stamp_on(std::string_view line) {
    if (!line.starts_with(stamp_begins) || !line.ends_with(").")) return {};
    line = line.substr(stamp_begins.size(), line.size() - stamp_begins.size() - 2);
    const std::string_view digits = line.substr(0, line.find(" ("));
    if (digits.size() != enough_digits || digits.find_first_not_of("0123456789abcdef") != digits.npos) return {};
    const std::string_view version = line.substr(std::min(digits.size() + 2, line.size()));
    if (version.empty() || version.size() > longest_version || version.find_first_not_of("0123456789.") != version.npos)
        return {};
    return WhichTests{std::string{digits}, std::string{version}};
}

} // namespace

std::string hash_of_tests(const Tree &tree, const Section &section) {
    constexpr const char *script = // lines may end with CRLF on Windows; macOS has only the other program
        "cat -- \"$@\" | tr -d '\\r' | $(command -v sha256sum || echo shasum -a 256)";
    std::vector<std::string> command{"sh", "-c", script, "sh"};
    command.push_back(tree.tests(section).string());
    for (const auto &file : files_in(tree.tests(section).parent_path(), ".hpp")) command.push_back(file.string());
    const Finished done = run(command);
    if (done.code != 0) throw Complaint{"the tests can't be read: " + done.err};
    return done.out.substr(0, 64);
}

WhichTests which_tests(const std::string &hash, const std::string &version) {
    return {hash.substr(0, enough_digits), version};
}

std::string words_for(const WhichTests &tests) {
    return "version " + tests.version + " of the course, tests " + tests.digits;
}

std::string stamp_of(const WhichTests &tests) {
    return std::string{stamp_begins} + tests.digits + " (" + tests.version + ").\n";
}

std::optional<WhichTests> stamp_in(std::string_view text) {
    std::optional<WhichTests> last;
    for (const Line &line : lines_of(text))
        if (auto its = stamp_on(line.text)) last = std::move(its);
    return last;
}

std::string without_stamp(std::string text) {
    const auto lines = with_line_ends(text);
    if (!lines.empty() && stamp_in(lines.back())) text.resize(text.size() - lines.back().size());
    return text;
}

} // namespace course
