#include "../program.hpp"

#include "game.hpp"

using namespace momentum;
using course::row, course::text;

//> The rail in letters
/// A rail of 12 m as 48 letters: `|   A        B       |`. What is outside is not shown.
std::string rail(const std::vector<std::pair<char, double>> &carts) {
    std::string letters(48, ' ');
    for (const auto &[letter, x] : carts)
        if (0 <= x && x < 12) letters[std::size_t(4 * x)] = letter;
    return '|' + letters + '|';
}

//> Two carts are pulled
void print_pulled(std::ostream &out) {
    const auto forces_on = [](const Cart &cart) { // a rope, its weight, and what the rail has to carry [N]
        const double weight = 10 * cart.mass;
        return std::vector<Vec2>{{6, 4}, {0, -weight}, {0, weight - 4}};
    };
    out << row({{"t [s]", 7}, {"2 kg [m/s]", 12}, {"3 kg [m/s]", 12}, {"the rail, 12 m long", 0}});
    RailCart light{1, {2, 0}}, heavy{1, {3, 0}};
    for (int frame = 0; frame <= 150; ++frame) {
        if (frame % 30 == 0)
            out << row({{text(frame / 60.0), 7},
                        {text(light.cart.velocity), 12},
                        {text(heavy.cart.velocity), 12},
                        {rail({{'2', light.x}, {'3', heavy.x}}), 0}});
        next_frame(light, forces_on(light.cart), 1.0 / 60);
        next_frame(heavy, forces_on(heavy.cart), 1.0 / 60);
    }
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

//> From rubber to clay
double momentum_of(const Velocities &v) { return a.mass * v.a + b.mass * v.b; }                 // [N s]
double energy_of(const Velocities &v) { return (a.mass * v.a * v.a + b.mass * v.b * v.b) / 2; } // [J]

void print_materials(std::ostream &out) {
    out << row({{"e", 6}, {"v_a", 7}, {"v_b", 7}, {"momentum [N s]", 16}, {"kinetic energy [J]", 0}});
    for (const double e : {1.0, 0.75, 0.5, 0.25, 0.0}) {
        const Velocities after = collide(a, b, e);
        out << row({{text(e), 6},
                    {text(after.a), 7},
                    {text(after.b), 7},
                    {text(momentum_of(after)), 16},
                    {text(energy_of(after)), 0}});
    }
}

//> Seen from elsewhere
void print_frames(std::ostream &out) {
    out << row({{"seen from", 24}, {"v_a", 8}, {"v_b", 8}, {"centre", 8}, {"energy around it [J]", 0}});
    for (const auto &[who, train] :
         {std::pair{"the rail", 0.0}, {"a train at 30 m/s", 30.0}, {"a train at -30 m/s", -30.0}}) {
        const Cart first{a.mass, a.velocity - train}, second{b.mass, b.velocity - train};
        const CentreOfMassFrame seen = centre_of_mass_frame(first, second);
        out << row({{who, 24},
                    {text(first.velocity), 8},
                    {text(second.velocity), 8},
                    {text(seen.velocity), 8},
                    {text(seen.energy), 0}});
    }
}

//> Clicks
/// How often they click: a body of 1 kg at rest, between a wall on its left and a heavy body that comes from the right.
int count_clicks(double heavy_mass) {
    Body wall{0, 0}, light{1, 0}, heavy{1 / heavy_mass, -1};
    for (int clicks = 0;; ++clicks) {
        if (impulse(light, heavy, 1) > 0) push_apart(light, heavy, 1);
        else if (impulse(wall, light, 1) > 0) push_apart(wall, light, 1);
        else return clicks;
    }
}

void print_clicks(std::ostream &out) {
    out << row({{"mass on the right [kg]", 24}, {"clicks", 0}});
    for (const double mass : {1.0, 100.0, 1e4, 1e6}) out << row({{text(mass), 24}, {text(count_clicks(mass)), 0}});
}

//> A row of carts
void print_cradle(std::ostream &out) {
    const auto line = [&](const std::vector<Cart> &carts) {
        std::string before, after;
        for (const Cart &cart : carts) before += text(cart.velocity) + "  ";
        for (const double velocity : newtons_cradle(carts)) after += text(velocity) + "  ";
        out << row({{before, 18}, {after, 0}});
    };
    out << row({{"before [m/s]", 18}, {"after [m/s]", 0}});
    line({{1, 3}, {1, 0}, {1, 0}, {1, 0}, {1, 0}});
    line({{1, 3}, {1, 3}, {1, 0}, {1, 0}, {1, 0}});
    line({{1, 3}, {1, 0}, {1, 0}, {1, 0}, {1, -3}});
    line({{1, 3}, {1, 0}, {3, 0}, {1, 0}, {1, 0}}); // a heavy one in the middle
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

//> Before and after, traced
void trace_plane(std::ostream &out) {
    const Velocities after = elastic_collision(a, b);
    out << "# v_a[m/s]\tv_b[m/s]\n";
    out << a.velocity << '\t' << b.velocity << '\n' << after.a << '\t' << after.b << '\n';
}

//> Momentum and energy, traced
void trace_energy(std::ostream &out) {
    out << "# restitution[1]\tmomentum[N s]\tkinetic energy[J]\n";
    for (int k = 0; k <= 20; ++k) {
        const Velocities after = collide(a, b, k / 20.0);
        out << k / 20.0 << '\t' << momentum_of(after) << '\t' << energy_of(after) << '\n';
    }
}

//> A row of carts, traced
void trace_cradle(std::ostream &out) {
    out << "# t[s]\t1 x[m]\t2 x[m]\t3 x[m]\t4 x[m]\t5 x[m]\n";
    std::vector<RailCart> carts{{0, {1, 3}}, {1, {1, 3}}, {5, {1, 0}}, {6, {1, 0}}, {7, {1, 0}}};
    for (int frame = 0; frame <= 150; ++frame) {
        if (frame % 6 == 0) {
            out << frame / 60.0;
            for (const RailCart &it : carts) out << '\t' << it.x;
            out << '\n';
        }
        next_frame(carts, 1.0 / 60);
    }
}

//> Main
int main(int argc, char **argv) {
    return course::run(argc, argv,
                       {{"pulled", print_pulled},
                        {"meeting", print_meeting},
                        {"materials", print_materials},
                        {"frames", print_frames},
                        {"clicks", print_clicks},
                        {"cradle", print_cradle},
                        {"02_momentum_meeting.tsv", trace_meeting},
                        {"02_momentum_plane.tsv", trace_plane},
                        {"02_momentum_energy.tsv", trace_energy},
                        {"02_momentum_cradle.tsv", trace_cradle}});
}
