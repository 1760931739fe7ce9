#include "base/workspace.hpp"

#include "base/files.hpp"
#include "base/nearest.hpp"
#include "base/plain.hpp"
#include "base/text.hpp"

#include <algorithm>
#include <regex>
#include <sstream>

namespace course {
namespace fs = std::filesystem;
namespace {

/// "Segment intersection" and "segment-intersection" mean segment_intersection.
std::string plain(std::string_view words) {
    std::string result = lower(words);
    std::ranges::replace_if(
        result, [](char c) { return c == ' ' || c == '-'; }, '_');
    return result;
}

/// Whether a path leads to a file or folder of the section: exercises/07_x.cpp, chapters/07_x/, plots/07_x_y.gp.
bool leads_to(const fs::path &path, const Section &section) {
    return std::ranges::any_of(path, [&](const fs::path &part) {
        const std::string stem = part.stem().string();
        return stem == section.name || stem.starts_with(section.name + "_");
    });
}

std::string list_of(const std::vector<Section> &sections) {
    std::string result;
    for (std::size_t i = 0; i < sections.size(); ++i)
        result += (i == 0 ? "" : i + 1 == sections.size() ? " or " : ", ") + sections[i].name;
    return result;
}

/// " Did you mean `07_segment_intersection`?": the section with the name, or the word in it, that is nearest to what
/// was typed; for a number, the nearest number.
std::string did_you_mean_section(const std::string &typed, const std::vector<Section> &sections) {
    Section best = sections.front();
    if (!typed.empty() && is_digit(typed[0]) && typed.size() < 5) {
        const auto away = [number = std::stoi(typed)](const Section &s) { return std::abs(s.number() - number); };
        for (const Section &s : sections)
            if (away(s) < away(best)) best = s;
    } else {
        std::vector<std::string> words;
        for (const Section &s : sections) {
            words.insert(words.end(), {s.name, s.slug()});
            std::istringstream parts{s.slug()};
            for (std::string part; std::getline(parts, part, '_');) words.push_back(part);
        }
        const std::string word = nearest(typed, words);
        if (word.empty()) return "";
        for (const Section &s : sections)
            if (s.name.find(word) != std::string::npos) best = s;
    }
    return " Did you mean `" + best.name + "`?";
}

} // namespace

std::optional<Section> section_added_by(const std::string &line) {
    static const std::regex call{R"(^[ \t]*section\([ \t]*(\d\d_[a-z][a-z0-9_]*)[ \t)])"};
    std::smatch match;
    return std::regex_search(line, match, call) ? std::optional{Section{match[1]}} : std::nullopt;
}

std::vector<Section> Workspace::sections() const {
    std::vector<Section> result;
    std::istringstream text{read_file(root / "CMakeLists.txt")};
    for (std::string line; std::getline(text, line);)
        if (const auto section = section_added_by(line)) result.push_back(*section);
    return result;
}

Section Workspace::section(std::string_view words) const {
    const std::vector<Section> all = sections();
    if (all.empty())
        throw UserError{"CMakeLists.txt names no section; a line like section(07_segment_intersection) does"};

    static const std::regex number{R"(0*(\d{1,2})(\.\d+)?)"};
    std::vector<Section> meant;
    const auto those = [&](const auto &fits) {
        if (meant.empty()) std::ranges::copy_if(all, std::back_inserter(meant), fits);
    };
    const std::string typed{words}, part = plain(words);
    std::smatch match;
    const bool is_number = words.size() < 10 && std::regex_match(typed, match, number);
    if (is_number) {
        those([&](const Section &s) { return s.short_number() == match[1]; });
    } else if (!part.empty()) {
        those([&](const Section &s) { return part == s.name || part == s.slug() || leads_to(typed, s); });
        those([&](const Section &s) { return s.name.find(part) != std::string::npos; });
    }
    if (meant.size() == 1) return meant.front();
    if (meant.size() > 1)
        throw UserError{"`" + typed + "` may be " + list_of(meant) + ": type its number, or more of its name"};
    throw UnknownSection{"there is no section `" + typed + "`." + did_you_mean_section(part, all)
                             + " `./course list` shows them all",
                         is_number ? std::stoi(match[1]) : 0};
}

std::string Workspace::relative_name(const fs::path &file) const {
    const fs::path inside = fs::absolute(file).lexically_normal().lexically_relative(root.lexically_normal());
    const bool is_inside = !inside.empty() && *inside.begin() != "..";
    return plain_line((is_inside ? inside : file).generic_string(), 4096); // PATH_MAX: it's never cut
}

bool Workspace::has_solution(const Section &s) const {
    return fs::exists(solution(s)) || !fs::exists(root / handout_mark);
}

void Workspace::require_solution(const Section &s, const std::string &instead) const {
    if (!has_solution(s))
        throw UserError{"this edition of the course has no solutions: your instructor has them. " + instead};
}

bool Workspace::has_answers(const Section &s) const {
    return fs::exists(solution(s)) && (fs::exists(mutants(s)) || fs::exists(tests_folder(s) / "mutants"));
}

fs::path Workspace::written_exercise(const Section &s) const {
    if (fs::exists(exercise(s))) return exercise(s);
    throw UserError{relative_name(exercise(s)) + " is not there; `./course reset " + s.short_number()
                    + "` brings the empty one back."};
}

} // namespace course
