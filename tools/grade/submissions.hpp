#pragma once
// What a class has handed in, as a platform gives it out: a zip of Canvas or Moodle, or a plain folder, of clones too.

#include "base/workspace.hpp"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace course {

enum class Platform {
    canvas,
    moodle,
    classroom,
    folder
};                                           ///< GitHub Classroom has a gradebook; its clones are a folder
std::string_view name_of(Platform platform); ///< "Canvas", "Moodle", "GitHub Classroom", "a folder"

/// What one student, or one group, has handed in.
struct Submission {
    std::string id;                  ///< the platform's number, by which people are told apart: "1003"
    std::string name;                ///< what Canvas writes before that: "doejane", or a group's name
    std::string feedback_name;       ///< the file in feedback.zip that the platform hands back to this student
    std::string undelivered;         ///< why they can't read that all the same: "Canvas calls it essay.docx"
    std::filesystem::path file;      ///< a copy of the exercise's file, to be judged; empty if there's none
    std::string taken;               ///< which file of the student's that is, as the student called it
    bool late = false;               ///< as the platform says: Canvas by the file's name, Moodle in a worksheet
    std::string late_by;             ///< by how much, as Moodle says it: "1 day 2 hours"
    std::string trouble;             ///< why there's no file, to the student: "You handed in a zip archive, …"
    std::string unread;              ///< why the file can't be read, to the instructor: "x.cpp can't be unpacked: …"
    std::vector<std::string> others; ///< what wasn't taken, and why: "05_inclined_planes.cpp (older)", "notes.txt"
};

/// "late", "1 day 2 hours late", or nothing
std::string lateness(const Submission &submission);

struct Submissions {
    Platform platform = Platform::folder;
    std::vector<Submission> all; ///< by id: numbers by size, then words
    std::vector<std::string>
        left_alone; ///< entries that belong to nobody, and why: "../x.cpp: leads out of its folder"
};

/// Recognizes what was handed in, and copies each student's file of this section to `into`, as `1003.cpp`, in UTF-8.
/// Nothing else is unpacked: no name that somebody chose ever becomes a path of ours.
/// @throws UserError with the first three names, if it's none of the three; or if it's no zip, encrypted, huge, or
/// only a part of one; or if somebody hasn't the file that's to be taken
/// @param take     by id, which of the student's files is meant, whatever it's called
/// @param wrapped  whether all of it may lie in one more folder; else a folder is a student's, whatever is in it
Submissions read_submissions(const std::filesystem::path &given, const Section &section,
                             const std::filesystem::path &into, const std::map<std::string, std::string> &take = {},
                             bool wrapped = true);

} // namespace course
