// What can go wrong between a program's trace and a published figure, each with the sentence that says so.

#include "base/files.hpp"
#include "base/kernel.hpp"
#include "check/programs.hpp"
#include "commands/commands.hpp"
#include "figures/figure.hpp"
#include "figures/section_figures.hpp"
#include "figures/trace.hpp"
#include "judge/runner/sandbox.hpp"
#include "small_course.hpp"

#include <catch2/catch_test_macros.hpp>
#include <catch2/matchers/catch_matchers_string.hpp>
#include <cstdlib>
#include <filesystem>
#include <functional>
#include <iostream>
#include <regex>
#include <sstream>
#include <string>
#include <unistd.h>

using namespace course;
namespace fs = std::filesystem;
using Catch::Matchers::ContainsSubstring;
using Catch::Matchers::Equals;
using Catch::Matchers::StartsWith;

namespace {

/// A small course in a folder of its own, gone in the end: one section, one figure.
struct Place {
    Place() {
        workspace = {folder.path, folder.path / "build"};
        write("CMakeLists.txt", "section(07_lines)\n");
        write("plots/style.gp", read_file(fs::path{COURSE_ROOT} / "plots/style.gp"));
        write("plots/07_lines_rise.gp", script("using 1:2 with lines title 'rise'"));
        write("build/traces/07_lines/07_lines_rise.tsv", good_trace);
    }

    void write(const fs::path &name, const std::string &text) const { write_file(workspace.root / name, text); }
    std::string read(const fs::path &name) const { return read_file(workspace.root / name); }

    static std::string script(const std::string &curve) {
        return "#> Figure: a line that rises\nload 'style.gp'\nset output ARG2\nset xrange [0:4]; set yrange "
               "[0:5]\nplot ARG1 "
               + curve + '\n';
    }
    static constexpr const char *good_trace = "# t[s]\tx[m]\n0\t1\n1\t2\n\n2\t2.5\n3\t4\n";

    Figure figure() const { return figures_of(workspace, section).at(0); }
    OwnFolder folder;
    Workspace workspace;
    Section section{"07_lines"};
};

std::string refusal(const std::function<void()> &action) {
    try {
        action();
    } catch (const UserError &complaint) {
        return complaint.what();
    }
    return "nothing was refused";
}

/// What is said of the figure when this is its script.
std::string said_of_script(const std::string &script) {
    const Place place;
    place.write("plots/07_lines_rise.gp", script);
    return refusal([&] { draw(place.figure()); });
}

/// The same of a script that ends in this curve.
std::string said_of_curve(const std::string &curve) { return said_of_script(Place::script(curve)); }

std::string said_of_trace(const std::string &trace) {
    return refusal([&] { parse_trace(trace, "x.tsv"); });
}

/// The course's own command line with `draw` in it.
void course_draw(const std::vector<std::string> &words) {
    CLI::App app;
    const Workspace workspace;
    add_draw(app, workspace);
    std::vector<std::string> reversed{words.rbegin(), words.rend()}; // as CLI11 wants it
    reversed.push_back("draw");
    app.parse(reversed);
}

} // namespace

// Drawing

TEST_CASE("a figure is drawn, says what it shows, and is the same on every run") {
    const Place place;
    const std::string svg = draw(place.figure());
    CHECK_THAT(svg, ContainsSubstring("<title>a line that rises</title>") && ContainsSubstring(">rise</"));
    CHECK_THAT(svg, !ContainsSubstring("GNUPLOT") && !ContainsSubstring("<desc>"));
    CHECK(svg == draw(place.figure()));
}

TEST_CASE("a figure follows its reader's colour scheme, and shows a light one where there are no style sheets") {
    const Place place;
    place.write(
        "plots/07_lines_rise.gp",
        Place::script("using 1:2 with linespoints title 'rise', ARG1 using 1:2 with points lc rgb INK notitle"));
    const std::string svg = draw(place.figure());
    CHECK_THAT(svg, ContainsSubstring("@media (prefers-color-scheme: dark)")
                        && ContainsSubstring("color-scheme: light dark"));

    const Colours colours = read_colours(place.read("plots/style.gp"));
    static const std::regex painted{R"re( (fill|stroke|color)="([^"]*)")re"};
    const std::string drawing = svg.substr(svg.find("</style>"));
    std::size_t counted = 0;
    for (std::sregex_iterator found{drawing.begin(), drawing.end(), painted}, end; found != end; ++found) {
        const std::string attribute = (*found)[1], colour = (*found)[2];
        if (colour == "none" || colour == "currentColor") continue;
        CAPTURE(attribute, colour);
        REQUIRE(colours.dark.contains(colour));
        CHECK_THAT(svg, ContainsSubstring("[" + attribute + "=\"" + colour + "\"] { " + attribute + ": "
                                          + colours.dark.at(colour) + " }"));
        ++counted;
    }
    CHECK(counted > 20);
}

TEST_CASE("words without a colour of their own are ink, not black") {
    const Place place;
    place.write("plots/07_lines_rise.gp", "#> Figure: x\nload 'style.gp'\nset output ARG2\nset label 'here' at 1,2\n"
                                          "plot ARG1 using 1:2 with lines lt -1 title 'rise'\n");
    const std::string svg = draw(place.figure());
    CHECK_THAT(svg, !ContainsSubstring("black") && !ContainsSubstring("\"#000000\""));
}

TEST_CASE("a colour without a counterpart for dark pages is refused") {
    CHECK_THAT(said_of_curve("using 1:2 with lines lc rgb '#00ff00'"),
               ContainsSubstring("07_lines_rise.gp draws in #00ff00"));
    CHECK_THAT(said_of_curve("using 1:2 with lines lc 'white'"), ContainsSubstring("draws in #ffffff"));
}

TEST_CASE("a colour of the style without its twin is refused") {
    CHECK_THAT(refusal([] { read_colours("INK = \"#1d2430\" # dark: #e3e8f0\nDIM = \"#66707f\"\n"); }),
               ContainsSubstring("style.gp, line 2") && ContainsSubstring("#66707f"));
    CHECK_THAT(refusal([] { read_colours("DIM = \"#66707f\" # dark: #e3e8f0\n"); }), ContainsSubstring("INK"));
}

TEST_CASE("a curve without a point inside the axes is refused, though its sample in the key is drawn") {
    CHECK_THAT(said_of_curve("using ($1 + 100):2 with lines title 'far'"),
               ContainsSubstring("\"far\"") && ContainsSubstring("none of its 4"));
    CHECK_THAT(said_of_curve("using 1:2 with lines title 'rise', NaN title 'nothing'"),
               ContainsSubstring("\"nothing\""));
    CHECK_THAT(said_of_curve("using ($1 + 100):2 with lines notitle"), ContainsSubstring("blank"));
}

TEST_CASE("a script that plots nothing is refused") {
    CHECK_THAT(said_of_script("#> Figure: x\nload 'style.gp'\nset output ARG2\n"),
               ContainsSubstring("plots/07_lines_rise.gp") && ContainsSubstring("blank"));
}

TEST_CASE("a column that the trace doesn't have is refused with its line, that of a student's curve without one, too") {
    const auto refused = StartsWith("plots/07_lines_rise.gp, line 5: gnuplot says \"warning: Skipping data file");
    CHECK_THAT(said_of_curve("using 1:3 with lines"), refused);
    CHECK_THAT(said_of_curve("using 1:2 with lines, ARG1 using 1:(column(4)) notitle"),
               Equals("plots/07_lines_rise.gp has a curve without a title, and without points"));
    const std::string yours = "#> Figure: x\nload 'style.gp'\nset output ARG2\nyours = with_yours(\"ARG3 using 1:";
    CHECK_THAT(said_of_script(yours + "3 notitle\")\nplot ARG1 using 1:2, @yours\n"), refused);
    CHECK_THAT(said_of_script(yours + "2 notitle\")\nplot ARG1 using 1:2, @yours\n"), Equals("nothing was refused"));
}

TEST_CASE("any word of gnuplot's is a failure, with file and line") {
    CHECK_THAT(
        said_of_curve("using 1:2 with lines title 'rise', no_such_function(x)"),
        ContainsSubstring("plots/07_lines_rise.gp, line 5: gnuplot says \"undefined function: no_such_function"));
    CHECK_THAT(said_of_curve("using 1:2 with lines notitle, 'gone.tsv' using 1:2 notitle"),
               ContainsSubstring("gone.tsv"));
    CHECK_THAT(said_of_curve("using 1:2 with lines title 'rise'; print 'a word'"),
               ContainsSubstring("gnuplot says \"a word\""));
}

TEST_CASE("a script that doesn't say what it shows is refused") {
    CHECK_THAT(said_of_script("load 'style.gp'\nset output ARG2\nplot ARG1 using 1:2\n"),
               ContainsSubstring("#> Figure: "));
}

TEST_CASE("a script that forgets its output or its style is refused") {
    CHECK_THAT(said_of_script("#> Figure: x\nload 'style.gp'\nplot ARG1 using 1:2 with lines\n"),
               ContainsSubstring("set output ARG2"));
    CHECK_THAT(said_of_script("#> Figure: x\nset terminal png\nset output ARG2\nplot ARG1 using 1:2 with lines\n"),
               ContainsSubstring("load 'style.gp'"));
}

TEST_CASE("without gnuplot one sentence says how to get it") {
    const Place place;
    const OnlyPath nowhere{place.workspace.root};
    CHECK_THAT(refusal([&] { draw(place.figure()); }),
               ContainsSubstring("gnuplot, which draws the figures, is not here")
                   && ContainsSubstring("./course doctor"));
}

TEST_CASE("`course draw` writes the figure, and says which file it cannot write") {
    const Place place;
    const std::string script = place.figure().script, trace = place.figure().trace,
                      out = place.workspace.root / "new/rise.svg";
    course_draw({"--script", script, "--trace", trace, "--out", out});
    CHECK(read_file(out) == draw(place.figure()));

    const std::string blocked = out + "/rise.svg"; // a file stands where its folder should be
    CHECK_THAT(refusal([&] {
                   course_draw({"--script", script, "--trace", trace, "--out", blocked});
               }),
               ContainsSubstring("cannot write " + blocked));
}

TEST_CASE("a student's curve is drawn over the reference's where the script has a place for it") {
    const Place place;
    place.write("plots/07_lines_rise.gp", "#> Figure: x\nload 'style.gp'\nset output ARG2\n"
                                          "yours = with_yours(\"ARG3 using 1:2 with lines lt 2 title 'yours'\")\n"
                                          "plot ARG1 using 1:2 with lines title 'reference', @yours\n");
    place.write("mine's.tsv", "# t[s]\tx[m]\n0\t1\n3\t2\n");
    Figure figure = place.figure();
    CHECK(draws_student(figure.script));
    CHECK_THAT(draw(figure), !ContainsSubstring("yours"));
    figure.student = place.workspace.root / "mine's.tsv";
    CHECK_THAT(draw(figure), ContainsSubstring(">yours</"));

    place.write("mine's.tsv", "# t[s]\tx[m]\n0\tnan\n3\t2\n");
    CHECK_THROWS_AS(draw(figure), TraceFault);
}

// Traces

TEST_CASE("a trace is read: columns, rows, gaps") {
    const Trace trace = parse_trace("# t[s]\tfrom x[m/s]\n0\t-1.5e-3\n\n2\t4\n", "x.tsv");
    CHECK(trace.columns == std::vector<std::string>{"t[s]", "from x[m/s]"});
    REQUIRE(trace.rows.size() == 3);
    CHECK(trace.rows[0].values == std::vector{0.0, -1.5e-3});
    CHECK(trace.rows[1].values.empty());
    CHECK(trace.rows[2].values == std::vector{2.0, 4.0});
    CHECK(parse_trace("# t[s]\tx[m]\r\n0\t1\r\n2\t3\r\n", "x.tsv").rows[1].values == std::vector{2.0, 3.0});
}

TEST_CASE("a trace that cannot be drawn is refused with its line and column") {
    CHECK_THAT(said_of_trace(""), ContainsSubstring("x.tsv is empty"));
    CHECK_THAT(said_of_trace("# t[s]\tx[m]\n"), ContainsSubstring("x.tsv has 0 rows"));
    CHECK_THAT(said_of_trace("# t[s]\tx[m]\n0\t1\n\n"), ContainsSubstring("x.tsv has 1 row;"));
    CHECK_THAT(said_of_trace("0\t1\n1\t2\n"), ContainsSubstring("line 1"));
    CHECK_THAT(said_of_trace("# t\tx[m]\n0\t1\n1\t2\n"), ContainsSubstring("\"t\" has no unit"));
    CHECK_THAT(said_of_trace("# t[s]\tx[m]\n0\t1\n1\n2\t3\n"), ContainsSubstring("x.tsv, line 3 has 1 numbers"));
    CHECK_THAT(said_of_trace("# t[s]\tx[m]\n0\t1\n1\t2\t3\n"), ContainsSubstring("line 3 has 3 numbers"));
    CHECK_THAT(said_of_trace("# t[s]\tx[m]\n0\t1\n1\tnan\n"),
               ContainsSubstring("line 3, column x[m]: nan cannot be drawn"));
    CHECK_THAT(said_of_trace("# t[s]\tx[m]\n0\t-inf\n1\t2\n"), ContainsSubstring("line 2, column x[m]: -inf"));
    CHECK_THAT(said_of_trace("# t[s]\tx[m]\n0\t1m\n1\t2\n"), ContainsSubstring("\"1m\" is no number"));
    CHECK_THAT(said_of_trace("# t[s]\tx[m]\n0\t\n1\t2\n"), ContainsSubstring("\"\" is no number"));
}

TEST_CASE("a trace that isn't there is refused, with where it comes from") {
    const Place place;
    fs::remove(place.figure().trace);
    CHECK_THAT(refusal([&] { draw(place.figure()); }),
               ContainsSubstring("07_lines_rise.tsv is not there") && ContainsSubstring("--out"));
}

// Keeping traces

TEST_CASE("a kept trace has six digits and no negative zero") {
    CHECK(rounded(parse_trace("# t[s]\tx[m]\n0.123456789\t-0.0\n\n123456789\t1e-20\n", "x.tsv"))
          == "# t[s]\tx[m]\n0.123457\t0\n\n1.23457e+08\t1e-20\n");
}

namespace {
std::string changed(const std::string &kept, const std::string &now) {
    return difference(parse_trace("# t[s]\tx[m]\n" + kept, "k.tsv"), parse_trace("# t[s]\tx[m]\n" + now, "n.tsv"),
                      "k.tsv");
}
} // namespace

TEST_CASE("a kept trace agrees with the one that it was rounded from, and with the last digits of another compiler") {
    const std::string now = "0\t0.12345649999999\n1\t-98765.449999\n2\t1e-9\n3\t9.9999949\n4\t99999950\n";
    const std::string kept = rounded(parse_trace("# t[s]\tx[m]\n" + now, "n.tsv"));
    CHECK(changed(kept.substr(kept.find('\n') + 1), now) == "");
    CHECK(changed("0\t1.23457\n1\t2\n", "0\t1.23457812\n1\t2\n") == ""); // the eighth digit, and most of the seventh
    CHECK(changed("0\t1000\n1\t0\n", "0\t1000\n1\t-3e-13\n") == "");     // a zero with its rounding
}

TEST_CASE("a change in the sixth digit of a kept trace is found, with row, column, was and is") {
    CHECK(changed("0\t1.23457\n1\t2\n", "0\t1.23459\n1\t2\n")
          == "k.tsv, row 1, column x[m]: it was 1.23457, it is 1.23459");
    CHECK_THAT(changed("0\t1\n1\t2\n", "0\t1\n1\t-2\n"), ContainsSubstring("row 2, column x[m]: it was 2, it is -2"));
    CHECK_THAT(changed("0\t1\n1\t0\n", "0\t1\n1\t1e-9\n"), ContainsSubstring("it was 0, it is 1e-09"));
    CHECK_THAT(changed("0\t1e-6\n1\t1\n", "0\t1.0001e-6\n1\t1\n"), ContainsSubstring("it was 1e-06, it is 1.0001e-06"));
}

TEST_CASE("a missing row, another gap, another column of a kept trace is found") {
    CHECK(changed("0\t1\n1\t2\n2\t3\n", "0\t1\n1\t2\n") == "k.tsv: it had 3 rows, it has 2");
    CHECK(changed("0\t1\n1\t2\n", "0\t1\n1\t2\n2\t3\n") == "k.tsv: it had 2 rows, it has 3");
    CHECK(changed("0\t1\n\n1\t2\n", "0\t1\n0\t1\n1\t2\n") == "k.tsv, row 2: it was a gap, it is a row");
    const Trace kept = parse_trace("# t[s]\tx[m]\n0\t1\n1\t2\n", "k"),
                now = parse_trace("# t[s]\ty[m]\n0\t1\n1\t2\n", "n");
    CHECK(difference(kept, now, "k.tsv") == "k.tsv, the columns: they were t[s], x[m], they are t[s], y[m]");
}

// Publishing

TEST_CASE("after publishing figure and trace, the check finds no difference") {
    const Place place;
    place.write("build/plots/07_lines_rise.svg", draw(place.figure()));
    CHECK(outdated(place.workspace, place.section).size() == 2); // neither is there yet
    CHECK(publish(place.workspace, place.section).size() == 2);
    CHECK(place.read("plots/07_lines_rise.svg") == draw(place.figure()));
    CHECK(place.read("plots/07_lines_rise.tsv") == Place::good_trace);
    CHECK(outdated(place.workspace, place.section).empty());
    CHECK(publish(place.workspace, place.section).empty());
    CHECK(strays(place.workspace).empty());
}

TEST_CASE("a kept trace that is still true keeps its digits, one that is not is replaced") {
    const Place place;
    place.write("build/plots/07_lines_rise.svg", "<svg/>");
    publish(place.workspace, place.section);
    place.write("build/traces/07_lines/07_lines_rise.tsv", "# t[s]\tx[m]\n0\t1.000006\n1\t2\n\n2\t2.5\n3\t4\n");
    CHECK(publish(place.workspace, place.section).empty());
    place.write("build/traces/07_lines/07_lines_rise.tsv", "# t[s]\tx[m]\n0\t1.3\n1\t2\n\n2\t2.5\n3\t4\n");
    CHECK(outdated(place.workspace, place.section)
          == std::vector<std::string>{"plots/07_lines_rise.tsv, row 1, column x[m]: it was 1, it is 1.3"});
    CHECK(publish(place.workspace, place.section).size() == 1);
    CHECK(outdated(place.workspace, place.section).empty());
}

TEST_CASE("a measured figure is drawn from the kept trace, and a later measurement does not contradict it") {
    const Place place;
    fs::rename(place.workspace.root / "plots/07_lines_rise.gp",
               place.workspace.root / "plots/07_lines_measured_rise.gp");
    place.write("plots/07_lines_measured_rise.tsv", Place::good_trace);
    place.write("build/traces/07_lines/07_lines_measured_rise.tsv", "# t[s]\tx[m]\n0\t9\n1\t9\n");
    CHECK(place.figure().is_measured());
    place.write("build/plots/07_lines_measured_rise.svg", draw(place.figure()));
    CHECK(publish(place.workspace, place.section).size() == 1); // the figure, and never a trace
    CHECK(place.read("plots/07_lines_measured_rise.tsv") == Place::good_trace);
    CHECK(outdated(place.workspace, place.section).empty());
}

TEST_CASE("a damaged kept trace is a difference, and publishing mends it") {
    const Place place;
    place.write("build/plots/07_lines_rise.svg", "<svg/>");
    place.write("plots/07_lines_rise.svg", "<svg/>");
    place.write("plots/07_lines_rise.tsv", "<<<<<<< ours\n");
    REQUIRE(outdated(place.workspace, place.section).size() == 1);
    CHECK_THAT(outdated(place.workspace, place.section)[0], ContainsSubstring("plots/07_lines_rise.tsv, line 1"));
    publish(place.workspace, place.section);
    CHECK(outdated(place.workspace, place.section).empty());
}

TEST_CASE(
    "every published figure is as wide as all are, and has the words at its axes: gnuplot drops what has no room") {
    static const std::regex axis{"set [xy]label '([^']*)'"};
    std::size_t counted = 0;
    const Workspace workspace{COURSE_ROOT, COURSE_BUILD};
    for (const Section &section : workspace.sections())
        for (const Figure &figure : figures_of(workspace, section)) {
            const std::string script = read_file(figure.script);
            const std::string picture = read_file(workspace.root / "plots" / (figure.name() + ".svg"));
            CAPTURE(figure.name());
            CHECK_THAT(picture, ContainsSubstring("<svg width=\"480\""));
            for (std::sregex_iterator found{script.begin(), script.end(), axis}, end; found != end; ++found) {
                CHECK_THAT(picture, ContainsSubstring((*found)[1]));
                ++counted;
            }
        }
    CHECK(counted > 40);
}

TEST_CASE("files in plots/ without a section or without a script are found") {
    const Place place;
    place.write("plots/08_gone_x.gp", "");
    place.write("plots/07_lines_fall.svg", "");
    place.write("plots/07_lines_fall.tsv", "");
    place.write("plots/notes.txt", "");
    const auto found = strays(place.workspace);
    REQUIRE(found.size() == 3);
    CHECK_THAT(found[0], ContainsSubstring("07_lines_fall.svg has no script"));
    CHECK_THAT(found[1], ContainsSubstring("07_lines_fall.tsv has no script"));
    CHECK_THAT(found[2], ContainsSubstring("08_gone_x.gp belongs to no section"));
}

// A student's program: here a shell script, behind a cmake that has nothing to do.

namespace {

/// A place with a student's program that does this.
struct StudentPlace : Place {
    explicit StudentPlace(const std::string &program, const std::string &cmake = "exit 0") {
        command("bin/cmake", cmake);
        command("build/mine/07_lines", program);
        write("exercises/07_lines.cpp", "");
    }
    void command(const fs::path &name, const std::string &script) const {
        write(name, "#!/bin/sh\n" + script + '\n');
        fs::permissions(workspace.root / name, fs::perms::owner_all);
    }
    OnlyPath path{(workspace.root / "bin").string() + ":/usr/bin:/bin"};
};

/// What is said of a student's program that does this.
Ran ran(const std::string &program, const std::string &cmake = "exit 0") {
    const StudentPlace place{program, cmake};
    place.write("build/mine/traces/07_lines/old.tsv", "");
    const fs::path traces = student_traces(place.workspace, place.section);
    const Ran result = run_program(place.workspace, place.section, Whose::student, traces, "", 0.6);
    CHECK(fs::exists(traces / "old.tsv") != result.started); // no trace of an earlier run survives
    return result;
}

} // namespace

TEST_CASE("a student's program that runs well is run with --out, and what it prints is kept") {
    const Ran done = ran("echo \"$1\"; echo words >&2");
    CHECK(done.started);
    CHECK(done.trouble == "");
    CHECK(done.finished.out == "--out\n");
    CHECK(done.finished.err == "words\n");
    CHECK(ran("ulimit -f").finished.out == "204800\n"); // of 512 bytes: no file of a student's fills the disk
    CHECK(ran("ulimit -c").finished.out == "0\n");
    CHECK(ran("ulimit -v").finished.out == (sanitized ? "unlimited\n" : "4194304\n"));
}

TEST_CASE("a student's program writes its traces, and can neither read other files, write them, nor start a program") {
    const auto protection = protection_of_this_kernel();
    if (!protection.files || !protection.calls) SKIP("this kernel lacks Landlock or seccomp");
    CHECK(ran("echo 1 >here.tsv && read line <here.tsv && echo $line").finished.out == "1\n");
    for (const char *attempt : {"read line <../../../../exercises/07_lines.cpp", "echo 1 >../other.tsv", "(:)"})
        CHECK(ran(std::string{"exec 2>&1; "} + attempt + " && echo done").finished.out.find("done")
              == std::string::npos);
    ::setenv("A_SECRET_OF_CI", "told", 1);
    CHECK(ran("echo $A_SECRET_OF_CI").finished.out == "\n");
    ::unsetenv("A_SECRET_OF_CI");
}

TEST_CASE("each way in which a student's program can fail has its sentence") {
    CHECK_THAT(ran("while :; do :; done").trouble,
               ContainsSubstring("after 1 s, it wouldn't end") && ContainsSubstring("./course check 7"));
    CHECK_THAT(ran("kill -SEGV $$").trouble, ContainsSubstring("crashed: it used memory that isn't its own"));
    CHECK_THAT(ran("kill -ABRT $$").trouble, ContainsSubstring("was stopped by an uncaught exception"));
    CHECK_THAT(ran("echo 'not started: a.tsv: begin here' >&2; exit 1").trouble, ContainsSubstring("aren't started"));
    CHECK_THAT(ran("echo 'error: a.tsv: radius is -1' >&2; exit 1").trouble,
               ContainsSubstring("one of your functions threw"));
    CHECK_THAT(ran("echo 'a word' >&2; exit 1").trouble,
               ContainsSubstring("exit code 1") && ContainsSubstring("\"a word\""));
    CHECK_THAT(ran("kill -XFSZ $$").trouble, ContainsSubstring("wrote too much"));
    CHECK_THAT(ran("exit 3").trouble, ContainsSubstring("exit code 3"));
}

TEST_CASE("what a program said of one trace is found") {
    const Ran done = ran("echo 'not started: a.tsv: begin here' >&2; echo 'error: b.tsv: no: 3' >&2; exit 1");
    CHECK(trace_message(done.finished, "a.tsv") == "not started: begin here");
    CHECK(trace_message(done.finished, "b.tsv") == "error: no: 3");
    CHECK(trace_message(done.finished, "c.tsv") == "");
}

TEST_CASE("a student's file that cannot be built is told with its first error") {
    const Ran done = ran(
        "exit 0", R"(echo '[1/2] Building'; echo "${2%/build}/exercises/07_lines.cpp:3:5: error: ‘x’ was not declared"
                                   echo 'x.cpp:9:1: error: later'; exit 1)");
    CHECK_FALSE(done.started);
    CHECK(done.trouble == "your program can't be built: exercises/07_lines.cpp:3: 'x' was not declared");
}

TEST_CASE("an exercise that is not there is missed, with the way back") {
    const Place place;
    CHECK_THAT(
        refusal([&] { run_program(place.workspace, place.section, Whose::student, place.workspace.build / "traces"); }),
        ContainsSubstring("exercises/07_lines.cpp") && ContainsSubstring("./course reset 7"));
}

// `course plot --mine`, on such a program.

namespace {

/// What `course plot 7 --mine` prints, and its exit code, when the student's program does this.
/// @param second  the name of another figure, if there is one
/// @param curve   what it draws of the student's
std::string plotted(const std::string &program, const std::string &second = "", const std::string &curve = ", @yours") {
    const StudentPlace place{program};
    const std::string yours = "yours = with_yours(\"ARG3 using 1:2 with lines lt 2 title 'yours'\")\n";
    const std::string ours = "plot ARG1 using 1:2 with lines title 'reference'";
    for (const auto &[name, of_student] :
         {std::pair{std::string{"07_lines_rise"}, std::string{", @yours"}}, {second, curve}})
        if (!name.empty())
            place.write("plots/" + name + ".gp",
                        "#> Figure: x\nload 'style.gp'\nset output ARG2\nset xrange [0:4]; set yrange [0:5]\n"
                            + (of_student.empty() ? "" : yours) + ours + of_student + '\n');
    place.write("build/plots/mine/07_lines_rise.svg", "of yesterday");

    CLI::App app;
    add_plot(app, place.workspace);
    std::ostringstream printed;
    std::streambuf *const before = std::cout.rdbuf(printed.rdbuf());
    int code = 0;
    try {
        app.parse(std::vector<std::string>{"--mine", "7", "plot"});
    } catch (const ExitRequest &leave) {
        code = leave.code;
    }
    std::cout.rdbuf(before);
    CHECK(fs::exists(place.workspace.build / "plots/mine/07_lines_rise.svg") == (code == 0));
    return std::to_string(code) + ' ' + printed.str();
}

std::string writes(const std::string &rows) {
    return "printf '# t[s]\\tx[m]\\n" + rows + "' > \"$2/07_lines_rise.tsv\"";
}

} // namespace

TEST_CASE("a student's good trace is drawn") {
    CHECK_THAT(plotted(writes("0\\t1\\n2\\t3\\n")), Equals("0 build/plots/mine/07_lines_rise.svg  x\n"));
}

TEST_CASE("a student's trace that cannot be drawn has a sentence for its student, and yesterday's figure is gone") {
    CHECK_THAT(plotted(writes("0\\t1\\n2\\t-nan\\n")),
               ContainsSubstring("1 07_lines_rise is not drawn: your functions gave nan where x[m]"));
    CHECK_THAT(plotted(writes("0\\t99\\n2\\t99\\n")), ContainsSubstring("your values lie outside the axes"));
    CHECK_THAT(plotted(writes("0\\n2\\n")), ContainsSubstring("your trace 07_lines_rise.tsv, line 2 has 1 numbers"));
    CHECK_THAT(plotted("exit 0"), ContainsSubstring("does one of your functions end the program?"));
    CHECK_THAT(plotted("kill -SEGV $$"), ContainsSubstring("did not get as far") && ContainsSubstring("crashed"));
    CHECK_THAT(plotted("echo 'error: 07_lines_rise.tsv: t is -1' >&2; exit 1"),
               ContainsSubstring("one of your functions threw: t is -1"));
}

TEST_CASE("a figure that has no place for a student's curve is neither drawn nor missed") {
    CHECK(plotted(writes("0\\t1\\n2\\t3\\n"), "07_lines_ours", "") == "0 build/plots/mine/07_lines_rise.svg  x\n");
}

TEST_CASE("figures that need functions which are not started are left out, in one line; only if all are, plot fails") {
    const std::string needs = " (it needs functions that are not started)\n";
    const std::string second = "; echo 'not started: 07_lines_second.tsv: the slope' >&2; ";
    const std::string drawn = "build/plots/mine/07_lines_rise.svg  x\n";
    const std::string good = writes("0\\t1\\n2\\t3\\n") + second;
    CHECK(plotted(good + "exit 1", "07_lines_second") == "0 " + drawn + "left out: 07_lines_second" + needs);

    const std::string crashed = plotted(good + "kill -SEGV $$", "07_lines_second"); // afterwards: that is still told
    CHECK_THAT(crashed, StartsWith("0 " + drawn + "left out: ") && ContainsSubstring("crashed"));
    const std::string threw = plotted(good + "echo 'error: words: t is -1' >&2; exit 1", "07_lines_second");
    CHECK_THAT(threw, ContainsSubstring("one of your functions threw"));

    CHECK_THAT(plotted("echo 'not started: 07_lines_rise.tsv: the slope' >&2; exit 1"),
               StartsWith("1 left out: 07_lines_rise" + needs)
                   && ContainsSubstring("functions that aren't started; `./course check 7`"));
}
