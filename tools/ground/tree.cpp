#include "ground/tree.hpp"

#include "ground/files.hpp"
#include "ground/nearest.hpp"
#include "ground/plain.hpp"
#include "ground/text.hpp"

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

std::string listed(const std::vector<Section> &sections) {
    std::string result;
    for (std::size_t i = 0; i < sections.size(); ++i)
        result += (i == 0 ? "" : i + 1 == sections.size() ? " or " : ", ") + sections[i].name;
    return result;
}

/// " Did you mean `07_segment_intersection`?": the section whose name or a word of its name is nearest to what was
/// typed; for a number, the nearest number.
std::string did_you_mean_section(const std::string &typed, const std::vector<Section> &sections) {
    Section best = sections.front();
    if (!typed.empty() && is_digit(typed[0]) && typed.size() < 5) {
        const auto away = [wanted = std::stoi(typed)](const Section &s) { return std::abs(s.number() - wanted); };
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
    std::smatch found;
    return std::regex_search(line, found, call) ? std::optional{Section{found[1]}} : std::nullopt;
}

std::vector<Section> Tree::sections() const {
    std::vector<Section> result;
    std::istringstream text{read_file(root / "CMakeLists.txt")};
    for (std::string line; std::getline(text, line);)
        if (const auto section = section_added_by(line)) result.push_back(*section);
    return result;
}

Section Tree::section(std::string_view words) const {
    const std::vector<Section> all = sections();
    if (all.empty())
        throw Complaint{"CMakeLists.txt names no section; a line like section(07_segment_intersection) does"};

    static const std::regex number{R"(0*(\d{1,2})(\.\d+)?)"};
    std::vector<Section> meant;
    const auto those = [&](const auto &fits) {
        if (meant.empty()) std::ranges::copy_if(all, std::back_inserter(meant), fits);
    };
    const std::string typed{words}, part = plain(words);
    if (std::smatch found; words.size() < 10 && std::regex_match(typed, found, number)) {
        those([&](const Section &s) { return s.short_number() == found[1]; });
    } else if (!part.empty()) {
        those([&](const Section &s) { return part == s.name || part == s.slug() || leads_to(typed, s); });
        those([&](const Section &s) { return s.name.find(part) != std::string::npos; });
    }
    if (meant.size() == 1) return meant.front();
    if (meant.size() > 1)
        throw Complaint{"`" + typed + "` may be " + listed(meant) + ": type its number, or more of its name"};
    std::smatch found;
    throw UnknownSection{"there is no section `" + typed + "`." + did_you_mean_section(part, all)
                             + " `./course list` shows them all",
                         words.size() < 10 && std::regex_match(typed, found, number) ? std::stoi(found[1]) : 0};
}

std::string Tree::shown(const fs::path &file) const {
    fs::path shortest = file;
    for (const fs::path &folder : {root, own()}) {
        const fs::path inside = fs::absolute(file).lexically_normal().lexically_relative(folder.lexically_normal());
        if (!inside.empty() && *inside.begin() != "..") shortest = inside;
    }
    return plain_line(shortest.generic_string(), 4096); // PATH_MAX: it's never cut
}

fs::path Tree::test_program(const Section &s) const {
    return is_shared() && fs::exists(own_test_program(s)) ? own_test_program(s) : build / "tests" / s.name;
}

bool Tree::has_solution(const Section &s) const { return fs::exists(solution(s)) || !fs::exists(root / handout_mark); }

void Tree::require_solution(const Section &s, const std::string &instead) const {
    if (!has_solution(s))
        throw Complaint{"this edition of the course has no solutions: your instructor has them. " + instead};
}

bool Tree::has_answers(const Section &s) const {
    return fs::exists(solution(s)) && (fs::exists(wrong_answers(s)) || fs::exists(root / "tests" / "wrong" / s.name));
}

fs::path Tree::written_exercise(const Section &s) const {
    if (fs::exists(exercise(s))) return exercise(s);
    throw Complaint{shown(exercise(s)) + " is not there; `./course reset " + s.short_number()
                    + "` brings the empty one back."};
}

} // namespace course
