#include "loop/diagnosis.hpp"

#include "ground/lines.hpp"
#include "ground/nearest.hpp"
#include "loop/advice.hpp"

#include <algorithm>
#include <regex>
#include <set>
#include <utility>

namespace course {
namespace {

/// "/long/path/07_x.cpp:12:5: error: 'a' was not declared": where and what.
struct Remark {
    std::string file;
    int line = 0;
    std::string what;
};

std::optional<Remark> parse(const Line &whole, const std::string &severity) {
    const std::string line{whole.text};
    const std::size_t mark = line.find(": " + severity + ": ");
    if (mark == line.npos) return {};
    static const std::regex place{R"(^(.*?):(\d+)(?::\d+)?$)"};
    std::smatch found;
    const std::string before = line.substr(0, mark);
    if (!std::regex_match(before, found, place)) return Remark{before, 0, line.substr(mark + severity.size() + 4)};
    return Remark{found[1], std::stoi(found[2]), line.substr(mark + severity.size() + 4)};
}

std::string shown(const std::string &file, const std::filesystem::path &students, const std::string &shown_name) {
    return file == students.string() ? shown_name : std::filesystem::path{file}.filename().string();
}

/// What the compiler says, with plain quotes and short names, without the flag behind it; and what it means.
std::string plain(const std::string &said) {
    static const std::regex quote{"‘|’"}, flag{R"( \[-W.*)"};
    const std::string text = with_short_names(std::regex_replace(std::regex_replace(said, quote, "'"), flag, ""));
    const std::string more = advice(text);
    return more.empty() ? text : text + ". " + more;
}

/// Where in the student's file a remark has its cause, that is made in a file which the student only uses:
/// "07_x.cpp:26:26:   required from here", or "inlined from 'f' at 07_x.cpp:43:18".
class Causes {
  public:
    explicit Causes(const std::filesystem::path &file) : place{quoted(file.string()) + R"(:(\d+))"} {}

    void read(const Line &line) {
        std::match_results<std::string_view::const_iterator> found;
        const bool tells =
            line.text.find("required from") != line.text.npos || line.text.find("inlined from") != line.text.npos;
        if (tells && std::regex_search(line.text.begin(), line.text.end(), found, place)) last = std::stoi(found[1]);
    }
    /// The remark, moved to its cause if there is one; the next remark has a cause of its own.
    Remark at_its_cause(Remark remark, const std::filesystem::path &file) {
        const int line = std::exchange(last, 0);
        return line == 0 || remark.file == file.string() ? remark : Remark{file.string(), line, remark.what};
    }

  private:
    static std::string quoted(const std::string &path) {
        static const std::regex special{R"([.^$|()\[\]{}*+?\\])"};
        return std::regex_replace(path, special, R"(\$&)");
    }
    std::regex place;
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
    static const std::regex forgotten{R"(did you forget to .*(#include <\w+>))"};
    Causes causes{file};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        causes.read(lines[i]);
        auto remark = parse(lines[i], "error");
        if (!remark) remark = parse(lines[i], "fatal error");
        std::match_results<std::string_view::const_iterator> header;
        if (errors == 1 && std::regex_search(lines[i].text.begin(), lines[i].text.end(), header, forgotten))
            verdict.sentence += ". Write " + header[1].str() + " at the top of your file.";
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

Verdict diagnose_linker(std::string_view printed, const std::string &name, const std::string &number) {
    static const std::regex undefined{"undefined reference to [`']([^']+)'"},
        twice{"multiple definition of [`']([^']+)'"};
    std::set<std::string> missing;
    const std::string text = with_short_names(std::string{printed});
    for (std::sregex_iterator it{text.begin(), text.end(), undefined}, end; it != end; ++it) missing.insert((*it)[1]);
    if (std::smatch found; std::regex_search(text, found, twice)) {
        if (found[1] == "main")
            return broken(Kind::does_not_link,
                          "Your file has a `main` of its own. The course has one already: remove yours. "
                          "`./course run "
                              + number + " --mine` runs the section's program with your code.");
        return broken(Kind::does_not_link, '`' + found[1].str()
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
    std::smatch found;
    if (!std::regex_search(header, found, std::regex{R"(\n([A-Za-z][^\n;{}]* )" + function + R"(\([^;{}]*\);))"}))
        return {};
    static const std::regex blanks{R"(\s+)"};
    return std::regex_replace(found[1].str(), blanks, " ");
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
