#pragma once
// Answers that compute nothing, and pass some tests all the same: points begin above what they earn.

#include "ground/tree.hpp"
#include "loop/catalogue.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace course {

/// A whole file of such answers: the stub, where each function ends with `return {};`, say, as far as that compiles.
struct Trivial {
    std::string name; ///< "return {}"
    std::string text;
};
std::vector<Trivial> trivial_answers(const Tree &tree, const Section &section);

/// Which tests each trivial answer passes, by exercise: their places among the tests of the exercise, from 1.
using Baselines = std::map<std::string, std::set<std::vector<std::size_t>>>;

/// What comes out of them today. @throws Complaint if one can't be judged
Baselines measure_baselines(const Tree &tree, const Section &section);

/// tests/baselines/NN_slug.txt, which `course publish --baselines` keeps. A line: an exercise, and places: "5.1: 1 2 7".
std::filesystem::path file_of_baselines(const Tree &tree, const Section &section);
std::string to_text(const Baselines &baselines);
Baselines read_baselines(const Tree &tree, const Section &section);

} // namespace course
