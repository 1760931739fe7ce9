#include "check/advice.hpp"

#include "base/lines.hpp"
#include "base/nearest.hpp"
#include "base/text.hpp"
#include "check/scanner.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <regex>
#include <string_view>
#include <utility>
#include <vector>

namespace course {
namespace {

using PatternEntry = std::pair<const char *, const char *>;

/// What patterns call by name. A pattern may contain those below it.
constexpr std::array named_patterns{
    PatternEntry{"{lacks}", R"(' has no member named ')"},
    PatternEntry{"{mixed}", R"((?:{number} and {vector}|{vector} and {number}))"},
    PatternEntry{"{number}", R"('(?:const )?(?:double|float|int|long(?: int)?)&?')"},
    PatternEntry{"{vector}", R"('(?:const )?(?:\w+::)*(?:Vec2|expression of Vec2s) ?&?')"},
    PatternEntry{"{struct}", R"('{Struct}')"},                                                     // captures the name
    PatternEntry{"{Struct}", R"((?:const |class |struct )*(?:\w+::)*(?!Vec2\b)([A-Z]\w*)\b ?&?)"}, // without quotes
    PatternEntry{"{items}", R"((?:[^,;(){}\[\]<]|\({inner}\)|\{[^{}]*\}|\[[^\[\]]*\]|<[^<>;()]*>|<(?![^<>;()]*>))*)"},
    PatternEntry{"{closed}", R"((?:[^;(){}\[\]]|\({inner}\)|\{[^{}]*\}|\[[^\[\]]*\])*)"}, // no bracket that's open
    PatternEntry{"{inner}", R"((?:[^()]|\((?:[^()]|\([^()]*\))*\))*)"}, // what can stand in parentheses
    PatternEntry{"{angles}", R"((?:[^<>]|<(?:[^<>]|<[^<>]*>)*>)*)"},
};

std::regex compile_pattern(std::string pattern) {
    for (const auto &[name, meaning] : named_patterns) replace_all(pattern, name, meaning);
    return std::regex{pattern};
}

/// What GCC and Clang word in several ways, and the one form in which rules know it. An @ is the operator at the caret.
constexpr std::array common_forms{
    PatternEntry{R"(^no member named ('[^']*') in ('[^']*'))", "$2 has no member named $1"},
    PatternEntry{R"(^(?:use of undeclared identifier|no template named) ('[^']*'))",
                 "$1 was not declared in this scope"},
    PatternEntry{R"(^type '([^']*)' does not provide a call operator)", "no match for call to '($1)"},
    PatternEntry{R"(^invalid operands of types ('[^']*') and ('[^']*') to binary ('[^']*'))",
                 "no match for $3 (operand types are $1 and $2)"},
    PatternEntry{R"(^invalid operands to binary expression \(('[^']*') and ('[^']*'))",
                 "no match for 'operator@' (operand types are $1 and $2)"},
    PatternEntry{R"(^could not convert .*' from ('[^']*') to ('[^']*'))", "conversion from $1 to $2"},
    PatternEntry{R"(^cannot convert ('[^']*') to ('[^']*'))", "conversion from $1 to $2"},
    PatternEntry{R"(^conversion from ('[^']*') to non-scalar type ('[^']*'))", "conversion from $1 to $2"},
    PatternEntry{
        R"(^no viable conversion from (?:returned value of type )?('[^']*') to (?:function return type )?('[^']*'))",
        "conversion from $1 to $2"},
    PatternEntry{R"(^assigning to ('[^']*') from incompatible type ('[^']*'))", "conversion from $2 to $1"},
    PatternEntry{R"(^cannot initialize an? [^']*('[^']*') with an? [lrx]value of type ('[^']*'))",
                 "conversion from $2 to $1"},
    PatternEntry{R"(^invalid initialization of reference of type ('[^']*') from expression of type ('[^']*'))",
                 "argument from $2 to $1"},
};

/// What rules look at. A regular expression of libstdc++ recurses for each character, so texts are cut, words and
/// notes in their middle.
struct Evidence {
    std::string words, code, marked_code, notes;
};

Evidence evidence_of(const Diagnostic &diagnostic) {
    constexpr std::size_t most_words = 2000, most_code = 400, most_notes = 8000;
    const std::string_view line = diagnostic.code, alone = code_alone(line);
    Evidence evidence{diagnostic.words, std::string{alone.substr(0, most_code)}, "", diagnostic.notes};
    auto &[words, code, marked_code, notes] = evidence;
    const std::size_t indentation = alone.empty() ? 0 : static_cast<std::size_t>(alone.data() - line.data());
    const std::size_t caret = std::max(diagnostic.caret.find('^'), indentation) - indentation;
    const std::size_t place = std::min(caret, code.size());
    const bool points = contains(diagnostic.caret, "^");
    marked_code = code.substr(0, place) + (points ? "@" : "") + code.substr(place);
    if (const auto note = between(notes, "no known conversion from ", "\n");
        note && contains(words, "function for call to")) // Clang
        words += ", argument from " + with_short_names(std::string{*note});
    if (words.size() > most_words) words.erase(most_words / 2, words.size() - most_words);
    if (notes.size() > most_notes) notes.erase(most_notes / 2, notes.size() - most_notes);
    for (const auto &[pattern, form] : common_forms) {
        std::smatch match;
        if (!std::regex_search(words, match, std::regex{pattern})) continue;
        std::string common = match.format(form);
        const std::size_t end = code.find_first_not_of("+-*/%<>=!^&|", place);
        replace_all(common, "'operator@'", "'operator" + code.substr(place, end - place) + '\'');
        words = common + ": " + words;
        break;
    }
    return evidence;
}

using Captures = std::vector<std::string>;

/// The expression that takes this text alone.
std::string literally(const std::string &text) {
    return std::regex_replace(text, std::regex{R"([.^$|()\[\]{}*+?\\])"}, R"(\$&)");
}

/// "A(n) $1 is a struct" with what was captured; `$small` is $1 with a small letter.
std::string fill_in(std::string text, const Captures &captures) {
    for (std::size_t i = 0; i < captures.size(); ++i) replace_all(text, '$' + std::to_string(i + 1), captures[i]);
    if (!captures.empty() && contains(text, "$small")) {
        std::string small = captures.front();
        small[0] = static_cast<char>(std::tolower(static_cast<unsigned char>(small[0])));
        replace_all(text, "$small", small);
    }
    for (std::size_t at = 0; (at = text.find("(n) ", at)) != text.npos;)
        text.replace(at, 3, contains("AEIOU", text.substr(at + 4, 1)) ? "n" : "");
    return text;
}

/// Whether this is somewhere in the text; what it captures is added.
bool search(const std::string &text, const std::regex &pattern, Captures &captures) {
    std::smatch match;
    if (!std::regex_search(text, match, pattern)) return false;
    for (std::size_t i = 1; i < match.size(); ++i)
        if (match[i].length() > 0) captures.push_back(match[i]);
    return true;
}

bool search_code(const Evidence &evidence, const char *pattern, Captures &captures) {
    Captures literal;
    std::ranges::transform(captures, std::back_inserter(literal), literally);
    const std::string code = fill_in(pattern, literal);
    return search(contains(code, "@") ? evidence.marked_code : evidence.code, compile_pattern(code), captures);
}

/// The sentence of the first rule that fits.
std::string sentence_of_rule(const Evidence &evidence) {
    static const std::vector<std::regex> patterns = [] {
        std::vector<std::regex> all;
        for (const AdviceRule &rule : advice_rules()) all.push_back(compile_pattern(rule.words));
        return all;
    }();
    for (std::size_t i = 0; i < patterns.size(); ++i) {
        const AdviceRule &rule = advice_rules()[i];
        Captures captures;
        if (search(evidence.words, patterns[i], captures) && search_code(evidence, rule.code, captures)
            && search(evidence.notes, compile_pattern(rule.notes), captures))
            return fill_in(rule.sentence, captures);
    }
    return {};
}

/// The header of the standard library that has a name, if beginners use it.
std::string header_of(const std::string &name) {
    static constexpr std::array names{
        PatternEntry{"iostream", " cout cerr cin endl "},
        PatternEntry{"algorithm", " sort count_if clamp find_if ranges max min "},
        PatternEntry{"utility", " pair swap "},
        PatternEntry{"numeric", " accumulate "},
        PatternEntry{"ranges", " views "},
    };
    for (const auto &[header, all] : names)
        if (contains(all, ' ' + name + ' ')) return header;
    return is_any_of(name, {"numbers", "optional", "array", "set", "map", "vector"}) ? name : "";
}

/// For a name that the compiler doesn't know and has no good guess at: of the standard library, of a function that is
/// defined further below or not at all, of a field, or of a variable whose braces have ended.
std::string sentence_on_name(const Evidence &evidence) {
    static const std::regex unknown{R"(^'([^']+)' was not declared in this scope)"}, letter{"[A-Za-z][0-9]|[^ijk]"},
        unknown_in_std{R"(^(?:no member named '(\w+)' in namespace 'std'|'std::(\w+)' has not been declared))"};
    Captures captures;
    if (search(evidence.words, unknown_in_std, captures) && !header_of(captures[0]).empty())
        return "Write #include <" + header_of(captures[0]) + "> at the top of your file.";
    if (!search(evidence.words, unknown, captures)) return {};
    const std::string &name = captures[0], header = header_of(name);
    if (evidence.code.starts_with(name + ' ') && edit_distance(name, "return") < 3)
        return "Write return, in these letters.";
    if (!header.empty() && (name != header || contains(evidence.code, name + '<'))) // a list of yours may be `numbers`
        return "Write std::" + name + ", and #include <" + header + "> at the top of your file.";
    if (contains(evidence.words, "std::")) return {};
    const bool guesses = contains(evidence.words, "did you mean")
                         && !contains_any(evidence.words, {"'rand'", "'opterr'"}); // of the C library: no good guess
    const bool is_called = std::regex_search(evidence.code, std::regex{R"((?:^|[^.\w]))" + literally(name) + R"(\()"});
    if (std::regex_match(name, letter) && (name.size() == 1 || (!guesses && !is_called)))
        return "If " + name
               + " is a letter of a formula, say what it is in the code: a parameter, or a field of one, as in a.mass; "
                 "else declare it above.";
    if (guesses) return {};
    if (is_called) return "If " + name + " is a function of yours, put it above the one that calls it.";
    return "A field needs its struct, as in start.velocity; a variable is known below the line that declares it, "
           "inside the same braces.";
}

} // namespace

std::string advice(const Diagnostic &diagnostic) {
    const Evidence evidence = evidence_of(diagnostic);
    const std::string sentence = sentence_of_rule(evidence);
    return sentence.empty() ? sentence_on_name(evidence) : sentence;
}

} // namespace course
