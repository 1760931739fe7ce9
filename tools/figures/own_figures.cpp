#include "figures/own_figures.hpp"

#include "base/files.hpp"
#include "figures/section_figures.hpp"
#include "figures/trace.hpp"

namespace course {
namespace fs = std::filesystem;
namespace {

/// Why a student's trace cannot be drawn, for the student.
std::string in_student_words(const TraceFault &fault, const Ran &ran, const Figure &figure) {
    const std::string words = trace_message(ran.finished, figure.trace.filename().string());
    if (words.starts_with("error: ")) return "one of your functions threw: " + words.substr(7);
    if (fault.kind == TraceFault::not_finite)
        return "your functions gave " + fault.value.substr(fault.value.find_first_not_of('-')) + " where "
               + fault.column + " should stand";
    if (!ran.trouble.empty()) return "your program did not get as far as this figure";
    if (fault.kind == TraceFault::malformed) return fault.what();
    return "your program ended before this figure was written; does one of your functions end the program?";
}

/// Draws one figure with the student's curve; returns why not, or "".
std::string draw_mine(const Workspace &workspace, const Figure &figure, const Ran &ran) {
    try {
        read_trace(figure.student, "your trace " + figure.student.filename().string());
        write_file(own_drawing(workspace, figure), draw(figure));
        return "";
    } catch (const TraceFault &fault) {
        return in_student_words(fault, ran, figure);
    } catch (const FigureFault &) {
        return "your values lie outside the axes, or cannot be drawn; they are in "
               + workspace.relative_name(figure.student);
    }
}

} // namespace

fs::path own_drawing(const Workspace &workspace, const Figure &figure) {
    return workspace.build / "plots" / "mine" / (figure.name() + ".svg");
}

OwnFigures draw_own_figures(const Workspace &workspace, const Section &section) {
    OwnFigures own;
    own.ran = run_program(workspace, section, Whose::student, student_traces(workspace, section));
    for (Figure &figure : figures_of(workspace, section)) {
        if (figure.is_measured() || !draws_student(figure.script)) continue; // nothing in it is the student's
        fs::remove(own_drawing(workspace, figure));                          // an older one would be taken for today's
        if (!own.ran.started) continue;
        figure.student = student_traces(workspace, section) / figure.trace.filename();
        const bool not_started =
            trace_message(own.ran.finished, figure.trace.filename().string()).starts_with("not started: ");
        own.figures.push_back({figure, not_started, not_started ? "" : draw_mine(workspace, figure, own.ran)});
    }
    return own;
}

} // namespace course
