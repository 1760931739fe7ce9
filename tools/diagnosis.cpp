#include "diagnosis.hpp"

#include "lines.hpp"

#include <algorithm>
#include <regex>
#include <set>

namespace course {
namespace {

void replace_all(std::string &text, std::string_view old, std::string_view with) {
    for (std::size_t at = 0; (at = text.find(old, at)) != text.npos; at += with.size())
        text.replace(at, old.size(), with);
}

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

/// Curly quotes and a trailing flag, as GCC has them, made plain.
std::string plain(std::string text) {
    text = with_short_names(std::move(text));
    for (const char *quote : {"‘", "’"}) replace_all(text, quote, "'");
    if (const std::size_t flag = text.rfind(" [-W"); flag != text.npos) text.erase(flag);
    return text;
}

Verdict broken(Kind kind, std::string sentence) {
    Verdict verdict;
    verdict.kind = kind;
    verdict.sentence = std::move(sentence);
    return verdict;
}

} // namespace

std::string with_short_names(std::string text) {
    for (const char *spelling : {"Eigen::Matrix<double, 2, 1, 0, 2, 1>", "Eigen::Matrix<double, 2, 1>"})
        replace_all(text, spelling, "Vec2");
    return text;
}

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

namespace {

/// What a beginner needs to know beside the compiler's words, for the slips that are made most.
std::string advice(const std::string &error) {
    const std::pair<const char *, const char *> slips[] = {
        {"non-void function", " There is a way through this function without a `return`."},
        {"no return statement", " There is a way through this function without a `return`."},
        {"unresolved overloaded function type", " A call needs parentheses: a.x(), not a.x."},
        {"invalid use of member function", " A call needs parentheses: a.x(), not a.x."},
        {"Eigen::Product<", " For the dot product of two vectors write a.dot(b)."},
    };
    for (const auto &[words, what] : slips)
        if (error.find(words) != error.npos) return what;
    return {};
}

} // namespace

Verdict diagnose_compiler(std::string_view printed, const std::filesystem::path &file, const std::string &name) {
    const auto lines = lines_of(printed);
    Verdict verdict = broken(Kind::does_not_compile, "");
    int errors = 0;
    static const std::regex forgotten{R"(did you forget to .*(#include <\w+>))"};
    for (std::size_t i = 0; i < lines.size(); ++i) {
        auto remark = parse(lines[i], "error");
        if (!remark) remark = parse(lines[i], "fatal error");
        std::match_results<std::string_view::const_iterator> header;
        if (errors == 1 && std::regex_search(lines[i].text.begin(), lines[i].text.end(), header, forgotten))
            verdict.sentence += ". Write " + header[1].str() + " at the top of your file.";
        if (!remark || ++errors > 1) continue;
        verdict.sentence = plain(remark->what);
        if (const std::string more = advice(verdict.sentence); !more.empty()) verdict.sentence += "." + more;
        verdict.file = shown(remark->file, file, name);
        verdict.line = remark->line;
        for (std::size_t code = i + 1;
             code < lines.size() && code <= i + 2 && lines[code].text.find('|') != std::string::npos; ++code)
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
    for (const auto &line : lines_of(printed))
        if (const auto remark = parse(line, "warning"); remark && remark->file == file.string())
            warnings.push_back(name + ':' + std::to_string(remark->line) + ": " + plain(remark->what));
    return warnings;
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
        return broken(Kind::does_not_link,
                      '`' + found[1].str()
                          + "` is defined twice, in your file and in the course: rename yours, or make it `static`.");
    }
    if (missing.empty())
        return broken(Kind::does_not_link, "The linker stopped: " + plain(text.substr(0, text.find('\n'))));
    std::string names;
    for (const auto &one : missing) names += (names.empty() ? "`" : ", `") + one + '`';
    return broken(Kind::does_not_link,
                  names + (missing.size() == 1 ? " is" : " are") + " declared in " + name
                      + ", and used, but never defined: write the body, or correct name and parameters.");
}

std::vector<std::string> find_namesakes(std::string_view symbols, std::string_view function) {
    std::vector<std::string> found;
    const std::string call = std::string{function} + '(';
    for (const auto &line : lines_of(symbols)) {
        if (line.text.size() < 20) continue;
        const char kind = line.text[17];
        if (kind != 'T' && kind != 't' && kind != 'W') continue;
        const std::string name = with_short_names(std::string{line.text.substr(19)});
        const std::size_t at = name.find(call);
        if (at == 0 || (at != name.npos && at >= 2 && name.compare(at - 2, 2, "::") == 0 && name.find('<') > at))
            found.push_back(name);
    }
    return found;
}

} // namespace course
