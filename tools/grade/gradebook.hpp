#pragma once
// The instructor's own file of grades, Canvas', Moodle's or GitHub Classroom's: it comes back byte for byte, but for the grades, and of
// Canvas' without the columns that it's not about: importing those would take back what has changed there since.

#include "grade/csv.hpp"
#include "grade/submissions.hpp"

#include <map>
#include <set>
#include <string>
#include <vector>

namespace course {

/// What's written for one student.
struct Entered {
    double share = 0;    ///< of all points, from 0 to 1
    std::string comment; ///< one plain line, for a column of comments if the file has one
};

/// A person in the gradebook.
struct Person {
    std::string id;     ///< as in Submission::id
    std::string name;   ///< as the gradebook writes it; only for the gradebook and for reports to its owner
    std::string was;    ///< the grade that is there; may be empty
    std::string late;   ///< by how much the submission was late, as Moodle says it: "1 day 2 hours"; empty: it wasn't
    std::string locked; ///< why it's left as it is: "is excused (EX)", "can't be changed in Moodle"; else empty
};

class Gradebook {
  public:
    /// Recognizes Canvas' export, Moodle's worksheet and GitHub Classroom's grades by the columns that each must have.
    /// @param column  the title of the assignment's column, or a part of it; empty: the one that must be meant
    /// @throws UserError naming the columns found, if it's none of them, or if more than one column may be meant
    Gradebook(const std::filesystem::path &file, const Section &section, const std::string &column);

    Platform platform() const { return platform_; }
    const std::string &column() const { return title; } ///< that is written to: "HW 5 (4711)", "Grade"
    double most() const { return most_; } ///< Points Possible, or Maximum Grade; 0 if the platform says none
    void take_most(double points) { most_ = points; } ///< where the platform says none
    const std::vector<Person> &rows() const { return people; }
    const std::vector<std::string> &warnings() const { return doubts; } ///< why Canvas may not take the column
    bool tells_lateness() const { return has_status; }                  ///< Moodle's does, if no column was left out

    /// What a share of the points is as a grade: "7.5", or "7,5" where the file writes that. At most two decimals:
    /// half a hundredth goes up, and so does what's within a millionth of a hundredth of it, since 0.285 is no double.
    std::string grade(double share) const;

    /// The file with these grades (by id), of Canvas' only who is who and the assignment; who isn't in it, or is locked, stays as it was. So does a cell that says the
    /// same number already ("10.00" for "10"), and a comment where there's no other.
    std::string filled(const std::map<std::string, Entered> &grades) const;

  private:
    struct Place { // in the file
        CsvCell grade, comment;
    };
    void read_canvas(const Section &section, const std::string &column);
    void read_moodle(const std::string &column);
    void read_classroom(const std::string &column);
    void require_its_only_column(const std::string &column) const;
    std::size_t column_of_assignment(const std::vector<CsvCell> &possible, const Section &section,
                                     const std::string &column) const;
    void learn_decimal_sign(const CsvCell &cell);
    void set_most(const CsvCell &cell);
    void doubt_column();
    void check_length(const std::vector<CsvCell> &row) const;
    [[noreturn]] void complain(const CsvCell &cell, const std::string &what) const;

    Platform platform_ = Platform::canvas;
    std::string file_, title, text;
    Csv csv;
    double most_ = 0;
    bool has_status = false;
    char decimal_sign = 0;      // until a number shows it
    std::set<std::size_t> kept; // columns that come back; empty: all
    std::vector<std::string> doubts;
    std::vector<Person> people;
    std::vector<Place> places; // of these people
};

} // namespace course
