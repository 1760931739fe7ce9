#include "check/diagnosis.hpp"

#include "base/lines.hpp"
#include "base/nearest.hpp"
#include "base/plain.hpp"
#include "base/text.hpp"
#include "check/advice.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <regex>
#include <set>
#include <sstream>

namespace course {
namespace {

constexpr std::size_t longest_name = 300; ///< [characters] of a symbol, or of a compiler's words
constexpr std::size_t longest_line = 160; ///< [characters] of a line of code

/// "could not convert '…' from 'A' to 'B'" without what is between the first quotes, if that is in the library's words,
/// since the line itself is shown below; and not more than can be read.
std::string readable(std::string words) {
    constexpr std::string_view converts = "could not convert";
    const std::size_t from = words.rfind("' from '");
    if (words.starts_with(converts) && from != words.npos
        && (contains(words.substr(0, from), "Eigen::") || from > longest_name / 3))
        words.erase(converts.size(), from + 1 - converts.size());
    return plain_line(words, longest_name);
}

/// Whether a compiler could not open a file, or an assembler: the first two.
bool could_not_open(const std::string &words) {
    static const std::regex unopened{"^can't open |^file not found: |' file not found$|"
                                     ": (?:No such file or directory|Permission denied|Too many levels of symbolic "
                                     "links|No such device or address)$"};
    return std::regex_search(words, unopened);
}

/// What the compiler says, and what it means.
std::string explained(Diagnostic diagnostic) {
    static const std::regex later_header{
        "^'?(format|print|expected|generator|mdspan|flat_map)(?:: No such file or directory|' file not found)$"};
    std::string &words = diagnostic.words;
    if (std::smatch match; std::regex_match(words, match, later_header))
        return "This compiler doesn't have <" + match[1].str() + "> yet"
               + (is_any_of(match[1].str(), {"format", "print"}) ? ": print with std::cout, and #include <iostream>."
                                                                 : ": do without it.");
    if (could_not_open(words)) return explain_unopened();
    if (words.starts_with("'*(__m128d*)") && contains(words, "&<unnamed>")) // GCC looks into Eigen
        return "This vector's parts may be gone by now: if it's declared with auto, write Vec2 instead.";
    const std::size_t guess = words.find("; did you mean '");
    if (guess != words.npos && between(words, "'", "'").value_or("").size() < 3) words.erase(guess); // 'x0': 'y0'?
    const std::string more = advice(diagnostic);
    words = readable(words);
    if (more.empty()) return words;
    return words + (contains(".?!", words.substr(words.size() - 1)) ? " " : ". ") + more;
}

/// The name that the compiler does not know, if that is what its words say.
std::string unknown_name(const std::string &words) {
    if (const auto member = between(words, "no member named '", "'")) return std::string{*member};
    const bool unknown =
        contains_any(words, {"was not declared", "has not been declared", "does not name a type", "is not a member of",
                             "undeclared identifier", "unknown type name", "no type named"});
    return std::string{unknown ? between(words, "'", "'").value_or("") : ""};
}

/// A line that a compiler speaks of and does not show: GCC shows none again that it has just shown with a warning, and
/// where an error is in a file of the library, it shows that one's.
std::string line_of(std::string_view text, int number) {
    std::istringstream in{std::string{text}};
    std::string line;
    for (int i = 0; i < number; ++i)
        if (!std::getline(in, line)) return {};
    return number > 0 ? line : "";
}

/// Where GCC does not know `t`, it takes `t < end()` for a template, and finds fault with end() before it names `t`.
void drop_imagined_templates(std::vector<Diagnostic> &errors) {
    std::vector<int> lines; // with an unknown name
    for (const Diagnostic &error : errors)
        if (!unknown_name(error.words).empty()) lines.push_back(error.line);
    std::erase_if(errors, [&](const Diagnostic &error) {
        return error.words.starts_with("call to non-'constexpr' function") && std::ranges::count(lines, error.line) > 0;
    });
}

/// The name that stands after these words in quotes, `x' or 'x': a linker's. A long one may have been cut.
std::optional<std::string> quoted_after(std::string_view line, std::string_view words) {
    const std::size_t at = line.find(words);
    if (at == line.npos || at + words.size() == line.size()) return {};
    const std::string_view name = line.substr(at + words.size() + 1);
    return plain_line(name.substr(0, name.find('\'')), longest_name);
}

/// The name of what isn't defined, in a line of a linker: GNU's, or LLVM's for WebAssembly.
std::optional<std::string> undefined_in(std::string_view line) {
    const std::string_view words = "undefined symbol: ";
    const std::size_t at = line.find(words);
    if (at == line.npos) return quoted_after(line, "undefined reference to ");
    return plain_line(line.substr(at + words.size()), longest_name);
}

/// A function of an object: "ns::meet(double)", and "meet".
struct Defined {
    std::string whole, name;
};

/// What `nm -C --defined-only` lists, without the functions of templates.
std::vector<Defined> functions_in(std::string_view symbols) {
    std::vector<Defined> functions;
    for (const auto &line : split_lines(symbols)) {
        if (line.text.size() < 20 || std::string_view{"TtW"}.find(line.text[17]) == std::string_view::npos) continue;
        const std::string whole = with_short_names(std::string{line.text.substr(19)});
        const std::size_t end = whole.find('(');
        if (end == whole.npos || whole.find('<') < end) continue;
        const std::size_t space = whole.rfind("::", end), begin = space == whole.npos ? 0 : space + 2;
        functions.push_back({whole, whole.substr(begin, end - begin)});
    }
    return functions;
}

/// `Vec2 f(const Vec2 &x);` as the header has it, on one line.
std::string declaration(const std::string &header, const std::string &function) {
    for (std::size_t name = 0; (name = header.find(' ' + function + '(', name)) != header.npos; ++name) {
        const std::size_t begin = header.rfind('\n', name) + 1, end = header.find(';', name);
        if (header[begin] == '/' || end == header.npos) continue; // a comment speaks of it
        std::string text;
        for (const char c : header.substr(begin, end + 1 - begin)) {
            const bool blank = c == ' ' || c == '\n';
            if (!blank || text.back() != ' ') text += blank ? ' ' : c;
        }
        return text;
    }
    return {};
}

} // namespace

std::string explain_unopened() {
    return "A check can't open this file: it has only headers of the system, Eigen and chapters/. Check the name, or "
           "write what you need yourself.";
}

std::string numbered(int line, std::string_view code) {
    return fmt::format("{:>5} | {}", line, plain_line(std::string{code}, longest_line));
}

Verdict diagnose_compiler(std::string_view printed, const std::string &file, const std::string &name,
                          std::string_view text, const std::vector<Renamed> &renamed) {
    Verdict verdict = {.kind = Outcome::does_not_compile};
    auto errors = diagnostics_in(printed, file);
    std::erase_if(errors, std::not_fn(&Diagnostic::is_error));
    drop_imagined_templates(errors);
    if (errors.empty()) {
        const std::string_view line = printed.substr(0, printed.find('\n'));
        const std::string words{between(printed, ": Error: ", "\n").value_or(line)}; // of the assembler
        verdict.sentence = could_not_open(words) ? explain_unopened()
                           : words.empty()       ? "The compiler stopped: it said nothing."
                                                 : "The compiler stopped: " + plain_line(words, longest_name);
        return verdict;
    }
    Diagnostic &first = errors.front();
    std::vector<std::string> unknown;
    for (const Diagnostic &error : errors) unknown.push_back(unknown_name(error.words));
    const bool is_renamed = !explain_renamed({unknown.front()}, renamed).empty();
    verdict.sentence = is_renamed ? explain_renamed(unknown, renamed) : explained(first);
    if (first.line != 0) verdict.file = first.file == file ? name : first.file.substr(first.file.rfind('/') + 1);
    verdict.line = first.line;
    if (first.code.empty() && first.file == file) first.code = line_of(text, first.line);
    if (!first.code.empty()) {
        verdict.printed = {numbered(first.line, first.code)};
        const std::size_t margin = verdict.printed[0].find('|');
        if (!first.caret.empty())
            verdict.printed.push_back(std::string(margin, ' ') + "| " + plain_line(first.caret, longest_line));
    }
    verdict.printed_more = errors.size() - 1;
    return verdict;
}

std::vector<std::string> find_warnings(std::string_view printed, const std::string &file, const std::string &name) {
    std::vector<std::string> warnings;
    for (const Diagnostic &diagnostic : diagnostics_in(printed, file))
        if (!diagnostic.is_error && diagnostic.file == file)
            warnings.push_back(name + ':' + std::to_string(diagnostic.line) + ": " + explained(diagnostic));
    return warnings;
}

Verdict diagnose_linker(std::string_view printed, const std::string &name, const std::string &number, Reader reader) {
    std::set<std::string> missing;
    std::optional<std::string> twice;
    const std::string text = with_short_names(std::string{printed});
    constexpr std::string_view duplicate = "duplicate symbol: "; // LLVM's linker
    for (const Line &line : split_lines(text)) {
        if (const auto symbol = undefined_in(line.text)) missing.insert(*symbol);
        if (!twice) twice = quoted_after(line.text, "multiple definition of ");
        if (const auto at = line.text.find(duplicate); !twice && at != line.text.npos)
            twice = line.text.substr(at + duplicate.size());
    }
    const auto because = [](std::string sentence) {
        return Verdict{.kind = Outcome::does_not_link, .sentence = std::move(sentence)};
    };
    if (twice == "main")
        return because("Your file has a `main` of its own. The course has one already: remove yours."
                       + (reader == Reader::page
                              ? ""
                              : " `./course run " + number + " --mine` runs the section's program with your code."));
    if (twice)
        return because('`' + *twice
                       + "` is defined twice, in your file and in the course: remove yours, or give it a name that "
                         "isn't taken.");
    if (missing.empty())
        return because("The linker stopped: " + plain_line(text.substr(0, text.find('\n')), longest_name));
    if (missing.begin()->starts_with("fmt::"))
        return because("A check doesn't link the library fmt: print with std::cout, and #include <iostream>.");
    std::string names;
    for (const auto &symbol : missing) names += (names.empty() ? "`" : ", `") + symbol + '`';
    return because(names + (missing.size() == 1 ? " is" : " are") + " declared in " + name
                   + ", and used, but never defined: write the body, or correct name and parameters.");
}

std::string first_error(const std::string &printed) {
    const auto lines = split_lines(printed);
    for (const Line &line : lines)
        if (const auto symbol = quoted_after(line.text, "undefined reference to "); symbol && line.text.ends_with('\''))
            return *symbol + " isn't defined; did its name or its signature change?";
    for (const char *mark : {"multiple definition of", "error: "})
        for (const Line &line : lines)
            if (contains(line.text, mark)) return std::string{line.text};
    for (const Line &line : lines) { // a compiler that speaks another language: file.cpp:12:5: …
        const std::size_t colon = line.text.find(':');
        if (colon < line.text.find(' ') && leading_number(line.text.substr(colon + 1))) return std::string{line.text};
    }
    return "";
}

std::string explain_missing(std::string_view symbols, const std::string &header, const std::string &function,
                            const std::vector<Renamed> &renamed) {
    const std::string expected = declaration(header, function);
    const std::string says = expected.empty() ? "" : " The header says `" + expected + "`";
    std::vector<std::string> others, by_old_name;
    for (const auto &[whole, name] : functions_in(symbols)) {
        if (whole.starts_with(function + '(')) // in no namespace
            return " Yours stands outside of `namespace "
                   + std::string{between(header, "\nnamespace ", " {").value_or("")}
                   + " { … }`: put it between those braces.";
        if (name == function)
            return says + (says.empty() ? " Yours is `" : "; yours is `") + whole
                   + "`, which is another function to the compiler: copy name, parameters and namespace.";
        if (header.find(' ' + name + '(') == header.npos) others.push_back(name);
        for (const Renamed &one : renamed)
            if (one.before == name && one.now == function) by_old_name.push_back(name);
    }
    if (const std::string names = explain_renamed(by_old_name, renamed); !names.empty()) return ' ' + names;
    std::string near = nearest(function, others);
    if (edit_distance(near, function) > 1 + function.size() / 3) near.clear(); // a helper with a name of its own
    return says + (says.empty() ? "" : ".") + (near.empty() ? "" : " Yours has `" + near + "`: is that it, misspelt?");
}

} // namespace course
