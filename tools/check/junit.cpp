#include "check/junit.hpp"

#include "base/plain.hpp"

#include <pugixml.hpp>

#include <algorithm>
#include <sstream>

namespace course {
namespace {

/// Text that XML can hold: paths and what students print may have any bytes.
std::string plain(std::string_view text) {
    std::string lines = sanitize(text);
    if (!lines.empty()) lines.pop_back(); // the last line's end
    return lines;
}

void set(pugi::xml_node node, const char *name, const std::string &value) {
    std::string line = plain(value);
    std::ranges::replace(line, '\n', ' ');
    node.append_attribute(name) = line.c_str();
}

void add_property(pugi::xml_node node, const char *name, const std::string &value) {
    pugi::xml_node properties = node.child("properties");
    if (!properties) properties = node.append_child("properties");
    pugi::xml_node property = properties.append_child("property");
    set(property, "name", name);
    set(property, "value", value);
}

/// The verdict on a test: the own one, that on the whole file, or none.
Verdict verdict_on(const KnownTest &test, const Report &report) {
    if (report.unbuilt) return *report.unbuilt;
    for (const Verdict &verdict : report.verdicts)
        if (verdict.test == test.claim) return verdict;
    return {.kind = Outcome::no_verdict, .sentence = "This test has no verdict: our mistake, not yours."};
}

const char *element_of(Outcome kind) {
    switch (kind) {
    case Outcome::passed: return "";
    case Outcome::not_started: return "skipped";
    case Outcome::no_verdict: return "error";
    default: return "failure";
    }
}

void add_test(pugi::xml_node suite, const KnownTest &test, const Report &report) {
    const Verdict verdict = verdict_on(test, report);
    pugi::xml_node node = suite.append_child("testcase");
    set(node, "classname", test.exercise);
    set(node, "name", test.claim);
    for (const Exercise &exercise : report.exercises)
        if (exercise.number == test.exercise) add_property(node, "tier", exercise.tier);
    if (verdict.passed()) return;
    pugi::xml_node what = node.append_child(element_of(verdict.kind));
    set(what, "type", std::string{name_of(verdict.kind)});
    set(what, "message", in_one_line(verdict));
    what.text() = plain(explain(verdict, 0)).c_str();
}

} // namespace

std::string course_version() { return COURSE_VERSION; }

std::string in_one_line(const Verdict &verdict) {
    std::string text =
        verdict.file.empty() || verdict.test != "" ? "" : verdict.file + ':' + std::to_string(verdict.line) + ": ";
    text += verdict.sentence;
    for (const std::string &input : verdict.accepted) text += (input == verdict.accepted.front() ? " " : "; ") + input;
    if (!text.empty()) return text;
    return (verdict.label.empty() ? "" : verdict.label + ": ") + verdict.yours + " instead of " + verdict.expected
           + (verdict.tolerance.empty() ? "" : " ± " + verdict.tolerance);
}

std::string junit(const std::vector<Report> &reports) {
    pugi::xml_document document;
    pugi::xml_node suites = document.append_child("testsuites");
    for (const Report &report : reports) {
        pugi::xml_node suite = suites.append_child("testsuite");
        set(suite, "name", report.section.name);
        pugi::xml_attribute tests = suite.append_attribute("tests"), failures = suite.append_attribute("failures"),
                            errors = suite.append_attribute("errors"), skipped = suite.append_attribute("skipped");
        add_property(suite, "course version", course_version());
        add_property(suite, "file", report.file);
        add_property(suite, "seed", std::to_string(report.seed));
        for (const auto &[name, value] : report.also) add_property(suite, name.c_str(), value);
        for (const KnownTest &test : report.tests) add_test(suite, test, report);
        const auto count = [&](const char *path) { return suite.select_nodes(path).size(); };
        tests = report.tests.size();
        failures = count("testcase/failure");
        errors = count("testcase/error");
        skipped = count("testcase/skipped");
    }
    std::ostringstream out;
    document.save(out, "  ");
    return out.str();
}

} // namespace course
