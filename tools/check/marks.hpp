#pragma once
// What a picture of a verdict is made of: marks, each from one value of the call.

#include "course.hpp"
#include "judge/protocol/verdict.hpp"

#include <string>
#include <vector>

namespace course {

struct Mark {
    enum class Kind {
        point,
        arrow,  ///< `at`: where it begins, then the vector, in `unit`
        line,   ///< a segment, an arm, a list of points
        box,    ///< `at`: two corners
        circle, ///< around a point
        number, ///< `at`: the number, in `unit`
    };
    enum class Role { given, yours, right, expected, unjudged };
    Kind kind;
    std::vector<Vec2> at;
    std::string label = {}; ///< "ball", "velocity"
    std::string path = {};  ///< in the value: "ball.velocity", "[2]"
    std::string unit = {};  ///< of an arrow or a number
    double radius = 0;      ///< of a circle [m]
    Role role = Role::given;
    bool named = true; ///< with words beside it
};

/// All that the verdict's call was given, what it answered, and what was expected where that differs. A part of the answer
/// that's as expected is `right`; where only one part was compared, the others are `unjudged`.
std::vector<Mark> marks_of(const Verdict &verdict);

} // namespace course
