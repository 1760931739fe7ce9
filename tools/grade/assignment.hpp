#pragma once
// A class's submissions to one section, in a folder of the instructor's: what was handed in and how it's graded, every
// result as soon as it's there, and in the end all that goes back.

#include "grade/baseline_answers.hpp"
#include "grade/gradebook.hpp"
#include "grade/graded.hpp"
#include "grade/grading.hpp"
#include "grade/points.hpp"
#include "grade/report.hpp"

#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace course {

/// What the instructor wants, once for all calls; the folder keeps it.
struct Agreed {
    std::string section;                 ///< "05_inclined_planes"
    std::filesystem::path given;         ///< the platform's download
    std::filesystem::path gradebook;     ///< may be empty
    std::string column;                  ///< of the gradebook; may be empty
    std::filesystem::path worth;         ///< what exercises are worth; empty: tests/points.txt
    std::vector<std::string> void_tests; ///< by name
    bool forgive = false;                ///< a mere consequence of another function costs nothing
    double late = 0;                     ///< per cent of all points that a day costs, as take_off_for_lateness has it
    unsigned seed = 2026;                ///< of generated values; `grade` draws one
    std::map<std::string, std::string> take = {}; ///< which file of somebody's is meant, by id
    bool no_file_is_blank = false;                ///< who hands in nothing to judge gets no 0
};

class Assignment {
  public:
    /// Reads everything that can be wrong before anything is judged.
    /// @param out  the folder; it's made, for its owner alone, with copies of what was given
    Assignment(const Workspace &workspace, Agreed agreed, const std::filesystem::path &out);

    /// Whether an earlier call has made this folder.
    static bool is_begun(const std::filesystem::path &out);

    /// The folder of an earlier call. @throws UserError if it's none
    static Agreed kept(const std::filesystem::path &out);

    const Section &section() const { return section_; }
    const Submissions &submissions() const { return handed_in; }
    const std::optional<Gradebook> &gradebook() const { return book; }
    std::vector<std::string> missing() const;        ///< ids in the gradebook without a submission
    std::vector<std::string> strangers() const;      ///< ids that handed in, and aren't in the gradebook
    bool leaves_blank(const Submission &each) const; ///< who has no file to judge, if that's no 0
    bool looks_like_group_work() const;              ///< no name in Canvas' download is that of the row

    /// Judges what has no result yet that fits file, tests and tool; in parallel, each result kept at once.
    /// @throws UserError before that, if our own solution fails a test that counts
    /// @param only   these ids anew, and nobody else; empty: all
    /// @param part   which part of how many, from 1: the others are left to other machines
    /// @param ended  called after each: how many of how many are done
    /// @return how many were judged
    std::size_t judge(const std::set<std::string> &only, std::pair<std::size_t, std::size_t> part,
                      const std::function<void(std::size_t, std::size_t)> &ended);

    /// Takes results over from the folder of another part, as far as they fit.
    void merge(const std::filesystem::path &folder);

    GradedClass graded() const;
    /// Who has other points than when the folder was last written; writes everything that goes back.
    std::vector<Change> write(const GradedClass &graded) const;

  private:
    std::filesystem::path result_of(const std::string &id) const { return out / "results" / (id + ".json"); }
    std::string key_of(const std::string &id) const;
    std::optional<Outcomes> result(const std::string &id) const; ///< if there's one of this file, by these tests
    void learn_lateness();
    void require_tests_that_ours_passes() const;
    void set_points();
    GradedExercise graded_exercise(const Exercise &exercise, const Outcomes &outcomes) const;
    Graded graded_student(const Submission &submission) const;
    bool is_judged(const std::string &id) const;
    std::string name_of_file() const { return section_.name + ".cpp"; }
    std::vector<Change> note_changes(const GradedClass &graded) const;

    const Workspace &workspace;
    Agreed agreed;
    std::filesystem::path out;
    Section section_;
    Submissions handed_in;
    std::optional<Gradebook> book;
    std::vector<Exercise> exercises;
    std::map<std::string, double> points_of;   ///< exercises, by number
    std::string mistakes;                      ///< what they're known by: see check/mistakes.hpp
    std::map<std::string, std::string> hashes; ///< of files to judge, by id
    std::string judged_with;                   ///< a hash of all that judges them
    std::string tests_hash;                    ///< of the tests alone, on any machine
    Baselines baselines;                       ///< as measured before anybody is judged
    Overrides overrides;
};

} // namespace course
