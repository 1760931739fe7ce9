#pragma once
#include <stdexcept>

namespace course {

/// Something that the reader of the message can put right: what() is one clear sentence with the value and the remedy.
/// The program prints it behind "course: " and leaves with exit code 2.
struct Complaint : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// What `course` leaves with.
enum Exit : int {
    all_well = 0,     ///< nothing to do
    something_to = 1, ///< a test is not passed, a check found a difference
    bad_input = 2,    ///< usage, input, or the machine: the message says what to do
    our_fault = 3,    ///< the course itself is broken
};

} // namespace course
