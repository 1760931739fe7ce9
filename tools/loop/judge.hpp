#pragma once
// From a student's file to verdicts: compile it, link it with the server, run the tests against it.

#include "ground/tree.hpp"
#include "verdict/shared/verdict.hpp"

#include <string>
#include <vector>

namespace course {

struct Judgement {
    std::vector<Verdict> verdicts;     ///< one for each test; a single one if the file does not compile or link
    std::vector<std::string> warnings; ///< of the compiler: "exercises/07_….cpp:12: unused variable 'x'"
    bool judged() const;               ///< whether the tests ran
    bool all_passed() const;
    bool our_fault() const; ///< a test without a verdict
};

/// Judges a file as a section's exercise. Nothing is kept: several may go on at once.
/// @param file  a student's file, wherever it is
/// @param seed  for generated values
/// @throws Complaint if the file is not there, or the course cannot be built
Judgement judge(const Tree &tree, const Section &section, const std::filesystem::path &file, unsigned seed);

/// The command that compiles a file as `judge` does; the bare one, without the precompiled header, is what benchmarks
/// measure it against.
std::vector<std::string> compile_command(const Tree &tree, const Section &section, const std::filesystem::path &file,
                                         const std::filesystem::path &object, bool bare = false);

} // namespace course
