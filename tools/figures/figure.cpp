#include "figures/figure.hpp"

#include "base/files.hpp"
#include "base/process.hpp"
#include "base/text.hpp"
#include "figures/trace.hpp"

#include <algorithm>
#include <cstring>
#include <regex>
#include <sstream>

namespace course {
namespace fs = std::filesystem;
namespace {

constexpr double longest_drawing =
    60; // [s] a figure takes a tenth; a script that pauses or loops would stop the build for ever

std::string script_name(const fs::path &script) { return "plots/" + script.filename().string(); }

/// gnuplot's complaint in one line, with the script's line in front where it says one.
std::string in_one_line(const fs::path &script, const std::string &words) {
    static const std::regex place{R"re("([^"]*)",? line (\d+): (.*))re"};
    std::istringstream lines{words};
    std::string first;
    for (std::string line; std::getline(lines, line);) {
        if (std::smatch match; std::regex_search(line, match, place))
            return "plots/" + fs::path{match[1].str()}.filename().string() + ", line " + match[2].str()
                   + ": gnuplot says \"" + match[3].str() + "\"";
        if (first.empty()) first = line;
    }
    return script_name(script) + ": gnuplot says \"" + first + "\"";
}

/// Runs the script after `before`, in the script's folder. A word on stderr is a failure: gnuplot ends with 0 even so.
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
    } catch (const UserError &) {
        throw UserError{"gnuplot, which draws the figures, is not here; ./course doctor says how to get it"};
    }
    if (done.timed_out)
        throw FigureFault{script_name(figure.script)
                          + ": gnuplot was stopped after 60 s; the script must end by itself"};
    if (done.err.find_first_not_of(" \n") != done.err.npos) throw FigureFault{in_one_line(figure.script, done.err)};
    if (done.code != 0)
        throw FigureFault{script_name(figure.script) + ": gnuplot left with exit code " + std::to_string(done.code)
                          + " and printed no error; run it by hand"};
}

struct Curve {
    std::string title;
    std::size_t points = 0, visible = 0;
};

/// What gnuplot would draw, from `set table`: each curve's points, marked i(n range), o(ut of it), u(ndefined).
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
            if (line[last] != 'u') ++curves.back().points;
            if (line[last] != 'u' && line[last] != 'o') ++curves.back().visible;
        }
    }
    return curves;
}

/// The SVG cannot tell: a curve's sample in the key looks like a curve. So gnuplot is asked for its points. (Without a
/// title, and begun outside, a wall may yet cross the picture; and what marks a student's curve may lie anywhere.)
void require_visible(const Figure &figure, const std::string &table) {
    const std::vector<Curve> curves = parse_table(table);
    for (const auto &[title, points, visible] : curves) {
        if (title.empty() && points == 0 && figure.student.empty())
            throw FigureFault{script_name(figure.script) + " has a curve without a title, and without points"};
        if (!title.empty() && visible == 0)
            throw FigureFault{script_name(figure.script) + " draws nothing for " + title
                              + (points ? ": none of its " + std::to_string(points) + " points lies inside the axes"
                                        : ": it has no points")};
    }
    if (std::ranges::all_of(curves, [](const Curve &curve) { return curve.visible == 0; }))
        throw FigureFault{script_name(figure.script) + " draws a blank figure: no curve has a point inside the axes"};
}

} // namespace

std::string figure_title(const fs::path &script) {
    static const std::regex line{R"((^|\n)#> Figure: *([^\r\n]*[^\r\n .]))"};
    const std::string text = read_file(script);
    if (std::smatch match; std::regex_search(text, match, line)) return match[2];
    throw FigureFault{script_name(script) + " doesn't say what it shows; begin it with a line \"#> Figure: ...\""};
}

bool draws_student(const fs::path &script) { return contains(read_file(script), "ARG3"); }

std::string draw(const Figure &figure) {
    const std::string title = figure_title(figure.script);
    const Colours colours = read_colours(read_file(fs::absolute(figure.script).parent_path() / "style.gp"));
    for (const fs::path &trace : {figure.trace, figure.student})
        if (!trace.empty()) read_trace(trace, trace.filename().string());

    const fs::path beginning = temporary_files() / "course-figure";
    const Scratch workshop{beginning};
    if (workshop.folder.empty())
        throw UserError{"cannot write " + beginning.string() + ".XXXXXX: " + std::strerror(workshop.error)
                        + "; set TMPDIR to a folder that is yours"};
    const fs::path svg = workshop.folder / "figure.svg", table = workshop.folder / "table";
    gnuplot(figure, "", svg);
    if (!fs::exists(svg))
        throw FigureFault{script_name(figure.script) + " writes no file; write set output ARG2 before it plots"};
    Figure asked = figure;
    if (asked.student.empty()) asked.student = asked.trace; // the place for a student's curve is looked at, too
    gnuplot(asked, "set table '" + table.string() + "'", workshop.folder / "not drawn");
    require_visible(figure, read_file(table));
    return recoloured(read_file(svg), title, colours, script_name(figure.script));
}

} // namespace course
