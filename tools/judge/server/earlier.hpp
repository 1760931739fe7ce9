#pragma once
// In a handout, before a student's file of an earlier section: what isn't started there says of which section it is, since
// the one that is judged may have a function of the same name. COURSE_EARLIER is the section's namespace.
#include "course.hpp"

#include <string>

namespace course {
namespace { // each file has another

struct NotYetEarlier : NotYet {
    explicit NotYetEarlier(const char *hint, const char *in = __builtin_FUNCTION()) : NotYet{hint, kept(in)} {}

  private:
    static const char *kept(const char *function) {
        static std::string name;
        return (name = std::string{COURSE_EARLIER "::"} + function).c_str();
    }
};

} // namespace
} // namespace course

#define NotYet NotYetEarlier
