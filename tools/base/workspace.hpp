#pragma once
#include "base/errors.hpp"
#include "base/section.hpp"

#include <filesystem>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// The section that this line of CMakeLists.txt adds: `section(07_segment_intersection)`.
std::optional<Section> section_added_by(const std::string &line);

/// There is no section of that name or number.
struct UnknownSection : UserError {
    UnknownSection(const std::string &sentence, int number_) : UserError{sentence}, number{number_} {}
    int number; ///< that was asked for; 0 if it was a name
};

/// The file at the root of a handout, the edition without solutions: it says so to readers and to the build.
inline constexpr const char *handout_mark = "HANDOUT.md";

/// The checkout and its build folder; every path that a command uses is asked for here.
struct Workspace {
    std::filesystem::path root;  ///< the checkout
    std::filesystem::path build; ///< the build folder

    std::vector<Section> sections() const; ///< those that CMakeLists.txt names, in that order

    /// The section meant by "7", "07", "segment", a file's path, "07_segment_intersection"; or by an exercise, "7.2".
    /// @throws UnknownSection offering the nearest one.
    Section section(std::string_view words) const;

    /// A file's path relative to the checkout; as given if the file isn't in it.
    std::string relative_name(const std::filesystem::path &file) const;

    std::filesystem::path chapter(const Section &s) const { return root / "chapters" / s.name / "README.md"; }
    std::filesystem::path header(const Section &s) const { return root / "chapters" / s.name / (s.slug() + ".hpp"); }
    std::filesystem::path program(const Section &s) const { return root / "chapters" / s.name / "main.cpp"; }
    std::filesystem::path exercise(const Section &s) const { return root / "exercises" / (s.name + ".cpp"); }
    std::filesystem::path bug(const Section &s) const {
        return root / "exercises" / (s.name.substr(0, 2) + "_bug.cpp");
    }
    /// Tests that the student has written, if any.
    std::filesystem::path own_tests(const Section &s) const { return root / "exercises" / (s.name + "_tests.cpp"); }
    std::filesystem::path sketches() const { return root / "exercises" / "sketches"; } ///< a reader's own scenes
    /// The student's file, for reading. @throws UserError that says how to get it back, if the student's file is not there.
    std::filesystem::path written_exercise(const Section &s) const;
    std::filesystem::path stub(const Section &s) const { return tests_folder(s) / "stub.cpp"; }
    std::filesystem::path solution(const Section &s) const { return root / "solutions" / (s.name + ".cpp"); }
    /// Whether it's there, as it must be but in a handout.
    bool has_solution(const Section &s) const;
    /// @throws UserError with what to do instead, if it's not there
    void require_solution(const Section &s, const std::string &instead) const;
    /// All that judges a section.
    std::filesystem::path tests_folder(const Section &s) const { return root / "tests" / s.name; }
    /// Wrong answers, as differences to the solution.
    std::filesystem::path mutants(const Section &s) const { return tests_folder(s) / "mutants.diff"; }
    /// What mistakes give; a section may have none.
    std::filesystem::path mistakes(const Section &s) const { return tests_folder(s) / "mistakes.tsv"; }
    /// Whether this edition of the course has a section's solution and mutants.
    bool has_answers(const Section &s) const;
    std::filesystem::path tests(const Section &s) const { return tests_folder(s) / "tests.cpp"; }
    std::filesystem::path test_program(const Section &s) const { return build / "tests" / s.name; } ///< the built one
    std::filesystem::path catalogue(const Section &s) const { return build / "catalogue" / (s.name + ".json"); }
    /// What was called otherwise in earlier versions of the section; it need not exist.
    std::filesystem::path renamed(const Section &s) const { return root / "chapters" / s.name / "renamed.txt"; }
    std::filesystem::path memory() const { return root / ".course"; } ///< what the course remembers of the student
};

} // namespace course
