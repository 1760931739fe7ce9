#pragma once
// Where functions stand in a file that need not compile, and in which of them a bracket is missing.

#include "check/scanner.hpp"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace course {

/// A bracket too many or missing, a quote or a comment without an end.
struct Fault {
    enum class What { too_many, not_closed, no_body, no_quote, no_comment } what;
    std::size_t place;
};

/// A function's definition, as places in a file.
struct Function {
    std::string name;
    std::size_t begin = 0;           ///< of the heading
    std::size_t body = 0;            ///< where the `{` is; the heading's bracket if there's none
    std::size_t end = 0;             ///< behind the `}`, or what seems to be it
    std::optional<Fault> fault = {}; ///< only in a file whose brackets don't fit

    bool holds(std::size_t place) const { return place >= begin && place < end; }
};
using Functions = std::vector<Function>;

/// All of them, in their order.
/// @param known  by name: none of these begins inside of another one, whatever braces are missing; nor does one that stands
///               at the left edge
Functions functions_of(const Source &source, const std::vector<std::string> &known);

/// The first with this name, if there's one.
const Function *find_function(const Functions &functions, std::string_view name);

/// The outermost that this place is in.
const Function *function_around(const Functions &functions, std::size_t place);

/// Whether code between these places calls a function.
bool calls(const Source &source, const Function &caller, std::string_view function);

/// Whether the line that opens this namespace is there.
bool opens_namespace(const Source &source, std::string_view name);

} // namespace course
