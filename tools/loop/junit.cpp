#include "loop/junit.hpp"

#include <pugixml.hpp>

#include <algorithm>
#include <sstream>

namespace course {

std::string junit(const std::vector<std::pair<Section, std::vector<Verdict>>> &judged) {
    pugi::xml_document document;
    pugi::xml_node suites = document.append_child("testsuites");
    for (const auto &[section, verdicts] : judged) {
        const auto count = [&verdicts = verdicts](auto &&of) {
            return static_cast<int>(std::count_if(verdicts.begin(), verdicts.end(), of));
        };
        const auto no_verdict = [](const Verdict &v) { return v.kind == Kind::no_verdict; };
        pugi::xml_node suite = suites.append_child("testsuite");
        suite.append_attribute("name") = section.name.c_str();
        suite.append_attribute("tests") = static_cast<int>(verdicts.size());
        suite.append_attribute("failures") = count([&](const Verdict &v) { return !v.passed() && !no_verdict(v); });
        suite.append_attribute("errors") = count(no_verdict);
        for (const Verdict &verdict : verdicts) {
            pugi::xml_node test = suite.append_child("testcase");
            test.append_attribute("classname") =
                verdict.exercise.empty() ? section.name.c_str() : verdict.exercise.c_str();
            test.append_attribute("name") = verdict.test.empty() ? "compiles and links" : verdict.test.c_str();
            if (verdict.passed()) continue;
            pugi::xml_node failure = test.append_child(no_verdict(verdict) ? "error" : "failure");
            failure.append_attribute("type") = std::string{name_of(verdict.kind)}.c_str();
            failure.append_attribute("message") = verdict.sentence.c_str();
            failure.text() = explain(verdict, 0).c_str();
        }
    }
    std::ostringstream out;
    document.save(out, "  ");
    return out.str();
}

} // namespace course
