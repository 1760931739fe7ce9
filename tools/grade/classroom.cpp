#include "grade/classroom.hpp"

#include "base/errors.hpp"
#include "base/text.hpp"

#include <fmt/format.h>
#include <regex>

namespace course {
namespace {

/// {0}: the repository that was handed out, {1}: a step for each exercise, {2}: their results, {3}: their ids.
constexpr const char *workflow =
    R"(# Points for GitHub Classroom, by exercise. Of a student's repository only exercises/ counts: chapters, tests and tools are
# those of the repository that was handed out. Written by ./course export classroom.
name: Points
on: [push, workflow_dispatch, repository_dispatch]
permissions:
  actions: read
  checks: write
  contents: read
jobs:
  points:
    runs-on: ubuntu-24.04
    container: debian:bookworm
    if: github.actor != 'github-classroom[bot]' && github.repository != '{0}'
    steps:
      - run: apt-get update && apt-get install --yes --no-install-recommends ca-certificates git
      - name: The course as it was handed out
        uses: actions/checkout@v4
        with:
          repository: {0}
      - name: What's written here
        uses: actions/checkout@v4
        with:
          path: build/written
      - run: cp build/written/exercises/*.cpp exercises/
      - run: ./course setup --yes
{1}      - name: All points
        uses: classroom-resources/autograding-grading-reporter@v1
        env:
{2}        with:
          runners: {3}
)";

constexpr const char *step = R"(      - name: {0} {1}
        id: {2}
        uses: classroom-resources/autograding-command-grader@v1
        with:
          test-name: {0} {1}
          command: ./course check {0}
          timeout: 10
          max-score: {3}
)";

} // namespace

std::string classroom_workflow(const Section &section, const std::vector<Exercise> &exercises, const Worth &worth,
                               const std::string &handed_out) {
    static const std::regex repository{R"([A-Za-z0-9][A-Za-z0-9-]*/[A-Za-z0-9._-]+)"};
    if (!std::regex_match(handed_out, repository))
        throw UserError{"--template wants the repository on GitHub that students begin with, as in our-school/section-"
                        + section.short_number() + ", not " + handed_out};
    std::string steps, results, ids;
    for (const Exercise &each : exercises) {
        std::string id = "e" + each.number;
        replace_all(id, ".", "-");
        steps += fmt::format(step, each.number, each.function, id, points_text(worth.of(each)));
        results += fmt::format("          {}_RESULTS: ${{{{ steps.{}.outputs.result }}}}\n", with_capital(id), id);
        ids += (ids.empty() ? "" : ",") + id;
    }
    return fmt::format(workflow, handed_out, steps, results, ids);
}

std::string classroom_notes(const Section &section) {
    return fmt::format(R"(
## On GitHub

Write `exercises/{0}.cpp` in your own repository, commit it, and push.
Some minutes later, the tab *Actions* shows each exercise: green ones have their points, and the others say what's wrong, as `./course check {1}` does.
An exercise that's half right shows 0 there; it has its part of the points when your instructor grades.
Only what's in `exercises` counts, so there's no use in changing tests.
)",
                       section.name, section.short_number());
}

} // namespace course
