#include "book/voice.hpp"

#include "book/chapter.hpp"
#include "book/markdown.hpp"
#include "ground/text.hpp"

#include <algorithm>
#include <fmt/format.h>
#include <regex>
#include <set>

namespace course {
namespace {

/// Something that is said too easily, and how often it may be, in a thousand words.
struct Habit {
    const char *name, *pattern;
    double most;
};
constexpr Habit habits[]{
    {"a \"not\" without a contraction",
     R"(\b(is|are|was|were|do|does|did|has|have|had|would|should|must|will|could) not\b|\bcannot\b)", 0.6},
    {"\"begin\", for \"start\"", R"(\bbeg[iau]n(s|ning)?\b)", 0.5},
    {"\"way\"", R"(\bway\b)", 0.8},
    {"an opening like \"It is\"", R"(^(That|This|It|There) (is|was|are)\b)", 0.8},
    {"\"a box of 10 kg\", for \"a 10 kg box\"", R"(\b\w+ of \d[\d.]* ?(m|kg|N|s|px|cm)\b(?!/))", 0.4},
    {"\"in which\"", R"(\b(in|at|to|by|from|with|about|of|on) which\b)", 0.3},
    {"\"rest\"", R"(\b(rests?|rested|at rest)\b)", 0.3},
    {"things that say where or how", R"(\b(say|says|said|tell|tells) (where|how|which|whether|what|when)\b)", 0.3},
    {"\"you have done\", for \"you did\"",
     R"(\byou have (just )?(taken|turned|added|left|put|asked|counted|divided|multiplied|forgotten|subtracted|thought|made|lost|used|chosen|set|moved|gone|found|kept|seen|said|had|written)\b)",
     0.1},
    {"\"is wanted\"", R"(\b(is|are) wanted\b)", 0},
    {"\"somebody\", \"whatever\"", R"(\b(somebody|nobody|whoever|whatever)\b)", 0.3},
    {"\"Your own 9.1\"", R"(\bYour own \d+\.\d)", 0},
    {"\"the verdict to reach\"", R"(\bverdict (to reach is|turns green)\b)", 0},
    {"a standing heading",
     R"(^#+ (What you have built|What your function must do|What the program shows now|How it was judged|Further)$)",
     0},
};
constexpr int most_words = 4500, most_folds = 25, most_about_wrong_answers = 12;
constexpr double least_contractions = 6; // in a thousand words

std::regex regex_of(const char *pattern) { return std::regex{pattern, std::regex::icase | std::regex::optimize}; }

template <class Each> void each_match(const std::string &text, const std::regex &pattern, Each each) {
    for (std::sregex_iterator found{text.begin(), text.end(), pattern}, end; found != end; ++found) each(*found);
}
int count(const std::string &text, const std::regex &pattern) {
    int n = 0;
    each_match(text, pattern, [&](const std::smatch &) { ++n; });
    return n;
}

/// What stands in the open: the lines outside listings, comments and folds, without formulas; and the folds.
struct Open {
    std::vector<std::pair<int, std::string>> lines; ///< by their numbers
    std::set<std::string> folds;                    ///< all hints of an exercise are one
};

Open open_part(std::string_view chapter) {
    static const std::regex unheard = regex_of(R"(<!--.*?-->|\b(which|all the|by the|on its) way\b)"),
                            hint{R"(<summary>(\d+\.\d+), a hint)"};
    Open open;
    walk(
        take_out_formulas(chapter).text,
        [&](std::string_view line, int number, bool folded) {
            std::match_results<std::string_view::const_iterator> found;
            if (line.starts_with("<details"))
                open.folds.insert(std::regex_search(line.begin(), line.end(), found, hint)
                                      ? found[1].str()
                                      : std::to_string(number) + ':');
            const std::string heard = folded ? "" : std::regex_replace(std::string{line}, unheard, "");
            if (!heard.empty()) open.lines.emplace_back(number, heard);
        },
        [](const Fence &, bool) {});
    return open;
}

} // namespace

std::vector<Finding> out_of_voice(std::string_view chapter, const std::filesystem::path &file) {
    std::vector<Finding> findings;
    static const std::regex
        word = regex_of(R"([A-Za-z][\w'’-]*)"),
        contraction = regex_of(
            R"(\b(\w+n['’]t|\w+['’](re|ll|ve|d|m)|(it|that|here|there|what|let|he|she|who|how|where)['’]s)\b)"),
        wrong_answer = regex_of(R"(^- `|`yours`|`returned`|\d of \d+\*|If it (says|is) )");
    const Open open = open_part(chapter);
    int words = 0, contractions = 0, about_wrong_answers = 0;
    for (const auto &[number, line] : open.lines) {
        words += count(line, word);
        contractions += count(line, contraction);
        about_wrong_answers += count(line, wrong_answer) > 0;
    }
    const auto limit = [&](int line, int value, const std::string &what, int most) {
        if (value > most)
            findings.push_back(
                {file, line, fmt::format("the voice: {} {}, where {} are the most.", value, what, most)});
    };
    limit(1, words, "words in the open", most_words);
    limit(1, static_cast<int>(open.folds.size()), "folds", most_folds);
    limit(1, about_wrong_answers, "lines about wrong answers in the open", most_about_wrong_answers);
    if (const int least = static_cast<int>(least_contractions * words / 1000); contractions < least)
        findings.push_back(
            {file, 1, fmt::format("the voice: {} contractions, where {} are the fewest.", contractions, least)});
    for (const Habit &habit : habits) {
        const std::regex pattern = regex_of(habit.pattern);
        int times = 0, last = 1;
        for (const auto &[number, line] : open.lines)
            if (const int here = count(line, pattern); here > 0) times += here, last = number;
        limit(last, times, std::string{"times "} + habit.name,
              std::max(habit.most > 0 ? 1 : 0, static_cast<int>(habit.most * words / 1000)));
    }
    return findings;
}

} // namespace course
