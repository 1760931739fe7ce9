#pragma once
// Mistakes that have a name: what comes out of a student's function is looked up among what comes out of mutants.

#include "judge/protocol/verdict.hpp"

#include <string>
#include <vector>

namespace course {

/// What a student did who gets this from the tests of one exercise: "you leave the ends open.", or two such with "or when"
/// between them. Empty if nothing is known that gives all of that. Where a single test failed, its value must be telling:
/// 0, 1 or a number that went in comes out of too many mistakes; what's infinite, or not a number, comes out of few.
/// @param table  tests/NN_slug/mistakes.tsv, which `course dev publish` keeps. A line is an exercise, a tab, and either
///               `generated`, a tab and a test that generates input, or the signature of what comes out, a tab and what a
///               student did who gets that
std::string known_mistake(const std::string &table, const std::vector<Verdict> &verdicts);

/// What to say if all that failed of one exercise is right to about seven digits. Empty if it isn't, or if it's one number of
/// several, which may be near by chance.
std::string lost_digits(const std::string &text, const std::vector<Verdict> &verdicts);

} // namespace course
