#include "check/advice.hpp"

namespace course {
namespace {

constexpr const char *answer_nothing = "To answer nothing, write return {};";
constexpr const char *call_it = "A call needs parentheses: a.x(), not a.x.";
constexpr const char *compare_it = "= gives a value; to compare, write ==.";
constexpr const char *copy_it = "It's const, so you can't change it: copy it, and change the copy.";
constexpr const char *dot_is_number = "a.dot(b) is a number; a.dot(b) * b is a vector.";
constexpr const char *fields_of_it = "The braces of a(n) $1 hold its fields, in the order of the header.";
constexpr const char *fields_of_pushed = "The braces hold the fields of a(n) $1, in the order of the header.";
constexpr const char *length_of_vector = "The length of a Vec2 is a.norm().";
constexpr const char *list_in_map = "What stands in this map are lists: grid[{1, 2}].push_back(3) adds to one, and for "
                                    "(const int i : grid[{1, 2}]) goes through one.";
constexpr const char *missing_brace = "Is a } missing above this line?";
constexpr const char *missing_star = "Is a * missing? A product needs it: 2 * t, 2 * (a + b).";
constexpr const char *no_call = "A field has no parentheses: write a.position, not a.position().";
constexpr const char *one_element = "That's a list: one element of it is list[i], the first is list[0].";
constexpr const char *pair_as_key = "A map has one key and one value: std::map<std::pair<int, int>, std::vector<int>>.";
constexpr const char *pair_in_braces = "Two numbers make a vector in braces: Vec2{a, b}, not (a, b).";
constexpr const char *plus_minus = "± stands for two values: write + for one of them, and - for the other.";
constexpr const char *two_components = "A Vec2 has two components: write Vec2{x, y}.";
constexpr const char *type_of_optional = "Write its type before the braces, $1{…}; to answer nothing, write return {};";
constexpr const char *use_fields = "A(n) $1 is a struct: use its fields, one at a time.";
constexpr const char *struct_wanted = "A(n) $1 is wanted here: put its fields in braces, in the order of the header.";
constexpr const char *write_dot = "For the dot product of two vectors write a.dot(b).";
constexpr const char *write_pi = "Write std::numbers::pi, and #include <numbers> at the top of your file.";
constexpr const char *write_vec2 = "Write Vec2 before the braces: 2 * Vec2{x, y}.";

constexpr const char *has_pair = R"([=+\-] *\({items},)"; // a + (x, y), a = (x, y): parentheses for braces
constexpr const char *has_dot_product =                   // in the statement with the caret, or if that points nowhere
    R"(\.dot\([^;]*@|\.dot@\(|@[^;]*\.dot\(|^[^@]*\.dot\([^@]*$)";

constexpr AdviceRule rule_table[] = {
    // maps, and lists in them
    {R"(^no match for call to '\((?:const )?std::map<std::pair<)", "",
     "The brackets of a map are square: grid[{1, 2}]."},
    {"template argument|expected", R"(std::map<[{(]int, int[)}])", pair_as_key},
    {"std::map<int, int, std::vector<", "", pair_as_key},
    {"(?:of non-class|base) type '[^']*::mapped_type'", R"(\]\.push_back\()",
     "push_back adds to a list, and this map has none: std::map<std::pair<int, int>, std::vector<int>>."},
    {R"(operator\[\].*std::map<std::pair<|comma expression in array subscript)", "",
     "Brackets take one value: a key of two numbers stands in braces, grid[{1, 2}]."},
    {"^(?=.*std::map<)(?=.*vector<).*(?:mapped_type|'push_back')|'std::pair<const [^']*vector<", "", list_in_map},
    {"no viable overloaded '='", R"(\] =)", list_in_map, "vector<"},
    {"^(?!.*Vec2').*(?:no match for 'operator<?'|invalid operands to binary expression)", "^$",
     "What is sorted, or is a map's key, must have an order: numbers have one, and so has std::pair<int, int>."},
    {"unordered_map<.*deleted|deleted.*unordered_map<", "",
     "A std::unordered_map can't have such a key: a std::map can."},

    // lists
    {"", R"(^for (?:(?! : )[^;])*?\w (?:in|of) \w)",
     "A loop over a list has a colon: for (const Vec2 &v : list), or for (int i : list)."},
    {"^'[^']*std::vector<[^']*{lacks}last'", "", "The last element of a list is list.back()."},
    {"'[^']*std::vector<{Struct}> ?{lacks}length'", R"(\.length\b(?!\())",
     "That's the whole list: one element of it is list[i], and how many it has is list.size()."},
    {"^(?!.*did you mean)'[^']*std::vector<[^']*> ?{lacks}(?:add|append|push|Add)'", "",
     "To add to a list, write list.push_back(a)."},
    {"^(?!.*did you mean)'[^']*std::vector<[^']*> ?{lacks}(?:length|count|len)'", "",
     "How many elements a list has is list.size()."},
    {"^(?!.*did you mean)'[^']*std::vector<[\\w:]*Vec2> ?' has no member named "
     "'(?:x|y|norm|dot|normalized|squaredNorm)'",
     "", one_element},
    {R"(^(?!.*did you mean)'[^']*std::vector<{Struct}> ?{lacks}(\w+)')", R"(\.$2\b(?!\())", one_element},
    {R"(^no match for call to '\((?:const )?std::vector<)", "",
     "An element of a list stands in square brackets: list[i]."},
    {"^template argument .* is invalid|^expected '>'", "^std::{angles}<{angles}$",
     "Each < of a type needs its >: is one missing?"},

    // questions
    {"^expected expression$", "^else", missing_brace},
    {R"(^expected '\(' )", R"(\bif )", "An if needs parentheses: if (t < 1) …"},
    {"expected ';'", R"(\belse \()", "A question after else needs an if of its own: else if (t < 1) …"},
    {R"(^expected ';' before|^expected '\)'$)", R"(\bif \({inner}$)",
     "Count the parentheses of the if: is a ) missing?"},
    {"", R"(\bif \({inner}\) *(?:&&|\|\||and\b|or\b))",
     "One pair of parentheses holds the whole question: if (a > 0 && b > 0) …"},
    {"empty body|does not guard", R"(\bif \({inner}\) *;)", "The ; behind the parentheses ends the if: remove it."},
    {"^expected primary-expression|^expected expression$", "=>|=<",
     "At least is >=, and at most is <=: the = comes last."},

    // declarations, and what's returned
    {"does not name a type|requires a type specifier", R"(^const (?!Vec2\b)\w+ *[={])",
     "A variable needs its type: const Vec2 a = …; or const double a = …;"},
    {R"(^'(\w+)' has not been declared|^unknown type name '(\w+)')", ", $1[,)]",
     "A parameter needs its type, too: (Vec2 v, double t)."},
    {"conver|left operand of comma", R"(\breturn \(?{items},)", "Two values need braces: return {first, second};"},
    {"^'[^']*' was not declared", "return (?:nothing|none|None|null);", answer_nothing},
    {"conver|character constant", R"(return ["'](?:nothing|none|None|null)["'];)", answer_nothing},
    {"assignment of |left operand of assignment|cannot assign to|is not assignable|to 'bool'|'operator='|overloaded "
     "'='",
     R"(\b(?:if|while) \((?:[^()]|\({inner}\)|\()*?[^=<>!]=(?!=))", compare_it},
    {"^expected ';'", R"((?:^|\)|else) *\{(?! *[\w:]+ +\w)(?=[^;={}]*\};?$){items},)",
     "An answer needs return before its braces: return {a, b};"},
    {"^expected (?:initializer|.*';').* before '([^']+)'", "^$1", "Look at the end of the line above: is its ; there?"},
    {"^expected .*';'", ".@$", "A ; is missing at the end of this line."},

    // products
    {"expression cannot be used as a function|^called object type {number}", R"(@\(\))", no_call},
    {"expression cannot be used as a function|^called object type {number}", "", missing_star},
    {"operand types are ", R"((?:^|[^\w.])[\d.]+ +(?!(?:and|or)\b)\w)", missing_star},
    {"^expected .*';'", R"([\w)] *@ *(?!(?:return|if|for|while|else|const|auto|double|int)\b)\w)", missing_star},
    {R"(²|<U\+00B2>)", "", "² isn't C++: write (t * t), with the brackets."},
    {R"(type argument of unary '\*'|indirection requires pointer)", R"(\*\*)",
     "** isn't a power: write (t * t), with the brackets."},
    {R"(±|<U\+00B1>)", "", plus_minus},
    {"^expected (?:primary-expression before '/'|expression$)", R"(\+/-)", plus_minus},
    {"overloaded function", R"(std::(\w+) )", "A call needs parentheses: std::$1(…)."},
    {R"(right hand side of operator '[+\-*/]')", "", write_vec2},
    {"^expected .*';'", R"(\} *@ *[+\-*/](?!/))", write_vec2},
    {R"(^expected primary-expression before '\{')", R"([*+\-/] *\{)", write_vec2},

    // braces
    {"^(?:invalid cast from type {vector} to type {number}|conversion from {vector} to {number}.*without a conversion)",
     "^$",
     "A Vec2 is made of two numbers, Vec2{x, y}, and not of two vectors: the vector "
     "from a to b is b - a."},
    {R"(::operator\*<Vec2>\(|MatrixBase<Derived>::operator\*\()", "", write_dot},
    {", 1>::[xy][},]", "", call_it},
    {R"('Vec2::Matrix\(<brace)", R"(\.[xy](?![\w(]))", call_it, "deduce template parameter 'T"},
    {"^expected primary-expression before ';'|does not refer to a value|^unexpected type name '",
     R"(return (?!Vec2\b)([A-Z]\w*);)", "$1 is a type: answer with a value, a variable or $1{…}."},
    {"^conversion from {struct} to {struct}", "",
     "A(n) $2 is wanted here, not a(n) $1: put its fields in braces, in the order of the header."},
    {R"(^(?!.*(?:std::optional<|::\)\(|product of Vec2s))conversion from )",
     R"(return (?!Vec2\b)([A-Z]\w*)[{(]{closed}@)",
     "The braces of a(n) $1 hold its fields, in the order of the header; if the "
     "result is another struct, write return {…};"},
    {R"(^(?!.*(?:std::optional<|::\)\(|product of Vec2s))conversion from )", R"(\b(?!Vec2\b)([A-Z]\w*)[{(]{closed}@)",
     fields_of_it},
    {"^(?:too many initializers for|no matching constructor for initialization of) {struct}", "", fields_of_it},
    {"^excess elements in scalar initializer", R"(\bColour *\{)",
     "A colour has a name, as Colour::green; docs/sketches.md has them all."},

    // members
    {"(?:of non-class|base) type {number}", "", "That is a number already: it has no fields."},
    {"^'(?![^']*std::)[^']*{lacks}push_back'", "", "Only a list has push_back: std::vector<Vec2> list;"},
    {"^(?!.*did you mean)'{Struct}{lacks}", "", "Look up the fields of $1 in the header."},
    {"^{vector} has no member named 'length'", "", length_of_vector},
    {"^(?!.*did you mean){vector} has no member named", "",
     "That is a vector already: its components are a.x() and a.y()."},
    {R"(^'[^']*std::optional<[^']*{lacks}(\w+)')", "",
     "It may be nothing: ask first, if (found), and then write found->$1."},

    // arguments
    {R"(vector<(?:[a-z ]+|[\w:]*Vec2)>::push_back\({Struct}\))", "", use_fields},
    {"'push_back', argument from {struct} to '[^']*vector<(?:[a-z ]+|[^'>]*Vec2)>", "", use_fields},
    {"push_back|of comma", R"(push_back\(\()", "Two values need braces: push_back({first, second});"},
    {R"(vector<{Struct}>::push_back\((?:const )?(?:Vec2|expression of Vec2s|double|float|int|long) ?&?\))", "",
     struct_wanted},
    {"'push_back', argument from (?:{number}|{vector}) to '[^']*vector<{Struct}>", "", struct_wanted},
    {R"(vector<{Struct}>::push_back\(<brace)", "", fields_of_pushed},
    {"push_back", "", fields_of_pushed, "initializer list argument to '[^']*vector<{Struct}>"},
    {"argument from {number} to {vector}", "", two_components},
    {"argument from {struct} to {vector}", "", use_fields},
    {"argument from {number} to {struct}", "",
     "A whole $1 is wanted here, not a number: pass one that you have, a and not a.mass, or make one of its fields in "
     "braces, in the order of the header."},
    {"argument from {vector} to {struct}", "", struct_wanted},
    {"argument from {struct} to {struct}", "",
     "A(n) $2 is wanted here: put its fields in braces, in the order of the header."},
    {R"(::dot\(|function for call to 'dot')", "", "A dot product has a vector on each side: a.dot(b)."},
    {"function for call to 'abs.*Vec2", "", length_of_vector},
    {R"(function for call to '(?:sin|cos|tan|sqrt)(?:\({Struct}\)|', argument from {struct}))", "", use_fields},
    {R"(before '\.' token|does not refer to a value|dot operator on a type|type name ')", R"((?:@Vec2|\bVec2@)\.(\w+))",
     "Vec2 is a type: before the dot, write the name of the parameter or variable, as in velocity.$1."},
    {R"(before '\.' token|does not refer to a value|dot operator on a type|type name ')",
     R"((?:@([A-Z]\w*)|\b([A-Z]\w*)@)\.(\w+))",
     "$1 is a type: before the dot, write the name of the parameter or variable, as in $small.$2."},
    {R"((?:invalid operands|cannot convert|cannot initialize|incompatible).*'(?![^']*::\))\w[^'(]*\([^']*\)')", "",
     "That is a function: call it, with what it needs in parentheses."},

    // operands
    {"left operand of comma|^no viable overloaded '='", has_pair, pair_in_braces},
    {"operand type is '|to unary expression", R"(=\+)", "To add to a value, write += and not =+."},
    {R"(^no match for 'operator\^')", "", "^ isn't a power: write (t * t), with the brackets."},
    {"^no match for 'operator%'", "", "% is for whole numbers: make both an int."},
    {R"(^no match for 'operator[+\-*/]?=' \(operand types are 'const )", "", copy_it},
    {"^no match for .*operand types are .*std::optional<", "",
     "An optional may be nothing: ask first, if (found), and then compare *found, or its field found->t."},
    {R"(^no match for 'operator(?:[<>]=?)?' \(operand types are {vector} and {vector})", "",
     "No vector is larger than another: compare their components, or their lengths."},
    {R"(^no match for 'operator/' \(operand types are {vector} and {vector})", "",
     "No vector can be divided by a vector: divide by its length, a / a.norm()."},
    {"operand types are {mixed}", has_pair, pair_in_braces},
    {"operand types are {mixed}", has_dot_product, dot_is_number},
    {"operand types are {vector} and {number}", R"([+\-] *[^ (;]*\.(?:norm|squaredNorm)\()",
     "Only the last one is measured. Put brackets around all of it: (a - b).norm()."},
    {"operand types are {mixed}", "",
     "One of them is a number, the other a vector: its components are a.x() and a.y(), its length is a.norm()."},
    {R"(^no match for 'operator[+\-*/<>][^']*' \(operand types are (?:{struct} and|'[^']*' and {struct}))", ".",
     use_fields},

    // a value of one type where another is expected
    {R"(^no matching constructor for initialization of 'std::optional<(?:\w+::)*(\w+))", R"(return \{)",
     type_of_optional},
    {R"(^conversion from '<brace-enclosed[^']*' to '[^']*std::optional<(?:\w+::)*(\w+))", "", type_of_optional},
    {"^conversion from (?:{number}|'bool'|'[^']*nullptr_t') to '[^']*std::optional<", "", answer_nothing},
    {"^conversion from '(?!<brace-enclosed|[^']*std::vector<)[^']*' to 'std::vector<", "return ",
     "A list needs braces: return {a}; for one value, return {}; for none."},
    {"^conversion from '[^']*vector<[^']*' to '[^']*vector<", "",
     "The lists hold different things: begin an empty one, and fill it with push_back."},
    {"^conversion from (?:'<brace-enclosed[^']*' to {struct}|{struct} to {number})", R"(return \{)",
     "The braces hold the fields of the result, in the order of the header: where "
     "it has a number, a.mass, say; where it has a Vec2, a.velocity; not the "
     "whole a."},
    {"^conversion from '[^']*std::optional<[^']*' to '(?![^']*std::optional<)", "",
     "It may be nothing: ask first, if (found), and then write *found."},
    {"^conversion from {vector} to (?:{number}|'[^']*std::optional<double>')", "",
     "A Vec2 isn't a number: its components are a.x() and a.y(), its length is a.norm()."},
    {"^conversion from {number} to {vector}", R"(\.norm\(\);)",
     "a.norm() is a number; a / a.norm() is a vector of length 1."},
    {"^conversion from {number} to {vector}", has_dot_product, dot_is_number},
    {"^conversion from {number} to {vector}", "", two_components},
    {"^conversion from (?:{number}|{vector}) to {struct}", "", struct_wanted},
    {"^conversion from {struct} to (?:{number}|{vector})", "", use_fields},
    {R"(before '\{' token|initializer list cannot be used|expected expression)", R"( \? (?:\{|.* : \{))",
     "Write the type before the braces: Vec2{1, 0}."},
    {"call to '(?:min|max|clamp)", "", "All must be of one type: the size of a list as an int is int(list.size()).",
     "deduced conflicting types.*unsigned"},
    {"call to '(?:min|max|clamp)", "", "All must be of one type: write 1.0, not 1.",
     "deduced conflicting types.*'(?:double|int)'.*'(?:double|int)'"},

    // names
    {"", "", "Write #include <$1> at the top of your file.", "did you forget to '#include <([^>]*)>"},
    {R"(before '\.' token|unexpected namespace name 'std')", R"(\bstd\.)", "Behind std come two colons: std::sqrt(x)."},
    {"^'numbers' (?:was not|has not been) declared", "numbers::pi", write_pi},
    {"^'(?:pi|PI)' was not declared|'pi' is not a member of 'std'|no member named 'pi' in namespace 'std'", "",
     write_pi},
    {"^'(?:norm|length)' was not declared", R"((?:^|[^.\w])(?:norm|length)\()", length_of_vector},
    {"^'dot' was not declared", "", write_dot},
    {"^'(?:elseif|elsif|elif)' was not declared", "", "Write else if, in two words."},
    {"^'push_back' was not declared", "", "The list stands before the dot: list.push_back(a)."},
    {"'cosinus'|'sinus'", "", "Cosine and sine are std::cos(…) and std::sin(…)."},

    // what the words alone tell
    {"return-statement with no value|should return a value", "",
     "Put the answer behind return: return a; or, for nothing, return {};"},
    {"non-void function|no return statement", "", "Some path through this function has no `return`."},
    {"reference to local variable|returning reference to |address of (?:local variable|stack memory)|reference to "
     "stack memory",
     "", "What this refers to is gone when the function ends: return a copy, Vec2 instead of const Vec2 &."},
    {"object backing the pointer will be destroyed", "",
     "What this refers to is gone at the end of the line: give the whole list or value a name first."},
    {"unable to find numeric literal operator|invalid suffix '", "", missing_star},
    {R"(unresolved overloaded function type|cannot resolve overloaded function|wrong type argument to unary minus|\(Eigen::MatrixBase<Vec2>::\)\(\) const' to type|reference to non-static member function must be called|invalid use of (?:non-static )?member function)",
     "", call_it},
    {R"(no match for call to '\((?:const )?Vec2\) \(\)'|call to object of type '(?:const )?Vec2')", "", no_call},
    {"comparison in operand of|do not have their mathematical meaning|with (?:boolean expression|expression of type "
     "'bool') is always",
     "", "Compare two at a time: a < b && b < c."},
    {"product of Vec2s", "", write_dot},
    {"INVALID_VECTOR_VECTOR_PRODUCT", "", "Two vectors have no product with *: a.dot(b) is their dot product."},
    {"IT_IS_READ_ONLY", "", "Write Vec2 in the place of auto."},
    {"FLOATING_POINT_ARGUMENT_PASSED__INTEGER_WAS_EXPECTED", "", two_components},
    {"call to 'require_number", "",
     "require_range takes numbers, Vec2s and lists of them: give it a struct's fields one by one, as start.position, "
     "start.velocity."},
    {"assignment used as truth value|result of an assignment as a condition", "", compare_it},
    {"function[- ]definition is not allowed here", "",
     "A function can't stand inside another one: put it above. If it isn't meant to be inside, a } is missing above "
     "this line."},
    {"expected '\\}' before 'else'", "", missing_brace},
    {"ambiguating new declaration|functions that differ only in their return type", "",
     "The header gives this function another result: copy its line from there."},
    {R"(to 'const char\*'|of type 'const char \*' with an rvalue)", "", "Text needs double quotes: \"like this\"."},
    {"shadows a previous local|declaration shadows a local variable", "",
     "A type before the name makes a second variable: to change the first one, leave it out."},
    {"shadows a parameter|redeclaration of '|conflicting declaration '|redefinition of '|with a different type: '", "",
     "The name is taken already: use what has it, or choose another name."},
    {"of different sign(?:edness|s)", "", "The size of a list is a std::size_t: for (std::size_t i = 0; …)."},
    {"conversion from 'double' to 'int'|number into integer: 'double' to 'int'", "",
     "An int has no digits after the decimal point: to keep them, write double; to drop them, int(…)."},
    {R"(vector<double>::push_back\(<brace)", "", "push_back takes one value: call it once for each number."},
    {"push_back", "", "push_back takes one value: call it once for each number.",
     "initializer list argument to 'const std::vector<double>"},
    {"push_back", "",
     "push_back takes one value: a Vec2 or a struct in braces, push_back({a, b}), or one number at a time.",
     "expects 1 argument|requires single argument"},
    {"too (?:few|many) arguments to function", "", "Look up in the header how many arguments this function has."},
    {"no matching function for call to", "", "Look up in the header how many arguments this function has.",
     "candidate function not viable: requires"},
    {"assignment of read-only|crement of read-only|in read-only object|discards qualifiers|returns a const value|with "
     "const-qualified type|function is not marked const|drops 'const' qualifier",
     "", copy_it},
    {"no viable overloaded '|no matching member function for call", "", copy_it,
     "not marked const|for object argument"},
};

} // namespace

std::span<const AdviceRule> advice_rules() { return rule_table; }

} // namespace course
