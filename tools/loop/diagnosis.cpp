#include "loop/diagnosis.hpp"

#include "ground/lines.hpp"
#include "ground/nearest.hpp"
#include "ground/plain.hpp"
#include "ground/text.hpp"
#include "loop/advice_rules.hpp"

#include <algorithm>
#include <fstream>
#include <set>

namespace course {
namespace {

constexpr std::size_t longest_name = 300;   ///< [characters] of what is shown of a symbol, or of a compiler's words
constexpr std::size_t longest_words = 5000; ///< [characters] of a compiler's words that are read
constexpr std::size_t longest_line = 160;   ///< [characters] of a line of code

/// An error or a warning: "/long/path/07_x.cpp:12:5: error: 'a' was not declared", and the lines that belong to it.
struct Remark {
    bool is_error = false;
    std::string file;
    int line = 0;
    Said said;
};

/// Takes ":12" from the end of a place, and gives back the 12.
std::optional<int> take_number(std::string_view &place) {
    const std::size_t colon = place.rfind(':');
    if (colon == place.npos || !is_all_digits(place.substr(colon + 1))) return {};
    const auto number = leading_number(place.substr(colon + 1));
    place = place.substr(0, colon);
    return number;
}

std::optional<Remark> parse(std::string_view line) {
    for (const char *severity : {": error: ", ": fatal error: ", ": warning: "}) {
        const std::size_t mark = line.find(severity);
        if (mark == line.npos) continue;
        Remark remark;
        remark.is_error = contains(severity, "error");
        std::string_view place = line.substr(0, mark), words = line.substr(mark + std::string_view{severity}.size());
        if (words.starts_with("too many errors emitted")) return {};
        if (words.starts_with("static_assert failed")
            && words.ends_with('"')) // Clang: what is asserted, "what it says"
            words = words.substr(words.rfind('"', words.size() - 2) + 1);
        const auto last = take_number(place), before = take_number(place); // line and column, or the line alone
        remark.file = place;
        remark.line = before.value_or(last.value_or(0));
        remark.said.words =
            plain_line(with_short_names(std::string{words.substr(0, words.find(" [-W"))}), longest_words);
        return remark;
    }
    return {};
}

/// The line of code that follows an error, and the one with its caret: GCC puts "   12 | " before it, Clang nothing.
void read_code(const std::vector<Line> &lines, std::size_t next, Said &said) {
    if (next + 1 >= lines.size()) return;
    const std::string_view code = lines[next].text, caret = lines[next + 1].text;
    const std::size_t bar = code.find(" | ");
    if (bar != code.npos && is_all_digits(without_blanks(code.substr(0, bar)))) {
        said.code = code.substr(bar + 3);
        if (caret.size() > bar + 3 && caret.find('|') == bar + 1) said.caret = caret.substr(bar + 3);
    } else if (caret.find_first_not_of(" ~^") == caret.npos && contains(caret, "^")) {
        said.code = code;
        said.caret = caret;
    }
}

/// All errors and warnings, in order. One that is made in a file which the student only uses is moved to where his own
/// file causes it. GCC tells that before: "07_x.cpp:26:26:   required from here", or "inlined from 'f' at
/// 07_x.cpp:43:18"; Clang behind it: "07_x.cpp:26:26: note: in instantiation of … requested here".
std::vector<Remark> remarks_in(std::string_view printed, const std::filesystem::path &file) {
    std::string text{printed};
    for (const char *quote : {"‘", "’"}) replace_all(text, quote, "'");
    const auto lines = lines_of(text);
    const std::string place = file.string() + ':';
    const auto line_in_file = [&](std::string_view line) {
        const std::size_t at = line.find(place);
        return at == line.npos ? 0 : leading_number(line.substr(at + place.size())).value_or(0);
    };
    std::vector<Remark> remarks;
    int cause = 0;
    for (std::size_t i = 0; i < lines.size(); ++i) {
        const std::string_view line = lines[i].text;
        if (auto remark = parse(line)) {
            if (remark->file == file.string()) {
                read_code(lines, i + 1, remark->said);
                const bool again = !remarks.empty() && remarks.back().file == remark->file
                                   && remarks.back().line == remark->line; // GCC shows a line once
                if (remark->said.code.empty() && again) remark->said.code = remarks.back().said.code;
            } else if (cause != 0) {
                remark->file = file.string();
                remark->line = cause;
            }
            cause = 0;
            remarks.push_back(std::move(*remark));
            continue;
        }
        if (contains(line, "required from") || contains(line, "inlined from"))
            if (const int here = line_in_file(line); here != 0) cause = here;
        if (remarks.empty()) continue;
        Remark &last = remarks.back();
        last.said.notes.append(line).append("\n");
        if (last.file != file.string() && line.ends_with("requested here"))
            if (const int here = line_in_file(line); here != 0) {
                last.file = file.string();
                last.line = here;
            }
    }
    return remarks;
}

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
bool could_not_open(std::string_view words) {
    if (words.starts_with("can't open ") || words.starts_with("file not found: ")) return true;
    const auto ends = [&](const char *why) { return words.ends_with(why); };
    return ends("' file not found") || ends(": No such file or directory") || ends(": Permission denied")
           || ends(": Too many levels of symbolic links");
}

/// What the compiler says, and what it means.
std::string explained(const Said &said) {
    if (could_not_open(said.words)) return explain_unopened();
    if (said.words.starts_with("'*(__m128d*)") && contains(said.words, "&<unnamed>")) // GCC looks into Eigen
        return "This vector's parts may be gone by now: if it's declared with auto, write Vec2 instead.";
    Said known = said;
    std::string &words = known.words;
    const std::size_t guess = words.find("; did you mean '");
    if (guess != words.npos && between(words, "'", "'").value_or("").size() < 3) words.erase(guess); // 'x0': 'y0'?
    const std::string more = advice(known);
    words = readable(words);
    if (more.empty()) return words;
    return words + (std::string_view{".?!"}.find(words.back()) == std::string_view::npos ? ". " : " ") + more;
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
std::string line_of_file(const std::filesystem::path &file, int number) {
    std::ifstream in{file};
    std::string line;
    for (int i = 0; i < number; ++i)
        if (!std::getline(in, line)) return {};
    return number > 0 ? line : "";
}

/// Where GCC does not know `t`, it takes `t < end()` for a template, and finds fault with end() before it names `t`.
void drop_imagined_templates(std::vector<Remark> &remarks) {
    std::vector<int> lines; // with an unknown name
    for (const Remark &remark : remarks)
        if (!unknown_name(remark.said.words).empty()) lines.push_back(remark.line);
    std::erase_if(remarks, [&](const Remark &remark) {
        return remark.said.words.starts_with("call to non-'constexpr' function")
               && std::ranges::find(lines, remark.line) != lines.end();
    });
}

/// The name that stands after these words in quotes, `x' or 'x': a linker's. A long one may have been cut.
std::optional<std::string> quoted_after(std::string_view line, std::string_view words) {
    const std::size_t at = line.find(words);
    if (at == line.npos || at + words.size() == line.size()) return {};
    const std::string_view name = line.substr(at + words.size() + 1);
    return plain_line(name.substr(0, name.find('\'')), longest_name);
}

/// A function of an object: "ns::meet(double)", and "meet".
struct Defined {
    std::string whole, name;
};

/// What `nm -C --defined-only` lists, without the functions of templates.
std::vector<Defined> functions_in(std::string_view symbols) {
    std::vector<Defined> functions;
    for (const auto &line : lines_of(symbols)) {
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

Verdict diagnose_compiler(std::string_view printed, const std::filesystem::path &file, const std::string &name,
                          const std::vector<Renamed> &renamed) {
    Verdict verdict = {.kind = Kind::does_not_compile};
    auto remarks = remarks_in(printed, file);
    std::erase_if(remarks, [](const Remark &remark) { return !remark.is_error; });
    drop_imagined_templates(remarks);
    if (remarks.empty()) {
        const std::string_view first = printed.substr(0, printed.find('\n')),
                               words = between(printed, ": Error: ", "\n").value_or(first); // of the assembler
        verdict.sentence = could_not_open(words) ? explain_unopened()
                           : words.empty()       ? "The compiler stopped: it said nothing."
                                                 : "The compiler stopped: " + plain_line(words, longest_name);
        return verdict;
    }
    Remark &first = remarks.front();
    verdict.sentence = explained(first.said);
    if (!explain_renamed({unknown_name(first.said.words)}, renamed).empty()) {
        std::vector<std::string> unknown;
        for (const Remark &remark : remarks) unknown.push_back(unknown_name(remark.said.words));
        verdict.sentence = explain_renamed(unknown, renamed);
    }
    if (first.line != 0)
        verdict.file = first.file == file ? name : std::filesystem::path{first.file}.filename().string();
    verdict.line = first.line;
    if (first.said.code.empty() && first.file == file.string()) first.said.code = line_of_file(file, first.line);
    if (const auto &[words, code, caret, notes] = first.said; !code.empty()) {
        const std::string number = std::to_string(first.line);
        const std::string margin(std::max<std::size_t>(number.size(), 5), ' ');
        verdict.printed = {margin.substr(number.size()) + number + " | " + plain_line(code, longest_line)};
        if (!caret.empty()) verdict.printed.push_back(margin + " | " + plain_line(caret, longest_line));
    }
    verdict.printed_more = remarks.size() - 1;
    return verdict;
}

std::vector<std::string> find_warnings(std::string_view printed, const std::filesystem::path &file,
                                       const std::string &name) {
    std::vector<std::string> warnings;
    for (const Remark &remark : remarks_in(printed, file))
        if (!remark.is_error && remark.file == file.string())
            warnings.push_back(name + ':' + std::to_string(remark.line) + ": " + explained(remark.said));
    return warnings;
}

Verdict diagnose_linker(std::string_view printed, const std::string &name, const std::string &number) {
    std::set<std::string> missing;
    std::optional<std::string> twice;
    const std::string text = with_short_names(std::string{printed});
    for (const Line &line : lines_of(text)) {
        if (const auto its = quoted_after(line.text, "undefined reference to ")) missing.insert(*its);
        if (const auto its = quoted_after(line.text, "multiple definition of "); its && !twice) twice = its;
    }
    const auto because = [](std::string sentence) {
        return Verdict{.kind = Kind::does_not_link, .sentence = std::move(sentence)};
    };
    if (twice == "main")
        return because("Your file has a `main` of its own. The course has one already: remove yours. `./course run "
                       + number + " --mine` runs the section's program with your code.");
    if (twice)
        return because('`' + *twice
                       + "` is defined twice, in your file and in the course: remove yours, or give it a name that "
                         "isn't taken.");
    if (missing.empty())
        return because("The linker stopped: " + plain_line(text.substr(0, text.find('\n')), longest_name));
    std::string names;
    for (const auto &one : missing) names += (names.empty() ? "`" : ", `") + one + '`';
    return because(names + (missing.size() == 1 ? " is" : " are") + " declared in " + name
                   + ", and used, but never defined: write the body, or correct name and parameters.");
}

std::string first_error(const std::string &printed) {
    const auto lines = lines_of(printed);
    const std::string_view undefined = "undefined reference to ";
    for (const auto &[line, end] : lines)
        if (const std::size_t at = line.find(undefined); at != line.npos && line.ends_with('\'')) {
            const std::string_view quoted = line.substr(at + undefined.size()); // `name' or 'name'
            return std::string{quoted.substr(1, quoted.size() - 2)}
                   + " isn't defined; did its name or its signature change?";
        }
    for (const char *mark : {"multiple definition of", "error: "})
        for (const auto &[line, end] : lines)
            if (contains(line, mark)) return std::string{line};
    for (const auto &[line, end] : lines) // a compiler that speaks another language: file.cpp:12:5: …
        if (const std::size_t colon = line.find(':'); colon < line.find(' ') && leading_number(line.substr(colon + 1)))
            return std::string{line};
    return "";
}

std::string explain_missing(std::string_view symbols, const std::string &header, const std::string &function,
                            const std::vector<Renamed> &renamed) {
    const std::string wanted = declaration(header, function);
    const std::string says = wanted.empty() ? "" : " The header says `" + wanted + "`";
    std::vector<std::string> others, by_old_name;
    for (const auto &[whole, name] : functions_in(symbols)) {
        if (name == function)
            return says + (says.empty() ? " Yours is `" : "; yours is `") + whole
                   + "`, which is another function to the compiler: copy name, parameters and namespace.";
        if (header.find(' ' + name + '(') == header.npos) others.push_back(name);
        for (const Renamed &one : renamed)
            if (one.before == name && one.now == function) by_old_name.push_back(name);
    }
    if (const std::string old = explain_renamed(by_old_name, renamed); !old.empty()) return ' ' + old;
    std::string near = nearest(function, others);
    if (edit_distance(near, function) > 1 + function.size() / 3) near.clear(); // a helper with a name of its own
    return says + (says.empty() ? "" : ".") + (near.empty() ? "" : " Yours has `" + near + "`: is that it, misspelt?");
}

} // namespace course
