#pragma once
// A class's submissions to one section, in a folder of the instructor's: what was handed in and how it's graded, every
// result as soon as it's there, and in the end all that goes back.

#include "class/gradebook.hpp"
#include "class/graded.hpp"
#include "class/grading.hpp"
#include "class/report.hpp"
#include "class/trivial.hpp"

#include <filesystem>
#include <functional>
#include <optional>
#include <set>
#include <string>
#include <vector>

namespace course {

/// What the instructor has said, once; the folder keeps it.
struct Agreed {
    std::string section;                 ///< "05_inclined_planes"
    std::filesystem::path given;         ///< the platform's download
    std::filesystem::path gradebook;     ///< may be empty
    std::string column;                  ///< of the gradebook; may be empty
    std::filesystem::path worth;         ///< what exercises are worth; empty: tests/points.txt
    std::vector<std::string> void_tests; ///< by name
    bool forgive = false;                ///< a mere consequence of another function costs nothing
    double late = 0;                     ///< per cent of all points that a day costs, as `late.hpp` has it
    unsigned seed = 2026;
};

class Assignment {
  public:
    /// Reads everything that can be wrong before anything is judged.
    /// @param out  the folder; it's made, for its owner alone, with copies of what was given
    Assignment(const Tree &tree, Agreed agreed, const std::filesystem::path &out);

    /// Whether an earlier call has made this folder.
    static bool is_begun(const std::filesystem::path &out);

    /// The folder of an earlier call. @throws Complaint if it's none
    static Agreed kept(const std::filesystem::path &out);

    const Section &section() const { return its_section; }
    const Submissions &submissions() const { return handed_in; }
    const std::optional<Gradebook> &gradebook() const { return book; }
    std::vector<std::string> missing() const;   ///< ids in the gradebook without a submission
    std::vector<std::string> strangers() const; ///< ids that handed in, and aren't in the gradebook

    /// Judges what has no result yet that fits file, tests and tool; in parallel, each result kept at once.
    /// @param only   these ids anew, and nobody else; empty: all
    /// @param part   which part of how many, from 1: the others are left to other machines
    /// @param ended  is told after each how many of how many are done
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
    bool is_judged(const std::string &id) const;
    std::string name_of_file() const { return its_section.name + ".cpp"; }
    std::vector<Change> changes(const GradedClass &graded) const;

    const Tree &tree;
    Agreed agreed;
    std::filesystem::path out;
    Section its_section;
    Submissions handed_in;
    std::optional<Gradebook> book;
    std::map<std::string, std::string> hashes;                       ///< of files to judge, by id
    std::string judged_with;                                         ///< a hash of all that judges them
    std::string tests_hash;                                          ///< of the tests alone, on any machine
    Baselines baselines;                                             ///< as measured before anybody is judged
    std::map<std::string, std::pair<double, std::string>> overrides; ///< points and why, by id
};

} // namespace course
