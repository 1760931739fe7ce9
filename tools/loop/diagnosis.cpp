#include "loop/diagnosis.hpp"

#include "ground/lines.hpp"
#include "ground/nearest.hpp"
#include "ground/plain.hpp"
#include "ground/text.hpp"
#include "loop/advice.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace course {
namespace {

constexpr std::size_t longest_name = 300; ///< [characters] of what is shown of a symbol, or of a compiler's words

/// "/long/path/07_x.cpp:12:5: error: 'a' was not declared": where and what.
struct Remark {
    std::string file;
    int line = 0;
    std::string what;
};

/// Takes ":12" from the end of a place, and gives back the 12.
std::optional<int> take_number(std::string_view &place) {
    const std::size_t colon = place.rfind(':');
    if (colon == place.npos || !is_all_digits(place.substr(colon + 1))) return {};
    const auto number = leading_number(place.substr(colon + 1));
    place = place.substr(0, colon);
    return number;
}

std::optional<Remark> parse(const Line &line, const std::string &severity) {
    const std::string words = ": " + severity + ": ";
    const std::size_t mark = line.text.find(words);
    if (mark == line.text.npos) return {};
    std::string_view place = line.text.substr(0, mark);
    const auto last = take_number(place), before = take_number(place); // line and column, or the line alone
    return Remark{std::string{place}, before.value_or(last.value_or(0)),
                  std::string{line.text.substr(mark + words.size())}};
}

std::string shown(const std::string &file, const std::filesystem::path &students, const std::string &shown_name) {
    return file == students.string() ? shown_name : std::filesystem::path{file}.filename().string();
}

/// What the compiler says, with plain quotes and short names, without the flag behind it; and what it means.
std::string plain(std::string said) {
    for (const char *quote : {"‘", "’"}) replace_all(said, quote, "'");
    const std::string text = with_short_names(said.substr(0, said.find(" [-W")));
    const std::string more = advice(text);
    return more.empty() ? text : text + ". " + more;
}

/// Where in the student's file a remark has its cause, that is made in a file which the student only uses:
/// "07_x.cpp:26:26:   required from here", or "inlined from 'f' at 07_x.cpp:43:18".
class Causes {
  public:
    explicit Causes(const std::filesystem::path &file) : place{file.string() + ':'} {}

    void read(const Line &line) {
        const std::size_t at = line.text.find(place);
        if (at == line.text.npos) return;
        if (contains(line.text, "required from") || contains(line.text, "inlined from"))
            last = leading_number(line.text.substr(at + place.size())).value_or(last);
    }
    /// The remark, moved to its cause if there is one; the next remark has a cause of its own.
    Remark at_its_cause(Remark remark, const std::filesystem::path &file) {
        const int line = std::exchange(last, 0);
        return line == 0 || remark.file == file.string() ? remark : Remark{file.string(), line, remark.what};
    }

  private:
    std::string place;
    int last = 0;
};

Verdict broken(Kind kind, std::string sentence) {
    Verdict verdict;
    verdict.kind = kind;
    verdict.sentence = std::move(sentence);
    return verdict;
}

} // namespace

std::optional<Verdict> diagnose_text(std::string_view text, const std::string &name, const std::string &number) {
    const std::string back =
        " `./course reset " + number + "` brings the stub back, and keeps a copy of what is there.";
    if (text.find_first_not_of(" \t\r\n\xEF\xBB\xBF") == text.npos)
        return broken(Kind::does_not_compile, name + " is empty." + back);
    if (text.starts_with("\xFF\xFE") || text.starts_with("\xFE\xFF"))
        return broken(Kind::does_not_compile, name + " is saved as UTF-16: save it as UTF-8 in your editor.");
    if (text.find('\0') != text.npos)
        return broken(Kind::does_not_compile, name + " is no text: has a compiled file been saved over it?" + back);
    return {};
}

Verdict diagnose_compiler(std::string_view printed, const std::filesystem::path &file, const std::string &name) {
    const auto lines = lines_of(printed);
    Verdict verdict = broken(Kind::does_not_compile, "");
    int errors = 0;
    Causes causes{file};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        causes.read(lines[i]);
        auto remark = parse(lines[i], "error");
        if (!remark) remark = parse(lines[i], "fatal error");
        const auto header = between(lines[i].text, "#include <", ">");
        if (errors == 1 && header && contains(lines[i].text, "did you forget to "))
            verdict.sentence += ". Write #include <" + std::string{*header} + "> at the top of your file.";
        if (!remark || ++errors > 1) continue;
        const bool elsewhere = remark->file != file.string();
        remark = causes.at_its_cause(*remark, file);
        verdict.sentence = plain(remark->what);
        verdict.file = shown(remark->file, file, name);
        verdict.line = remark->line;
        for (std::size_t code = i + 1; // the line of code, unless it is one of a file that nobody has written here
             !elsewhere && code < lines.size() && code <= i + 2 && lines[code].text.find('|') != std::string::npos;
             ++code)
            verdict.printed.emplace_back(lines[code].text);
    }
    if (errors == 0)
        verdict.sentence =
            "The compiler stopped: " + std::string{lines.empty() ? "it said nothing." : lines.front().text};
    verdict.printed_more = static_cast<std::size_t>(std::max(0, errors - 1));
    return verdict;
}

std::vector<std::string> find_warnings(std::string_view printed, const std::filesystem::path &file,
                                       const std::string &name) {
    std::vector<std::string> warnings;
    Causes causes{file};
    for (const auto &line : lines_of(printed)) {
        causes.read(line);
        auto remark = parse(line, "warning");
        if (!remark) continue;
        remark = causes.at_its_cause(*remark, file);
        if (remark->file == file.string())
            warnings.push_back(name + ':' + std::to_string(remark->line) + ": " + plain(remark->what));
    }
    return warnings;
}

std::vector<std::string> find_unreached(std::string_view text, const std::string &name) {
    std::vector<std::string> found;
    int line = 0, thrown = 0; // where the last NotYet stands, until its braces end
    for (const Line &each : lines_of(text)) {
        ++line;
        const std::string_view code = without_blanks(each.text);
        if (code.starts_with("throw course::NotYet") || code.starts_with("throw NotYet")) thrown = line;
        else if (code.starts_with('}')) thrown = 0;
        else if (thrown != 0 && !code.empty() && !code.starts_with("//") && !code.starts_with('"')) {
            found.push_back(name + ':' + std::to_string(thrown)
                            + ": this `throw` still stands above your code, which is never reached: delete the line");
            thrown = 0;
        }
    }
    return found;
}

namespace {

/// The name that stands after these words in quotes, `x' or 'x': a linker's. A long one may have been cut.
std::optional<std::string> quoted_after(std::string_view line, std::string_view words) {
    const std::size_t at = line.find(words);
    if (at == line.npos || at + words.size() == line.size()) return {};
    const std::string_view name = line.substr(at + words.size() + 1);
    return plain_line(name.substr(0, name.find('\'')), longest_name);
}

} // namespace

Verdict diagnose_linker(std::string_view printed, const std::string &name, const std::string &number) {
    std::set<std::string> missing;
    std::optional<std::string> twice;
    const std::string text = with_short_names(std::string{printed});
    for (const Line &line : lines_of(text)) {
        if (const auto its = quoted_after(line.text, "undefined reference to ")) missing.insert(*its);
        if (const auto its = quoted_after(line.text, "multiple definition of "); its && !twice) twice = its;
    }
    if (twice) {
        if (*twice == "main")
            return broken(Kind::does_not_link,
                          "Your file has a `main` of its own. The course has one already: remove yours. "
                          "`./course run "
                              + number + " --mine` runs the section's program with your code.");
        return broken(Kind::does_not_link, '`' + *twice
                                               + "` is defined twice, in your file and in the course: remove yours, or "
                                                 "give it a name that is not taken.");
    }
    if (missing.empty())
        return broken(Kind::does_not_link, "The linker stopped: " + plain(text.substr(0, text.find('\n'))));
    std::string names;
    for (const auto &one : missing) names += (names.empty() ? "`" : ", `") + one + '`';
    return broken(Kind::does_not_link,
                  names + (missing.size() == 1 ? " is" : " are") + " declared in " + name
                      + ", and used, but never defined: write the body, or correct name and parameters.");
}

namespace {

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

std::string explain_missing(std::string_view symbols, const std::string &header, const std::string &function) {
    const std::string wanted = declaration(header, function);
    const std::string says = wanted.empty() ? "" : " The header says `" + wanted + "`";
    std::vector<std::string> others;
    for (const auto &[whole, name] : functions_in(symbols)) {
        if (name == function)
            return says + (says.empty() ? " Yours is `" : "; yours is `") + whole
                   + "`, which is another function to the compiler: copy name, parameters and namespace.";
        if (header.find(' ' + name + '(') == header.npos) others.push_back(name);
    }
    std::string near = nearest(function, others);
    if (edit_distance(near, function) > 1 + function.size() / 3) near.clear(); // a helper with a name of its own
    return says + (says.empty() ? "" : ".") + (near.empty() ? "" : " Yours has `" + near + "`: is that it, misspelt?");
}

} // namespace course
