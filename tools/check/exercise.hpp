#pragma once
#include <string>

namespace course {

/// One exercise, as the section's tests know it.
struct Exercise {
    std::string number;   ///< "7.2"
    std::string tier;     ///< core, stretch or challenge
    std::string function; ///< "crosses"
};

/// A test of a section, as the list of tests has it.
struct KnownTest {
    std::string exercise; ///< "7.2"
    std::string claim;    ///< the name of the test
};

/// An exercise, and how it stands as far as is remembered.
struct Standing {
    Exercise exercise;
    std::string state; ///< the last verdict; "not started" in an untouched file; "not checked" if there was no verdict
};

} // namespace course
