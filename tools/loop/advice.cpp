#include "loop/advice.hpp"

#include "ground/text.hpp"

#include <array>
#include <string_view>
#include <utility>

namespace course {
namespace {

struct Slip {
    const char *words; ///< a part of what the compiler says
    const char *means;
};

constexpr std::array slips{
    Slip{"non-void function", "There is a way through this function without a `return`."},
    Slip{"no return statement", "There is a way through this function without a `return`."},
    Slip{"unresolved overloaded function type", "A call needs parentheses: a.x(), not a.x."},
    Slip{"invalid use of member function", "A call needs parentheses: a.x(), not a.x."},
    Slip{"invalid use of non-static member function", "A call needs parentheses: a.norm(), not a.norm."},
    Slip{"comparison in operand of", "Compare two at a time: a < b && b < c."},
    Slip{"product of Vec2s", "For the dot product of two vectors write a.dot(b)."},
    Slip{"to 'require_number(", "require_range takes numbers, Vec2s and lists of them: give it a struct's fields one "
                                "by one, as start.position, start.velocity."},
    Slip{"INVALID_VECTOR_VECTOR_PRODUCT", "Two vectors have no product with *: a.dot(b) is their dot product."},
    Slip{"IT_IS_READ_ONLY", "Write Vec2 in the place of auto."},
    Slip{"assignment used as truth value", "= gives a value; to compare, write ==."},
    Slip{"do not have their mathematical meaning", "Compare two at a time: a < b && b < c."},
    Slip{"operator^", "^ is not a power: write t * t."},
    Slip{"no match for 'operator", "Is one of them a number, and the other a vector?"},
    Slip{"function-definition is not allowed here", "Is a } missing above this line?"},
    Slip{"does not name a type", "Is it misspelt? Or is there a } too many above this line?"},
    Slip{"expected ',' or ';' before", "Look at the end of the line above: is its ; there?"},
    Slip{"expected ';' before", "Look at the end of the line above: is its ; there?"},
    Slip{"ambiguating new declaration", "The header gives this function another result: copy its line from there."},
    Slip{"to 'std::optional<", "To answer nothing, write return {};"},
    Slip{"of different signedness", "What counts a list's elements is a std::size_t: for (std::size_t i = 0; …)."},
};

/// Where a type that begins at `from` ends: behind the last of its angle brackets.
std::size_t end_of_type(std::string_view text, std::size_t from) {
    int open = 0;
    for (std::size_t i = from; i < text.size(); ++i) {
        if (text[i] == '<') ++open;
        if (text[i] == '>' && --open == 0) return i + 1;
        if (open == 0 && text[i] == '\'') return i;
    }
    return text.size();
}

} // namespace

std::string advice(const std::string &said) {
    for (const auto &[words, means] : slips)
        if (said.find(words) != said.npos) return means;
    return {};
}

std::string with_short_names(std::string text) {
    erase_all(text, " {aka ", "}");
    erase_all(text, " (aka '", "')");
    erase_all(text, " [with ", "]");
    for (const char *spelling : {"Eigen::Matrix<double, 2, 1, 0, 2, 1>", "Eigen::Matrix<double, 2, 1>"})
        replace_all(text, spelling, "Vec2");
    for (const auto &[type, name] : {std::pair{"Eigen::Product<", "product of Vec2s"},
                                     {"Eigen::CwiseBinaryOp<", "sum of Vec2s"},
                                     {"Eigen::CwiseUnaryOp<", "sum of Vec2s"}}) {
        for (std::size_t at; (at = text.find(type)) != text.npos;) text.replace(at, end_of_type(text, at) - at, name);
        replace_all(text, std::string{"const "} + name, name);
    }
    replace_all(text, "<Vec2 >", "<Vec2>");
    return text;
}

} // namespace course
