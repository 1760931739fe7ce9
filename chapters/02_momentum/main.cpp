#include "../program.hpp"

#include "game.hpp"

using namespace momentum;
using course::row, course::text;

//> Forces on a cart
void print_forces(std::ostream &out) {
    const Vec2 rope{6, 4}, string{-2, 1}, weight{0, -19.6}, rail{0, 14.6}; // [N]
    out << row({{"what acts on it", 34}, {"1 kg [m/s²]", 13}, {"2 kg [m/s²]", 0}});
    const auto line = [&](const std::string &what, const std::vector<Vec2> &forces) {
        const Vec2 light = acceleration_due_to(forces, 1), heavy = acceleration_due_to(forces, 2);
        out << row({{what, 34}, {text(light), 13}, {text(heavy), 0}});
    };
    line("nothing", {});
    line("the rope", {rope});
    line("the rope and the string", {rope, string});
    line("all four, with weight and rail", {rope, string, weight, rail});
}

//> The rail in letters
/// A rail of 12 m as 48 letters: `|   A        B       |`. What is outside is not shown.
std::string rail(const std::vector<std::pair<char, double>> &carts) {
    std::string letters(48, ' ');
    for (const auto &[letter, x] : carts)
        if (0 <= x && x < 12) letters[std::size_t(4 * x)] = letter;
    return '|' + letters + '|';
}

//> Two carts meet
const Cart a{.mass = 2, .velocity = 4}, b{.mass = 3, .velocity = -2};
const double start_a = 1.4, start_b = 8.5; // [m]

void print_meeting(std::ostream &out) {
    out << row({{"t [s]", 7}, {"v_a", 6}, {"v_b", 6}, {"the rail, 12 m long", 0}});
    RailCart left{start_a, a}, right{start_b, b};
    for (int frame = 0; frame <= 150; ++frame) {
        if (frame % 30 == 0)
            out << row({{text(frame / 60.0), 7},
                        {text(left.cart.velocity), 6},
                        {text(right.cart.velocity), 6},
                        {rail({{'A', left.x}, {'B', right.x}}), 0}});
        next_frame(left, right, 1.0 / 60);
    }
}

//> Two carts meet, traced
void trace_meeting(std::ostream &out) {
    out << "# t[s]\ta x[m]\tb x[m]\n";
    RailCart left{start_a, a}, right{start_b, b};
    for (int frame = 0; frame <= 144; ++frame) {
        if (frame % 6 == 0) out << frame / 60.0 << '\t' << left.x << '\t' << right.x << '\n';
        next_frame(left, right, 1.0 / 60);
    }
}

//> Main
int main(int argc, char **argv) {
    return course::run(
        argc, argv, {{"forces", print_forces}, {"meeting", print_meeting}, {"02_momentum_meeting.tsv", trace_meeting}});
}
