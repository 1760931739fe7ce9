#pragma once
#include <stdexcept>

namespace course {

/// Something that the reader of the message can put right: what() is one clear sentence with the value and the remedy.
/// The program prints it behind "course: " and leaves with exit code 2.
struct UserError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// A UserError about the machine, and not about anything that somebody has written: a full disk, no memory, a compiler
/// that was killed. The program leaves with exit code 4, and remembers nothing of what it was about to say.
struct EnvironmentError : UserError {
    using UserError::UserError;
};

/// What `course` leaves with.
enum Exit : int {
    all_well = 0,        ///< nothing to do
    something_to = 1,    ///< a test is not passed, a check found a difference
    bad_input = 2,       ///< usage, input, or something that is not installed: the message says what to do
    our_fault = 3,       ///< the course itself is broken
    machine_trouble = 4, ///< the machine got in the way: a full disk, no memory, a program killed from outside
};

} // namespace course
