#include "check/answer.hpp"

#include "base/lines.hpp"
#include "base/text.hpp"
#include "check/diagnostic.hpp"
#include "check/functions.hpp"

#include <algorithm>

namespace course {
namespace {

/// "UTF-16", if every other byte or so is a zero, or a mark says so; "" for UTF-8, and for what is no text.
std::string wide_encoding(std::string_view text) {
    using namespace std::string_view_literals;
    if (text.starts_with("\xFF\xFE\0\0"sv) || text.starts_with("\0\0\xFE\xFF"sv)) return "UTF-32";
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF")) return "UTF-16";
    const auto is_control = [](char c) { return c > 0 && c < ' ' && !contains("\t\r\n\f\v", {&c, 1}); };
    if (std::ranges::any_of(text, is_control)) return "";
    const auto zeros = 10 * static_cast<std::size_t>(std::ranges::count(text, '\0'));
    return zeros > 6 * text.size() ? "UTF-32" : zeros > 3 * text.size() ? "UTF-16" : "";
}

/// Whether this line is a `return` that the line before it does not make conditional.
bool always_returns(std::string_view code, std::string_view before) {
    return code.starts_with("return ") && code.ends_with(';')
           && std::ranges::count(code, '{') == std::ranges::count(code, '}') && !before.ends_with(')')
           && !before.ends_with("else");
}

bool may_follow_return(std::string_view code) {
    return contains("}#/", code.substr(0, 1)) || code.starts_with("case ") || code.ends_with(':');
}

/// Whether a number may begin behind this as the first of a product: not behind 0.5 *, where all is double already, not
/// in "x1", "2.1", "1e-3", and not in the brackets of a size.
bool begins_a_product(std::string_view before) {
    if (before.empty()) return true;
    if (is_in_a_name(before.back()) || contains(".'", before.substr(before.size() - 1))) return false;
    const std::size_t end = before.size();
    const bool exponent = end > 2 && contains("+-", before.substr(end - 1)) && contains("eE", before.substr(end - 2, 1))
                          && contains("0123456789.", before.substr(end - 3, 1));
    before = without_blanks_behind(before);
    return !exponent && (before.empty() || !contains("*/%[", before.substr(before.size() - 1)));
}

} // namespace

std::string_view included(std::string_view line) {
    line = trim(line);
    if (!line.starts_with('#')) return {};
    line = trim(line.substr(1));
    if (!line.starts_with("include")) return {};
    line = trim(line.substr(7));
    const std::size_t end = line.find_first_of("\">", 1);
    if (end == line.npos || !contains("\"<", line.substr(0, 1))) return {};
    const std::string_view name = line.substr(1, end - 1);
    return name.substr(name.rfind('/') + 1); // npos + 1 is 0
}

std::optional<Verdict> diagnose_section(std::string_view text, const std::string &name, const Section &section,
                                        const std::vector<Section> &all, Reader reader) {
    std::optional<Verdict> verdict;
    int number = 0;
    for (const auto &line : split_lines(text)) {
        ++number;
        const std::string_view header = included(line.text);
        if (header.empty()) continue;
        if (header == section.slug() + ".hpp") return {};
        for (const Section &other : all) {
            if (verdict || header != other.slug() + ".hpp") continue;
            verdict = Verdict{
                .kind = Outcome::does_not_compile,
                .sentence =
                    "This file answers section " + other.short_number() + ", for it includes \"" + std::string{header}
                    + '"' + (reader == Reader::page ? "" : ": ./course check " + other.short_number() + " judges it")
                    + ". An answer to section " + section.short_number() + " includes \"" + section.slug() + ".hpp\".",
                .file = name,
                .line = number};
        }
    }
    return verdict;
}

std::optional<Verdict> diagnose_text(std::string_view text, const std::string &name, const std::string &number,
                                     Reader reader) {
    const std::string back = reader == Reader::page ? ""
                                                    : " `./course reset " + number
                                                          + "` brings the stub back, and keeps a copy of what's there.";
    if (text.find_first_not_of(" \t\r\n\xEF\xBB\xBF") == text.npos)
        return Verdict{.kind = Outcome::empty, .sentence = name + " is empty." + back};
    const auto because = [&](const std::string &what) {
        return Verdict{.kind = Outcome::unreadable, .sentence = name + what};
    };
    if (text.starts_with("PK\3\4")) return because(" is a zip archive: unpack it, and check the file inside.");
    if (const std::string encoding = wide_encoding(text); !encoding.empty())
        return because(" is saved as " + encoding + ": save it as UTF-8 in your editor.");
    if (text.find('\0') != text.npos)
        return because(" isn't a text file: did you save a compiled file over it?" + back);
    return {};
}

std::vector<std::string> warnings_about(const std::vector<std::string> &warnings, std::string_view text,
                                        const std::string &name, const std::vector<std::string> &others) {
    const Source source{text};
    const Functions functions = functions_of(source, others);
    const auto is_in_another = [&](int line) {
        const Function *function = function_around(functions, source.line_begins(line));
        return function != nullptr && std::ranges::count(others, function->name) > 0;
    };
    std::vector<std::string> about;
    for (const std::string &warning : warnings) {
        const std::size_t place = warning.starts_with(name + ':') ? name.size() + 1 : warning.size();
        const auto line = leading_number(std::string_view{warning}.substr(place));
        if (!line || !is_in_another(*line)) about.push_back(warning);
    }
    return about;
}

std::vector<std::string> find_unreached(std::string_view text, const std::string &name) {
    std::vector<std::string> warnings;
    const auto tell = [&](int line, const char *what) { warnings.push_back(name + ':' + std::to_string(line) + what); };
    int line = 0, thrown = 0; // where the last NotYet stands, until its braces end
    std::string_view before;  // the last line with code
    bool returned = false;
    for (const Line &each : split_lines(text)) {
        ++line;
        const std::string_view code = code_alone(each.text);
        if (code.empty()) continue;
        if (returned && !may_follow_return(code))
            tell(line, ": this line comes after a `return`, and is never reached: move it up");
        returned = always_returns(code, before);
        before = code;
        if (code.starts_with("throw course::NotYet") || code.starts_with("throw NotYet")) thrown = line;
        else if (code.starts_with('}')) thrown = 0;
        else if (thrown != 0 && !code.starts_with('"')) {
            tell(thrown, ": this `throw` is still above your code, which is therefore never reached: delete this line");
            thrown = 0;
        }
    }
    return warnings;
}

std::vector<std::string> find_whole_divisions(std::string_view text, const std::string &name) {
    constexpr const char *digits = "0123456789";
    std::vector<std::string> warnings;
    const Source source{text};
    int number = 0;
    for (const auto &[line, end] : split_lines(source.code)) {
        ++number;
        for (std::size_t slash = 0; (slash = line.find('/', slash)) != line.npos; ++slash) {
            const std::string_view left = without_blanks_behind(line.substr(0, slash)),
                                   right = trim(line.substr(slash + 1));
            const std::size_t begins = left.find_last_not_of(digits) + 1,
                              ends = std::min(right.find_first_not_of(digits), right.size());
            const std::string over{left.substr(begins)}, under{right.substr(0, ends)};
            const auto a = leading_number(over), b = leading_number(under);
            const bool is_whole =
                ends == right.size() || (!is_in_a_name(right[ends]) && !contains(".'", {&right[ends], 1}));
            if (!a || !b || *b == 0 || *a % *b == 0 || !is_whole || !begins_a_product(left.substr(0, begins))) continue;
            warnings.push_back(name + ':' + std::to_string(number) + ": `" + over + " / " + under + "` is "
                               + std::to_string(*a / *b) + ", because both are whole numbers: write `" + over + ".0 / "
                               + under + '`');
        }
    }
    return warnings;
}

std::string explain_accepted(std::string_view text, std::string_view stub, const std::string &exercise) {
    const auto count = [](std::string_view of, std::string_view expected) {
        const auto lines = split_lines(of);
        return std::ranges::count_if(lines, [&](const Line &line) { return trim(line.text) == expected; });
    };
    const std::string_view function = between(stub, "// " + exercise + ' ', "throw course::NotYet").value_or("");
    for (const Line &line : split_lines(function))
        if (const std::string_view refuses = trim(line.text);
            contains(refuses, "require") && count(text, refuses) < count(stub, refuses))
            return " When you got it, the function began with lines that refuse it: put `" + std::string{refuses}
                   + "` back, and any others. These were accepted:";
    return {};
}

} // namespace course
