#include "check/which_tests.hpp"

#include "base/files.hpp"
#include "base/hash.hpp"
#include "base/lines.hpp"
#include "base/text.hpp"

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

std::string hash_of_tests(const Workspace &workspace, const Section &section) {
    std::string text = read_file(workspace.tests(section));
    for (const auto &file : files_in(workspace.root / "tests", ".hpp")) text += read_file(file);
    std::erase(text, '\r'); // lines may end with CRLF on Windows
    return sha256(text);
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
    for (const Line &line : split_lines(text))
        if (auto stamp = stamp_on(line.text)) last = std::move(stamp);
    return last;
}

std::string without_stamp(std::string text) {
    const auto lines = with_line_ends(text);
    if (!lines.empty() && stamp_in(lines.back())) text.resize(text.size() - lines.back().size());
    return text;
}

} // namespace course
