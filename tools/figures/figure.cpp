#include "figures/figure.hpp"

#include "figures/trace.hpp"
#include "ground/files.hpp"
#include "ground/process.hpp"

#include <algorithm>
#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <regex>
#include <sstream>
#include <unistd.h>

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr double longest_drawing =
    60; // [s] a figure takes a tenth; a script that pauses or loops would stop the build for ever
constexpr const char *figure_width = "480"; // [px] as plots/style.gp has it

/// A folder for gnuplot's own output, gone in the end.
class Workshop {
  public:
    Workshop() {
        std::string name = (fs::temp_directory_path() / "course-figure.XXXXXX").string();
        if (!::mkdtemp(name.data()))
            throw Complaint{"cannot write " + name + ": " + std::strerror(errno)
                            + "; set TMPDIR to a folder that is yours"};
        folder = name;
    }
    ~Workshop() {
        std::error_code ignored;
        fs::remove_all(folder, ignored);
    }
    Workshop(const Workshop &) = delete;
    Workshop &operator=(const Workshop &) = delete;
    fs::path folder;
};

std::string shown(const fs::path &script) { return "plots/" + script.filename().string(); }

/// The script without its comments, line by line as long as before; a continued line's backslash is a blank.
std::string without_comments(std::string_view script) {
    std::string code{script};
    char quote = 0;
    bool comment = false;
    for (std::size_t i = 0; i < code.size(); ++i) {
        if (code[i] == '\n') quote = 0, comment = false;
        else if (comment) code[i] = ' ';
        else if (quote) quote = code[i] == quote ? '\0' : quote;
        else if (code[i] == '\'' || code[i] == '"') quote = code[i];
        else if (code[i] == '#') comment = true, code[i] = ' ';
        if (code[i] == '\\' && (i + 1 == code.size() || code[i + 1] == '\n')) code[i] = ' ';
    }
    return code;
}

/// From here to the first blank that is not in brackets: what follows `using`.
std::string_view specification(std::string_view code) {
    int depth = 0;
    std::size_t end = 0;
    for (; end < code.size(); ++end) {
        if (code[end] == '(') ++depth;
        if (code[end] == ')') --depth;
        if (depth <= 0 && std::strchr(" \n,;\"'", code[end])) break;
    }
    return code.substr(0, end);
}

/// The columns in `1:($2 > 0 ? $3 : NaN):(column(4))`; 0 and less are gnuplot's own.
std::vector<std::size_t> columns_of(std::string_view specification) {
    static const std::regex asked{R"(\$(\d+)|column\(\s*(\d+)\s*\)|valid\(\s*(\d+)\s*\))"};
    std::vector<std::size_t> columns;
    const auto add = [&](const std::string &digits) {
        const auto column = static_cast<std::size_t>(std::atoll(digits.c_str()));
        if (column > 0) columns.push_back(column);
    };
    std::string plain;
    int depth = 0;
    for (char c : specification) {
        if (c == '(') ++depth;
        if (depth == 0) plain += c;
        if (c == ')') --depth;
    }
    std::istringstream parts{plain};
    for (std::string part; std::getline(parts, part, ':');)
        if (!part.empty() && part.find_first_not_of("0123456789") == part.npos) add(part);
    const std::string all{specification};
    for (std::sregex_iterator found{all.begin(), all.end(), asked}, end; found != end; ++found)
        for (std::size_t group = 1; group < found->size(); ++group)
            if ((*found)[group].matched) add((*found)[group]);
    return columns;
}

std::string names_of(const Trace &trace) {
    std::string all;
    for (std::size_t i = 0; i < trace.columns.size(); ++i)
        all += (i ? ", " : "") + std::to_string(i + 1) + " " + trace.columns[i];
    return all;
}

void require_columns(const Figure &figure, const Trace &trace) {
    for (const auto &[line, column] : columns_used(read_file(figure.script)))
        if (column > trace.columns.size())
            throw FigureFault{shown(figure.script) + ", line " + std::to_string(line) + ": column "
                              + std::to_string(column) + " is drawn, but " + figure.trace.filename().string()
                              + " has only " + names_of(trace)};
}

/// gnuplot's complaint in one line, with the script's line in front where it says one.
std::string in_one_line(const fs::path &script, const std::string &words) {
    static const std::regex place{R"re("([^"]*)",? line (\d+): (.*))re"};
    std::istringstream lines{words};
    std::string first;
    for (std::string line; std::getline(lines, line);) {
        if (std::smatch found; std::regex_search(line, found, place))
            return "plots/" + fs::path{found[1].str()}.filename().string() + ", line " + found[2].str()
                   + ": gnuplot says \"" + found[3].str() + "\"";
        if (first.empty()) first = line;
    }
    return shown(script) + ": gnuplot says \"" + first + "\"";
}

/// Runs the script after `before`, in its own folder. A word on stderr is a failure: gnuplot ends with 0 even so.
void gnuplot(const Figure &figure, const std::string &before, const fs::path &svg) {
    std::vector<std::string> command{"gnuplot", "-d"}; // -d: no settings of the reader's own
    if (!before.empty()) command.insert(command.end(), {"-e", before});
    command.insert(command.end(),
                   {"-c", figure.script.filename().string(), fs::absolute(figure.trace).string(), svg.string()});
    if (!figure.student.empty()) command.push_back(fs::absolute(figure.student).string());

    Finished done;
    try {
        done = run(command,
                   {.quiet = true, .deadline = longest_drawing, .folder = fs::absolute(figure.script).parent_path()});
    } catch (const Complaint &) {
        throw Complaint{"gnuplot, which draws the figures, is not here; ./course doctor says how to get it"};
    }
    if (done.timed_out)
        throw FigureFault{shown(figure.script) + ": gnuplot was stopped after 60 s; the script must end by itself"};
    if (done.err.find_first_not_of(" \n") != done.err.npos) throw FigureFault{in_one_line(figure.script, done.err)};
    if (done.code != 0)
        throw FigureFault{shown(figure.script) + ": gnuplot left with exit code " + std::to_string(done.code)
                          + " and printed no error; run it by hand"};
}

struct Curve {
    std::string title;
    std::size_t points = 0, visible = 0;
};

/// What gnuplot would draw, from its `set table`: each curve's points, marked i(n range), o(ut of it), u(ndefined).
std::vector<Curve> parse_table(const std::string &table) {
    std::vector<Curve> curves;
    std::istringstream lines{table};
    constexpr std::string_view title = "# Curve title: ";
    for (std::string line; std::getline(lines, line);) {
        if (line.starts_with(title)) {
            if (!curves.empty()) curves.back().title = line.substr(title.size());
        } else if (line.starts_with("# Curve ")) {
            curves.emplace_back();
        } else if (const auto last = line.find_last_not_of(' ');
                   last != line.npos && line[0] != '#' && !curves.empty()) {
            ++curves.back().points;
            if (line[last] != 'u' && line[last] != 'o') ++curves.back().visible;
        }
    }
    return curves;
}

/// The SVG cannot tell: a curve's sample in the key looks like a curve. So gnuplot is asked for its points.
void require_visible(const Figure &figure, const std::string &table) {
    bool anything = false;
    for (const Curve &curve : parse_table(table)) {
        anything = anything || curve.visible > 0;
        if (curve.visible == 0 && !curve.title.empty())
            throw FigureFault{shown(figure.script) + " draws nothing for " + curve.title
                              + (curve.points
                                     ? ": none of its " + std::to_string(curve.points) + " points lies inside the axes"
                                     : ": it has no points")};
    }
    if (!anything)
        throw FigureFault{shown(figure.script) + " draws a blank figure: no curve has a point inside the axes"};
}

/// Another width has other letters: on a phone, too small ones.
void require_width(const Figure &figure, const std::string &svg) {
    static const std::regex width{R"re(<svg\s[^>]*\bwidth="([0-9]+)")re"};
    if (std::smatch found; std::regex_search(svg, found, width) && found[1] != figure_width)
        throw FigureFault{shown(figure.script) + " is " + found[1].str() + " px wide, and all figures are "
                          + figure_width + ", so that their letters can be read on a phone; write "
                          + "eval canvas(HEIGHT) in place of set terminal"};
}

} // namespace

std::string figure_title(const fs::path &script) {
    static const std::regex line{R"((^|\n)#> Figure: *([^\r\n]*[^\r\n .]))"};
    const std::string text = read_file(script);
    if (std::smatch found; std::regex_search(text, found, line)) return found[2];
    throw FigureFault{shown(script) + " doesn't say what it shows; begin it with a line \"#> Figure: ...\""};
}

std::vector<ColumnUse> columns_used(std::string_view script) {
    static const std::regex start{R"(\bARG[13](\s+(every|index|skip)\s+\S+)*\s+u(sing|sin|si|s)?\s+)"};
    const std::string code = without_comments(script);
    std::vector<ColumnUse> uses;
    for (std::sregex_iterator found{code.begin(), code.end(), start}, end; found != end; ++found) {
        const auto at = static_cast<std::size_t>(found->position() + found->length());
        const auto line =
            1 + static_cast<std::size_t>(std::count(code.begin(), code.begin() + found->position(), '\n'));
        for (std::size_t column : columns_of(specification(std::string_view{code}.substr(at))))
            uses.push_back({line, column});
    }
    return uses;
}

bool draws_student(const fs::path &script) {
    return without_comments(read_file(script)).find("ARG3") != std::string::npos;
}

std::string draw(const Figure &figure) {
    const std::string title = figure_title(figure.script);
    const Colours colours = read_colours(read_file(fs::absolute(figure.script).parent_path() / "style.gp"));
    require_columns(figure, read_trace(figure.trace, figure.trace.filename().string()));
    if (!figure.student.empty()) read_trace(figure.student, figure.student.filename().string());

    const Workshop workshop;
    const fs::path svg = workshop.folder / "figure.svg", table = workshop.folder / "table";
    gnuplot(figure, "", svg);
    if (!fs::exists(svg))
        throw FigureFault{shown(figure.script) + " writes no file; write set output ARG2 before it plots"};
    gnuplot(figure, "set table '" + table.string() + "'", workshop.folder / "not drawn");
    require_visible(figure, read_file(table));
    require_width(figure, read_file(svg));
    return recoloured(read_file(svg), title, colours, shown(figure.script));
}

} // namespace course
