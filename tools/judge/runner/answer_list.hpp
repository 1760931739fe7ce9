#pragma once
// Mutants and variants, as tests/answers/generate.cpp lists those of a section.

#include <fstream>
#include <string>
#include <vector>

namespace course {

struct Answer {
    std::string name, exercise, rest; ///< rest: how it's to be judged, or what a reader did who gave it

    bool is_wrong() const { return name.starts_with("mutant_"); }
};

inline std::vector<Answer> read_answer_list(const std::string &file) {
    std::vector<Answer> answers;
    std::ifstream in{file};
    for (Answer next; in >> next.name >> next.exercise && std::getline(in >> std::ws, next.rest);)
        answers.push_back(next);
    return answers;
}

} // namespace course
