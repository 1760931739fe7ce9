// Slips that beginners make, each with what `check` adds to the compiler's words: see advice_test.cpp, which has this file
// compiled by GCC and by Clang. A line without a comment, or with `// nothing`, has to be explained by its compiler alone.
// clang-format off
#include "course.hpp"

#include <algorithm>
#include <map>
#include <optional>
#include <unordered_map>
#include <vector>

using course::Vec2;

struct Spark { Vec2 position; double age{}; };

std::vector<Spark> changed_pool(const std::vector<Spark> &pool, const Spark &spark) {
    pool.push_back(spark);                     // It's const, so you can't change it: copy it, and change the copy.
    pool.pop_back();                           // It's const, so you can't change it: copy it, and change the copy.
    pool[0] = spark;                           // It's const, so you can't change it: copy it, and change the copy.
    pool[0].age = 1;                           // It's const, so you can't change it: copy it, and change the copy.
    pool[0].age += 1;                          // It's const, so you can't change it: copy it, and change the copy.
    pool[0].position = Vec2{1, 2};             // It's const, so you can't change it: copy it, and change the copy.
    pool[0].position += Vec2{1, 2};            // It's const, so you can't change it: copy it, and change the copy.
    for (Spark &each : pool) each.age = 1;     // It's const, so you can't change it: copy it, and change the copy.
    return pool;
}
void changed_parameter(const Spark &spark, const Vec2 &v, const double t) {
    spark.age = 1;                             // It's const, so you can't change it: copy it, and change the copy.
    spark = Spark{};                           // It's const, so you can't change it: copy it, and change the copy.
    v.x() = 3;                                 // It's const, so you can't change it: copy it, and change the copy.
    v *= 2;                                    // It's const, so you can't change it: copy it, and change the copy.
    t = 3;                                     // It's const, so you can't change it: copy it, and change the copy.
}
Vec2 times_braces(double x, double y) {
    Vec2 a = 2 * {x, y};                       // Write Vec2 before the braces: 2 * Vec2{x, y}.
    return a;
}
Vec2 plus_braces(Vec2 a) {
    a = a + {1, 2};                            // Write Vec2 before the braces: 2 * Vec2{x, y}.
    return a;
}
Vec2 braces_divided(double x, double y, double length) {
    const Vec2 a = {-y, x} / length;           // Write Vec2 before the braces: 2 * Vec2{x, y}.
    return a;
}
bool other_braces(Vec2 a) {
    return a == {1, 2};                        // nothing
}
double field_of_an_optional(const std::optional<Spark> &found) {
    return found.age;                          // It may be nothing: ask first, if (found), and then write found->age.
}
double field_of_a_struct(const Spark &spark) {
    return spark.speed;                        // Look up the fields of Spark in the header.
}
bool compared_optional(const std::optional<Spark> &found, const std::optional<double> &t) {
    if (found > 0) return true;                // An optional may be nothing: ask first, if (found), and then compare *found, or its field found->t.
    if (1 == found) return true;               // An optional may be nothing: ask first, if (found), and then compare *found, or its field found->t.
    double x = t;                              // It may be nothing: ask first, if (found), and then write *found.
    return x > 0;
}
std::optional<double> bare_return(double t) {
    if (t < 0) return;                         // Put the answer behind return: return a; or, for nothing, return {};
    return t;
}
double section_with_a_dot(double t) {
    return std.abs(t);                         // Behind std come two colons: std::sqrt(x).
}
double misspelt(double t) {
    t = squrt(t);                              // nothing
    retrun t;                                  // Write return, in these letters.
}
int without_header(const std::vector<int> &numbers) {
    for (int i : numbers | std::views::reverse) return i; // Write #include <ranges> at the top of your file.
    return 0;
}
int whole_number(double fraction, int shades) {
    int shade = fraction * shades;             // An int has no digits after the decimal point: to keep them, write double; to drop them, int(…).
    return shade;
}
double two_types(double t, const std::vector<Spark> &pool, int capacity) {
    t = std::min(t, 1);                        // All must be of one type: write 1.0, not 1.
    t = std::max(0, t);                        // All must be of one type: write 1.0, not 1.
    t = std::clamp(t, 0, 1);                   // All must be of one type: write 1.0, not 1.
    capacity = std::min(pool.size(), capacity);// All must be of one type: the size of a list as an int is int(list.size()).
    return t + std::min(t);                    // nothing
}
std::vector<Vec2> two_values(double x, double y, std::vector<Vec2> list, Spark spark) {
    list.push_back(x, y);                      // push_back takes one value: a Vec2 or a struct in braces, push_back({a, b}), or one number at a time.
    std::vector<double> numbers;
    numbers.push_back({x, y});                 // push_back takes one value: call it once for each number.
    list.push_back(spark);                     // A Spark is a struct: use its fields, one at a time.
    return list;
}
std::vector<Vec2> one_point(const Vec2 &a, const std::optional<Vec2> &found, double t) {
    if (t < 0) return 0;                       // A list needs braces: return {a}; for one value, return {}; for none.
    if (t > 1) return found;                   // A list needs braces: return {a}; for one value, return {}; for none.
    return a;                                  // A list needs braces: return {a}; for one value, return {}; for none.
}
double semicolons(double x, double y) {
    double a = x + y
    double b = 2;                              // Look at the end of the line above: is its ; there?
    x += y                                     // A ; is missing at the end of this line.
    y += 2;
    double c = x + y) * 2;                     // nothing
    double d = 2 x;                            // Is a * missing? A product needs it: 2 * t, 2 * (a + b).
    y = x return y;                            // nothing
    return a
}
double operands(Vec2 a, Vec2 b, double t) {
    t = t ^ 2;                                 // ^ isn't a power: write (t * t), with the brackets.
    a = a ^ 2;                                 // ^ isn't a power: write (t * t), with the brackets.
    t = a - b.norm();                          // Only the last one is measured. Put brackets around all of it: (a - b).norm().
    if (a - b.squaredNorm() < 1) return 1;     // Only the last one is measured. Put brackets around all of it: (a - b).norm().
    const std::vector<Vec2> centres{a, b};
    const int i = 0;
    t = centres[i] - centres[i + 1].norm();    // Only the last one is measured. Put brackets around all of it: (a - b).norm().
    t = b + 2.0 * a.norm();                    // One of them is a number, the other a vector: its components are a.x() and a.y(), its length is a.norm().
    a = a + 1;                                 // One of them is a number, the other a vector: its components are a.x() and a.y(), its length is a.norm().
    if (a < b) return 1;                       // No vector is larger than another: compare their components, or their lengths.
    a = a / b;                                 // No vector can be divided by a vector: divide by its length, a / a.norm().
    if (1 < a) return 1;                       // One of them is a number, the other a vector: its components are a.x() and a.y(), its length is a.norm().
    t = a;                                     // A Vec2 isn't a number: its components are a.x() and a.y(), its length is a.norm().
    Vec2 c = t;                                // A Vec2 has two components: write Vec2{x, y}.
    t = a.x * 2;                               // A call needs parentheses: a.x(), not a.x.
    t = a.x;                                   // A call needs parentheses: a.x(), not a.x.
    t = -a.x;                                  // A call needs parentheses: a.x(), not a.x.
    return c.x();
}
double product(Vec2 a, Vec2 b) {
    return a * b;                              // For the dot product of two vectors write a.dot(b).
}
double half_a_product(Vec2 a, Vec2 b) {
    return (a * b) / 2.0;                      // For the dot product of two vectors write a.dot(b).
}
double largest(Vec2 a, Vec2 b) {
    return std::max(a, b).x();                 // No vector is larger than another: compare their components, or their lengths.
}
double early(Vec2 a, Vec2 b) {
    return area(a, b);                         // If area is a function of yours, put it above the one that calls it.
}
double area(Vec2 a, Vec2 b) { return a.x() * b.y() - a.y() * b.x(); }
std::optional<Spark> nothing(bool none, Vec2 a) {
    if (none) return false;                    // To answer nothing, write return {};
    if (none) return 0;                        // To answer nothing, write return {};
    return a;                                  // nothing
}
void spark_range(const Spark &spark) {
    course::require_range(spark);              // require_range takes numbers, Vec2s and lists of them: give it a struct's fields one by one, as start.position, start.velocity.
}
void automatic(Vec2 a, Vec2 b) {
    auto c = a + b;
    c += b;                                    // Write Vec2 in the place of auto.
}
Spark two_returned(Vec2 a, double b) {
    return a, b;                               // Two values need braces: return {first, second};
}
Vec2 two_components_returned(double x, double y) {
    if (x > 0) return std::max(x, y);          // A Vec2 has two components: write Vec2{x, y}.
    return x, y;                               // Two values need braces: return {first, second};
}
std::optional<Vec2> none_returned() {
    return none;                               // To answer nothing, write return {};
}
void struct_as_a_vector(const Spark &spark, Vec2 v, double t) {
    v = spark + t * v;                         // A Spark is a struct: use its fields, one at a time.
    v = 2 * spark;                             // A Spark is a struct: use its fields, one at a time.
    Vec2 w = spark;                            // A Spark is a struct: use its fields, one at a time.
    if (spark == v) return;                    // nothing
    v = w + spark.position();                  // A field has no parentheses: write a.position, not a.position().
    v = spark.age() * w;                       // A field has no parentheses: write a.position, not a.position().
    v = spark.position;
}
Vec2 missing_stars(Vec2 start, Vec2 velocity, double t) {
    start = 0.5(start + velocity);             // Is a * missing? A product needs it: 2 * t, 2 * (a + b).
    t = (t + 1)(t - 1);                        // Is a * missing? A product needs it: 2 * t, 2 * (a + b).
    start = (start + velocity)0.5;             // Is a * missing? A product needs it: 2 * t, 2 * (a + b).
    if (t > 1) return velocity.norm() - t;     // A Vec2 has two components: write Vec2{x, y}.
    t = 2(velocity.norm());                    // Is a * missing? A product needs it: 2 * t, 2 * (a + b).
    return start + velocity t;                 // Is a * missing? A product needs it: 2 * t, 2 * (a + b).
}
Spark two_in_parentheses(Vec2 a, double b) {
    if (b > 0) return (a + 2 * (a - a), b);    // Two values need braces: return {first, second};
    return 2 * (a + a), b;                     // Two values need braces: return {first, second};
}
Vec2 unknown_names(const Spark &spark, const std::vector<Spark> &pool) {
    Vec2 sum = position + spark.position;      // A field needs its struct, as in start.velocity; a variable is known below the line that declares it, inside the same braces.
    for (const Spark &body : pool) sum += body.position;
    sum += body.position;                      // A field needs its struct, as in start.velocity; a variable is known below the line that declares it, inside the same braces.
    sum *= m1;                                 // If m1 is a letter of a formula, say what it is in the code: a parameter, or a field of one, as in a.mass; else declare it above.
    sum *= 2 * pi;                             // Write std::numbers::pi, and #include <numbers> at the top of your file.
    for (int i = 0; i < 3; ++i) {
        Vec2 sum = Vec2{1, 2};                 // A type before the name makes a second variable: to change the first one, leave it out.
    }
    cout << sum;                               // Write std::cout, and #include <iostream> at the top of your file.
    return sum;
}
std::optional<Vec2> list_for_an_optional(bool none) {
    if (none) return {0, 0};                   // Write its type before the braces, Vec2{…}; to answer nothing, write return {};
    return {};
}
void single_quotes(double t) {
    course::require(t > 0, 't', t);            // Text needs double quotes: "like this".
}
bool warnings(double t, const std::vector<Spark> &pool) {
    for (int i = 0; i < pool.size(); ++i) t += 1;  // The size of a list is a std::size_t: for (std::size_t i = 0; …).
    if (t = 1) return true;                    // = gives a value; to compare, write ==.
    return 0 <= t <= 1;                        // Compare two at a time: a < b && b < c.
}
struct Two { double a{}, b{}; };
Two two_of(const Spark &first, const Spark &second) {
    if (first.age < 0) return {first, second}; // The braces hold the fields of the result, in the order of the header: where it has a number, a.mass, say; where it has a Vec2, a.velocity; not the whole a.
    if (first.age < 1) return first.age;       // A Two is wanted here: put its fields in braces, in the order of the header.
    Two of_one = second.age;                   // A Two is wanted here: put its fields in braces, in the order of the header.
    two_of(first.age, 2);                      // A whole Spark is wanted here, not a number: pass one that you have, a and not a.mass, or make one of its fields in braces, in the order of the header.
    Two two = two_of(first, second);
    two.a = two.b.age;                         // That is a number already: it has no fields.
    return two;
}
double compared_with_one_sign(const Spark &spark, const double age) {
    if (age = 0) return 1;                     // = gives a value; to compare, write ==.
    if (age < 0 || spark.age + age = 0) return 1;  // = gives a value; to compare, write ==.
    while (spark.age = age) return 1;          // = gives a value; to compare, write ==.
    if (age >= 0) age = 1;                     // It's const, so you can't change it: copy it, and change the copy.
    spark.age + age = 3;                       // nothing
    return 0;
}
std::vector<double> other_lists(const std::vector<Spark> &pool, const std::vector<Vec2> &forces, Vec2 sum) {
    std::vector<double> ages;
    for (const Spark &spark : pool) ages.push_back(spark); // A Spark is a struct: use its fields, one at a time.
    for (const Vec2 &force : forces) sum =+ force; // To add to a value, write += and not =+.
    return pool;                               // The lists hold different things: begin an empty one, and fill it with push_back.
}
Vec2 powers_and_lengths(const Vec2 &a, const Vec2 &b, const Spark &spark, double t) {
    const double length = a.norm;              // A call needs parentheses: a.x(), not a.x.
    const double size = norm(a);               // The length of a Vec2 is a.norm().
    const double reach = a.length();           // The length of a Vec2 is a.norm().
    const double turn = 2 * std::pi;           // Write std::numbers::pi, and #include <numbers> at the top of your file.
    const double twice = 2t;                   // Is a * missing? A product needs it: 2 * t, 2 * (a + b).
    const double square = t²;                  // ² isn't C++: write (t * t), with the brackets.
    const double cube = t ** 3;                // ** isn't a power: write (t * t), with the brackets.
    if t < 1 return a;                         // An if needs parentheses: if (t < 1) …
    two_of(spark, a);                          // A Spark is wanted here: put its fields in braces, in the order of the header.
    two_of(two_of(spark, spark), spark);       // A Spark is wanted here: put its fields in braces, in the order of the header.
    return a;
}
double time_of(const Spark &spark, double g);
double by(const Vec2 &a, double t);
double calls_of_functions(const Spark &spark, double angle, double g) {
    angle = angle * numbers::pi / 180;         // Write std::numbers::pi, and #include <numbers> at the top of your file.
    const double twice = 2 * time_of;          // That is a function: call it, with what it needs in parentheses.
    const double once = time_of;               // That is a function: call it, with what it needs in parentheses.
    while (angle < time_of) angle += 1;        // That is a function: call it, with what it needs in parentheses.
    angle = time_of();                         // Look up in the header how many arguments this function has.
    angle = time_of(spark, g, 3);              // Look up in the header how many arguments this function has.
    angle = by(-g, 1);                         // A Vec2 has two components: write Vec2{x, y}.
    return angle;
}
struct Disc { Vec2 position, velocity; double radius{}; };
Vec2 turned(const Vec2 &v, double angle);
Vec2 minus_a_number(const Vec2 &velocity, const Vec2 &normal) {
    if (normal.x() > 0) return velocity - velocity.dot(normal); // a.dot(b) is a number; a.dot(b) * b is a vector.
    const Vec2 part = velocity.dot(normal);    // a.dot(b) is a number; a.dot(b) * b is a vector.
    const Vec2 n = normal.norm();              // a.norm() is a number; a / a.norm() is a vector of length 1.
    if (n.x() > 0) return velocity - 2 * dot(velocity, normal) * normal; // For the dot product of two vectors write a.dot(b).
    if (n.x() > 1) return velocity - 2 velocity.dot(normal) * normal; // Is a * missing? A product needs it: 2 * t, 2 * (a + b).
    if (n.x() > 2) return velocity.dot(n.x()) * velocity; // A dot product has a vector on each side: a.dot(b).
    return velocity - 2 * velocity.dot(normal); // a.dot(b) is a number; a.dot(b) * b is a vector.
}
Vec2 used_too_early(const Vec2 &velocity, const Vec2 &normal, const Disc &disc, double angle) {
    if (velocity.dot(n) > 0) return velocity;  // If n is a letter of a formula, say what it is in the code: a parameter, or a field of one, as in a.mass; else declare it above.
    if (angle > 0) return turned(disc, -angle); // A Disc is a struct: use its fields, one at a time.
    const part = velocity.dot(normal) * normal; // A variable needs its type: const Vec2 a = …; or const double a = …;
    const seen{velocity, 2};                   // A variable needs its type: const Vec2 a = …; or const double a = …;
    const Vec2 normal = normal / normal.norm(); // The name is taken already: use what has it, or choose another name.
    return velocity;
}
Vec2 without_a_type(Vec2 v, angle) {           // A parameter needs its type, too: (Vec2 v, double t).
    return v;
}
Vec2 questions(const Vec2 &v, double x, double y, double count) {
    if ((x > 2 && y > 2) x = -x;               // Count the parentheses of the if: is a ) missing?
    if (x > 2) x = -x;
    else (y > 2) y = -y;                       // A question after else needs an if of its own: else if (t < 1) …
    if (x > 2) && (y > 2) x = -x;              // One pair of parentheses holds the whole question: if (a > 0 && b > 0) …
    if (x > 2) || (y > 2) x = -x;              // One pair of parentheses holds the whole question: if (a > 0 && b > 0) …
    if (x => 2) x = -x;                        // At least is >=, and at most is <=: the = comes last.
    if (x =< 2) x = -x;                        // At least is >=, and at most is <=: the = comes last.
    if (x > 3);                                // The ; behind the parentheses ends the if: remove it.
    x = count % 2;                             // % is for whole numbers: make both an int.
    return {x, y};
}
Vec2 questions_to_a_return(const Vec2 &v, const Vec2 &normal) {
    if (v.dot(normal) > 0 return v;            // Count the parentheses of the if: is a ) missing?
    return normal;
}
Vec2 turned_by_std(const Vec2 &v, double angle) {
    const double c = std::cos angle;           // A call needs parentheses: std::cos(…).
    Vec2 w = std::cos angle * v;               // A call needs parentheses: std::cos(…).
    w.x() = v.x() * std::cos angle - v.y();    // A call needs parentheses: std::cos(…).
    return w;
}
struct Box { Vec2 low, high; };
double type_with_a_dot(const Box &box, const Disc &disc) {
    if (disc.radius > Box.high.x()) return 1;  // Box is a type: before the dot, write the name of the parameter or variable, as in box.high.
    Disc.position.x();                         // Disc is a type: before the dot, write the name of the parameter or variable, as in disc.position.
    const double length = Vec2.norm();         // Vec2 is a type: before the dot, write the name of the parameter or variable, as in velocity.norm.
    return Box.low.x();                        // Box is a type: before the dot, write the name of the parameter or variable, as in box.low.
}
Vec2 forgotten_variable(const Disc &disc) {
    if (disc.position.x() > 2) x = 1;          // If x is a letter of a formula, say what it is in the code: a parameter, or a field of one, as in a.mass; else declare it above.
    return turned_twice(disc.velocity) + y(2); // If turned_twice is a function of yours, put it above the one that calls it.
}
Vec2 function_in_a_function(const Vec2 &v) {
    Vec2 turned_within(const Vec2 &w) {        // A function can't stand inside another one: put it above. If it isn't meant to be inside, a } is missing above this line.
        return w;
    }
    return v;
}
double length_of(const Vec2 &part, double x) {
    if (x > 2) and (x < 3) return 2;           // One pair of parentheses holds the whole question: if (a > 0 && b > 0) …
    if (x > 2) or (x < 3) return 2;            // One pair of parentheses holds the whole question: if (a > 0 && b > 0) …
    return std::abs(part);                     // The length of a Vec2 is a.norm().
}
bool nothing(bool none, Vec2 a);               // The header gives this function another result: copy its line from there.
struct Pair { int first{}, second{}; };
struct Parts { double normal{}, tangential{}; };
Parts parts(const Vec2 &v);
std::vector<Pair> grid_of_pairs(const std::vector<Vec2> &points) {
    std::map<std::pair<int, int>, std::vector<int>> grid;
    std::vector<Pair> pairs;
    grid[1, 2].push_back(3);                   // Brackets take one value: a key of two numbers stands in braces, grid[{1, 2}].
    grid[1][2].push_back(3);                   // Brackets take one value: a key of two numbers stands in braces, grid[{1, 2}].
    grid[points[0]].push_back(3);              // Brackets take one value: a key of two numbers stands in braces, grid[{1, 2}].
    grid[{1, 2}] = 3;                          // What stands in this map are lists: grid[{1, 2}].push_back(3) adds to one, and for (const int i : grid[{1, 2}]) goes through one.
    grid.push_back({1, 2});                    // What stands in this map are lists: grid[{1, 2}].push_back(3) adds to one, and for (const int i : grid[{1, 2}]) goes through one.
    for (int i : grid) pairs.push_back({i, 2}); // What stands in this map are lists: grid[{1, 2}].push_back(3) adds to one, and for (const int i : grid[{1, 2}]) goes through one.
    const int near = grid[{0, 1}];             // What stands in this map are lists: grid[{1, 2}].push_back(3) adds to one, and for (const int i : grid[{1, 2}]) goes through one.
    pairs.push_back((1, 2));                   // Two values need braces: push_back({first, second});
    pairs.push_back({points[0], points[1]});   // The braces hold the fields of a Pair, in the order of the header.
    return near > 0 ? pairs : std::vector<Pair>{};
}
int keys(const Pair &pair) {
    std::map<Pair, int> by_pair;
    std::unordered_map<std::pair<int, int>, int> hashed; // A std::unordered_map can't have such a key: a std::map can.
    by_pair[pair] = 1;                         // What is sorted, or is a map's key, must have an order: numbers have one, and so has std::pair<int, int>.
    return 0;
}
Parts two_parts(const Vec2 &v, const Vec2 &n) {
    const double unit = (v - n).normalized();  // A Vec2 isn't a number: its components are a.x() and a.y(), its length is a.norm().
    if (parts(v) <= parts(n)) return {unit, 2}; // A Parts is a struct: use its fields, one at a time.
    const Vec2 gap = v.position - n;           // That is a vector already: its components are a.x() and a.y().
    const Vec2 other = gap.x() > 0 ? {1, 0} : gap; // Write the type before the braces: Vec2{1, 0}.
    return n;                                  // A Parts is wanted here: put its fields in braces, in the order of the header.
}
std::optional<double> half_of_it(const Vec2 &v) {
    if (v.x() > 0) return v;                   // A Vec2 isn't a number: its components are a.x() and a.y(), its length is a.norm().
    return v / 2;                              // A Vec2 isn't a number: its components are a.x() and a.y(), its length is a.norm().
}
Vec2 made_of_vectors(const Vec2 &a, const Vec2 &b) {
    const Vec2 way = {a, b};                   // A Vec2 is made of two numbers, Vec2{x, y}, and not of two vectors: the vector from a to b is b - a.
    return way;
}
Vec2 made_of_half_a_vector(const Vec2 &a, const Vec2 &b) {
    return Vec2{b - a, 2.0};                   // A Vec2 is made of two numbers, Vec2{x, y}, and not of two vectors: the vector from a to b is b - a.
}
struct Place { double x{}; };
Vec2 turned_left(const Vec2 &n, const Place &place) {
    if (n.x() > 0) return Vec2{n.y, -n.x()};   // A call needs parentheses: a.x(), not a.x.
    const Vec2 left{-n.y(), n.x};              // A call needs parentheses: a.x(), not a.x.
    const Vec2 right = {n.y(), n.x};           // A call needs parentheses: a.x(), not a.x.
    const Vec2 three{place.x, 1, 2, n};        // nothing
    return left;
}
Parts parts_of(const Vec2 &v, const Vec2 &n, double x) {
    if (x > 0) return {n * v, v.dot(n)};       // For the dot product of two vectors write a.dot(b).
    if (x > 1) return {v.dot(n), n * v};       // For the dot product of two vectors write a.dot(b).
    if (x > 2) {v.dot(n), x};                  // An answer needs return before its braces: return {a, b};
    if (x > 3) { v.dot(n), n.dot(v) }          // An answer needs return before its braces: return {a, b};
    if (x > 4) { x = 1, x += 2 }               // nothing
    if (x > 5) { double y, z }                 // nothing
    if (x > 6) { std::swap(x, x) }             // nothing
    return Vec2{v.dot(n), x};                  // A Parts is wanted here: put its fields in braces, in the order of the header.
}
Parts parts_without_return(const Vec2 &v, const Vec2 &n) {
    {v.dot(n), v.dot(v)};                      // An answer needs return before its braces: return {a, b};
}
Two other_struct(const Spark &spark, const Disc &disc, double x) {
    if (x > 0) return spark;                   // A Two is wanted here, not a Spark: put its fields in braces, in the order of the header.
    if (x > 1) return Disc{disc.position, disc.velocity - x * disc.position, x}; // A Two is wanted here, not a Disc: put its fields in braces, in the order of the header.
    if (x > 2) return Spark{spark.position - x * disc.velocity, spark.position + x * disc.velocity}; // The braces of a Spark hold its fields, in the order of the header; if the result is another struct, write return {…};
    if (x > 3) return Spark{disc.position, disc.velocity}; // The braces of a Spark hold its fields, in the order of the header; if the result is another struct, write return {…};
    const Pair pair = Pair{disc.position, disc.velocity}; // The braces of a Pair hold its fields, in the order of the header.
    return Two;                                // Two is a type: answer with a value, a variable or Two{…}.
}
void unfinished(double t) {
    std::vector<Pair> pairs
    std::map<int, int> grid;                   // Look at the end of the line above: is its ; there?
    double root
    for (int i = 0; i < 3; ++i) t += i;        // Look at the end of the line above: is its ; there?
}
void without_std(Spark spark, Spark other, double t) {
    vector<Pair> pairs;                        // Write std::vector, and #include <vector> at the top of your file.
    map<std::pair<int, int>, int> grid;        // Write std::map, and #include <map> at the top of your file.
    t = max(0.0, t);                           // Write std::max, and #include <algorithm> at the top of your file.
    t = min(0.0, t);                           // Write std::min, and #include <algorithm> at the top of your file.
    swap(spark, other);                        // Write std::swap, and #include <utility> at the top of your file.
    t = v * t + h;                             // If v is a letter of a formula, say what it is in the code: a parameter, or a field of one, as in a.mass; else declare it above.
    t = 2 * w;                                 // If w is a letter of a formula, say what it is in the code: a parameter, or a field of one, as in a.mass; else declare it above.
    for (int i = 0; i < 3; ++i) t += 1;
    t = i;                                     // A field needs its struct, as in start.velocity; a variable is known below the line that declares it, inside the same braces.
    t = (1 + e) * t;                           // If e is a letter of a formula, say what it is in the code: a parameter, or a field of one, as in a.mass; else declare it above.
    push_back(t, 2);                           // The list stands before the dot: list.push_back(a).
}
std::vector<Pair> brackets(const std::vector<Vec2> &centres) {
    std::map<std::pair<int, int>, std::vector<int>> grid;
    std::map<std::pair<int, int>, int> counts;
    std::map<int, int, std::vector<int>> three;
    grid({1, 2}).push_back(3);                 // The brackets of a map are square: grid[{1, 2}].
    grid(1, 2).push_back(3);                   // The brackets of a map are square: grid[{1, 2}].
    counts[{1, 2}].push_back(3);               // push_back adds to a list, and this map has none: std::map<std::pair<int, int>, std::vector<int>>.
    three[{1, 2}].push_back(3);                // A map has one key and one value: std::map<std::pair<int, int>, std::vector<int>>.
    std::map<(int, int), std::vector<int>> no; // A map has one key and one value: std::map<std::pair<int, int>, std::vector<int>>.
    const Vec2 first = centres(0);             // An element of a list stands in square brackets: list[i].
    return {};
}
std::vector<Pair> lists(const std::vector<Vec2> &centres, const std::vector<Spark> &pool, const std::vector<int> &numbers) {
    std::vector<Pair> pairs;
    pairs.add({1, 2});                         // To add to a list, write list.push_back(a).
    pairs.append({1, 2});                      // To add to a list, write list.push_back(a).
    pairs.push_back(centres[0]);               // A Pair is wanted here: put its fields in braces, in the order of the header.
    const int many = centres.length;           // How many elements a list has is list.size().
    const double x = centres.x();              // That's a list: one element of it is list[i], the first is list[0].
    const double age = pool.age;               // That's a list: one element of it is list[i], the first is list[0].
    pool.shuffle();                            // nothing
    numbers.x();                               // nothing
    return pairs;
}
void loop_in(const std::vector<Vec2> &centres, const std::vector<int> &numbers) {
    for (int e in numbers) e += 1;             // A loop over a list has a colon: for (const Vec2 &v : list), or for (int i : list).
}
void loop_of(const std::vector<Vec2> &centres, const std::vector<int> &numbers) {
    for (const Vec2 &v of centres) v.norm();   // A loop over a list has a colon: for (const Vec2 &v : list), or for (int i : list).
}
void loop_without_parentheses(const std::vector<int> &numbers) {
    for e in numbers: e += 1;                  // A loop over a list has a colon: for (const Vec2 &v : list), or for (int i : list).
}
std::optional<double> signs_and_questions(Vec2 n, const Vec2 &m, double t, double x) {
    double x = 2;                              // The name is taken already: use what has it, or choose another name.
    int t = 2;                                 // The name is taken already: use what has it, or choose another name.
    if (n = Vec2{0, 0}) return t;              // = gives a value; to compare, write ==.
    if (m = Vec2{0, 0}) return t;              // = gives a value; to compare, write ==.
    if (t > 3); return t;                      // The ; behind the parentheses ends the if: remove it.
    if (t > 4) return "nothing";               // To answer nothing, write return {};
    if (t > 5) return 'nothing';               // To answer nothing, write return {};
    if (t > 6) return -n;                      // A Vec2 isn't a number: its components are a.x() and a.y(), its length is a.norm().
    if (t > 7) return -t +/- x;                // ± stands for two values: write + for one of them, and - for the other.
    return -t ± x;                             // ± stands for two values: write + for one of them, and - for the other.
}
struct Unclosed { int a{}; };
void unclosed() {
    std::map<std::pair<int, int>, std::vector<int> cells; // Each < of a type needs its >: is one missing?
}
void list_of_your_own(double t) {
    std::map<int, vector<int>> lists;          // Write std::vector, and #include <vector> at the top of your file.
    t = map + 1;                               // A field needs its struct, as in start.velocity; a variable is known below the line that declares it, inside the same braces.
}
double one_word(Vec2 a, Vec2 b, Vec2 v, double t) {
    if (t > 1) t = 1;
    elseif (t > 2) t = 2;                      // Write else if, in two words.
    Vec2 n = (b - a) - 1; t = v.dot(n);        // One of them is a number, the other a vector: its components are a.x() and a.y(), its length is a.norm().
    t = 3; a = a.dot(b) + b; t = b.norm();     // a.dot(b) is a number; a.dot(b) * b is a vector.
    return t;
}
std::vector<Vec2> an_arm(const Vec2 &base, const Spark &spark) {
    Vec2 points = base;
    points.push_back(base);                    // Only a list has push_back: std::vector<Vec2> list;
    const double x = 2 * std::cos(spark);      // A Spark is a struct: use its fields, one at a time.
    return {points};
}
struct Stick { double length{}; };
double sticks_and_pairs(const std::vector<Stick> &sticks, const std::vector<Vec2> &points, Vec2 a, const Stick &stick) {
    const double b = 2 * length;               // A field needs its struct, as in start.velocity; a variable is known below the line that declares it, inside the same braces.
    const double c = 2 * sticks.length;        // That's the whole list: one element of it is list[i], and how many it has is list.size().
    const Vec2 last = points.last();           // The last element of a list is list.back().
    a = a + (stick.length, 0.0);               // Two numbers make a vector in braces: Vec2{a, b}, not (a, b).
    a = (stick.length, 0.0);                   // Two numbers make a vector in braces: Vec2{a, b}, not (a, b).
    a = Vec2{std::cosinus(b), 1};              // Cosine and sine are std::cos(…) and std::sin(…).
    return 2 * hand.x();                       // A field needs its struct, as in start.velocity; a variable is known below the line that declares it, inside the same braces.
}
const Vec2 &gone(double t) {
    const Vec2 v{t, 1};
    return v;                                  // What this refers to is gone when the function ends: return a copy, Vec2 instead of const Vec2 &.
}
