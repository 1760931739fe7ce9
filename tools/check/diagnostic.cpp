#include "check/diagnostic.hpp"

#include "base/lines.hpp"
#include "base/plain.hpp"
#include "base/text.hpp"

#include <optional>

namespace course {
namespace {

constexpr std::size_t longest_words = 5000; ///< [characters] of a compiler's words that are read

/// Where a type that begins at `from` ends: behind the last of its angle brackets.
std::size_t end_of_type(std::string_view text, std::size_t from) {
    int open = 0;
    for (std::size_t i = from; i < text.size(); ++i) {
        if (text[i] == '<') ++open;
        if (text[i] == '>' && --open == 0) return i + 1;
        if (open == 0 && text[i] == '\'') return i;
    }
    return text.size();
}

/// The first "std::allocator<std::optional<int> >" of a type is one of 'std::optional<int>'.
std::string element_of_allocator(std::string_view type) {
    const std::size_t at = type.find("std::allocator<");
    if (at == type.npos) return {};
    const std::size_t begin = type.find('<', at) + 1, end = end_of_type(type, at) - 1;
    return std::string{without_blanks_behind(type.substr(begin, end - begin))};
}

/// 'Eigen::…::ReturnType' {aka 'double'}, what dot() returns, is 'double'.
void name_doubles(std::string &text) {
    for (const char *known : {"' {aka 'double'}", "' (aka 'double')"})
        for (std::size_t at; (at = text.find(known)) != text.npos && at > 0;) {
            const std::size_t begin = text.rfind('\'', at - 1);
            if (begin == text.npos) return;
            text.replace(begin, at + std::string_view{known}.size() - begin, "'double'");
        }
}

/// Takes ":12" from the end of a place, and gives back the 12.
std::optional<int> take_number(std::string_view &place) {
    const std::size_t colon = place.rfind(':');
    if (colon == place.npos || !is_all_digits(place.substr(colon + 1))) return {};
    const auto number = leading_number(place.substr(colon + 1));
    place = place.substr(0, colon);
    return number;
}

std::optional<Diagnostic> parse(std::string_view line) {
    for (const char *severity : {": error: ", ": fatal error: ", ": warning: "}) {
        const std::size_t mark = line.find(severity);
        if (mark == line.npos) continue;
        Diagnostic diagnostic;
        diagnostic.is_error = contains(severity, "error");
        std::string_view place = line.substr(0, mark), words = line.substr(mark + std::string_view{severity}.size());
        if (words.starts_with("too many errors emitted")) return {};
        if (words.starts_with("static_assert failed") && words.ends_with('"')) // Clang: the condition, "the message"
            words = words.substr(words.rfind('"', words.size() - 2) + 1);
        const auto last = take_number(place), before = take_number(place); // line and column, or the line alone
        diagnostic.file = place;
        diagnostic.line = before.value_or(last.value_or(0));
        diagnostic.column = before ? *last : 0;
        diagnostic.words =
            plain_line(with_short_names(std::string{words.substr(0, words.find(" [-W"))}), longest_words);
        return diagnostic;
    }
    return {};
}

/// The line of code that follows an error, and the one with its caret: GCC puts "   12 | " before it, Clang nothing.
void read_code(const std::vector<Line> &lines, std::size_t next, Diagnostic &diagnostic) {
    if (next + 1 >= lines.size()) return;
    const std::string_view code = lines[next].text, caret = lines[next + 1].text;
    const std::size_t bar = code.find(" | ");
    if (bar != code.npos && is_all_digits(trim(code.substr(0, bar)))) {
        diagnostic.code = code.substr(bar + 3);
        if (caret.size() > bar + 3 && caret.find('|') == bar + 1) diagnostic.caret = caret.substr(bar + 3);
    } else if (caret.find_first_not_of(" ~^") == caret.npos && contains(caret, "^")) {
        diagnostic.code = code;
        diagnostic.caret = caret;
    }
}

} // namespace

std::string with_short_names(std::string text) {
    name_doubles(text);
    erase_all(text, " {aka ", "}");
    erase_all(text, " (aka '", "')");
    erase_all(text, " [with ", "]");
    for (const char *spelling : {"Eigen::Matrix<double, 2, 1, 0, 2, 1>", "Eigen::Matrix<double, 2, 1, 0>",
                                 "Eigen::Matrix<double, 2, 1>", "course::Vec2"})
        replace_all(text, spelling, "Vec2");
    constexpr const char *expression = "expression of Vec2s", *product = "product of Vec2s";
    for (const std::string_view type : {"Eigen::Product<", "Product<", "Eigen::CwiseBinaryOp<", "CwiseBinaryOp<",
                                        "Eigen::CwiseUnaryOp<", "CwiseUnaryOp<"}) // Clang leaves out Eigen:: at times
        for (std::size_t at; (at = text.find(type)) != text.npos;) {
            const std::size_t length = end_of_type(text, at) - at;
            const bool has_product = contains(std::string_view{text}.substr(at, length), product); // (a * b) / 2
            text.replace(at, length, has_product || contains(type, "Product") ? product : expression);
        }
    for (const char *name : {expression, product}) replace_all(text, std::string{"const "} + name, name);
    replace_all(text, "<Vec2 >", "<Vec2>");
    for (const char *negative :
         {"const Eigen::DenseBase<Vec2>::NegativeReturnType", "Eigen::DenseBase<Vec2>::NegativeReturnType"})
        replace_all(text, negative, expression);
    for (std::size_t at; (at = text.find("__gnu_cxx::__alloc_traits<")) != text.npos;) { // an element of a list
        constexpr std::string_view member = "::value_type";
        const std::size_t end = end_of_type(text, at);
        const std::string type = element_of_allocator(std::string_view{text}.substr(at, end - at));
        if (type.empty() || text.compare(end, member.size(), member) != 0) break;
        text.replace(at, end + member.size() - at, type);
    }
    for (const char *computed :
         {"Eigen::MatrixBase<expression of Vec2s >::PlainObject", "Eigen::MatrixBase<expression of Vec2s>::PlainObject",
          "Eigen::MatrixBase<Vec2>::PlainObject"})
        replace_all(text, computed, "Vec2"); // what normalized() returns
    return text;
}

/// GCC tells before an error where the student's file causes it: "07_x.cpp:26:26:   required from here", or "inlined from
/// 'f' at 07_x.cpp:43:18"; Clang behind it: "07_x.cpp:26:26: note: in instantiation of … requested here".
std::vector<Diagnostic> diagnostics_in(std::string_view printed, const std::string &file) {
    std::string text{printed};
    for (const char *quote : {"‘", "’"}) replace_all(text, quote, "'");
    const auto lines = split_lines(text);
    const std::string place = file + ':';
    const auto line_in_file = [&](std::string_view line) {
        const std::size_t at = line.find(place);
        return at == line.npos ? 0 : leading_number(line.substr(at + place.size())).value_or(0);
    };
    std::vector<Diagnostic> diagnostics;
    int cause = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string_view line = lines[i].text;
        if (auto diagnostic = parse(line)) {
            if (diagnostic->file == file) {
                read_code(lines, i + 1, *diagnostic);
                const bool again = !diagnostics.empty() && diagnostics.back().file == diagnostic->file
                                   && diagnostics.back().line == diagnostic->line;
                if (diagnostic->code.empty() && again) diagnostic->code = diagnostics.back().code; // GCC shows it once
            } else if (cause != 0) {
                diagnostic->file = file;
                diagnostic->line = cause;
                diagnostic->column = 0;
            }
            cause = 0;
            diagnostics.push_back(std::move(*diagnostic));
            continue;
        }
        if (contains(line, "required from") || contains(line, "inlined from"))
            if (const int here = line_in_file(line); here != 0) cause = here;
        if (diagnostics.empty()) continue;
        Diagnostic &last = diagnostics.back();
        last.notes.append(line).append("\n");
        if (last.file != file && line.ends_with("requested here"))
            if (const int here = line_in_file(line); here != 0) {
                last.file = file;
                last.line = here;
                last.column = 0;
            }
    }
    return diagnostics;
}

} // namespace course
