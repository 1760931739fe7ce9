#include "../program.hpp"

#include "game.hpp"

#include <algorithm>
#include <cmath>

using namespace time_based_motion;
using course::row, course::text;

//> Whole pixels
/// Where a ship at 120 px/s is after one second, on a screen of so many frames a second; `round` stands for whole pixels.
double after_a_second(int frames, double (*round)(double)) {
    Ship ship{0, 120};
    for (int i = 0; i < frames; ++i) ship.x = round(fly(ship, 1.0 / frames).x);
    return ship.x;
}

void print_screens(std::ostream &out) {
    out << row({{"frames [1/s]", 14}, {"2 px a frame", 15}, {"by dt, rounded", 16}, {"by dt [px]", 0}});
    for (const int frames : {10, 30, 60, 144, 1000})
        out << row({{std::to_string(frames), 14},
                    {std::to_string(2 * frames), 15},
                    {text(after_a_second(frames, [](double x) { return std::round(x); })), 16},
                    {text(after_a_second(frames, [](double x) { return x; })), 0}});
}

//> A jump, frame by frame
/// How high a jump gets on a screen of so many frames a second, with one step a frame: the velocity first, or the place first.
double jumped(int frames, bool velocity_first) {
    double height = 0, climb = jump_speed, highest = 0;
    while (height >= 0) {
        if (velocity_first) climb += gravity / frames;
        height += climb / frames;
        if (!velocity_first) climb += gravity / frames;
        highest = std::max(highest, height);
    }
    return highest;
}

/// How high the game's runner gets, in steps, on a screen of so many frames a second.
double jumped_in_steps(int frames) {
    Lane lane;
    for (int i = 0; i < frames; ++i) lane = next_frame(lane, 1.0 / frames, lane.runner.place.x() == 0);
    return lane.highest;
}

void print_jumps(std::ostream &out) {
    out << row({{"frames [1/s]", 14}, {"place first [m]", 17}, {"velocity first [m]", 20}, {"in steps [m]", 0}});
    for (const int frames : {10, 30, 60, 144})
        out << row({{std::to_string(frames), 14},
                    {text(jumped(frames, false)), 17},
                    {text(jumped(frames, true)), 20},
                    {text(jumped_in_steps(frames)), 0}});
}

//> Damping
void print_damping(std::ostream &out) {
    out << row({{"frames [1/s]", 14}, {"times 0.99 a frame", 20}, {"by half-life", 0}});
    const double half_life = std::log(0.5) / (60 * std::log(0.99)); // at 60 frames a second, both are the same
    for (const int frames : {30, 60, 144}) {
        Vec2 left{1, 0};
        for (int i = 0; i < frames; ++i) left = follow(left, {0, 0}, half_life, 1.0 / frames);
        out << row({{std::to_string(frames), 14}, {text(std::pow(0.99, frames)), 20}, {text(left.x()), 0}});
    }
}

//> Laps
constexpr double track = 800, cruise = 50; ///< [px], [px/s]

/// How long a lap takes in a game whose frames take so long [s]: with the rest and the moment kept, or both thrown away.
double lap_time(double frame, bool kept) {
    Racer racer{{0, cruise}};
    for (int i = 1; racer.laps == 0; ++i)
        if (kept) next_frame(racer, track, i * frame, frame);
        else next_frame_without_rest(racer, track, i * frame, frame);
    return racer.lap;
}

void print_laps(std::ostream &out) {
    out << row({{"a frame takes [s]", 19}, {"thrown away [s]", 17}, {"kept [s]", 0}});
    for (const double frame : {0.01, 0.1, 0.3, 0.7})
        out << row({{text(frame), 19}, {text(lap_time(frame, false)), 17}, {text(lap_time(frame, true)), 0}});
}

//> Under load
/// The machine's work in each of so many frames of 1/60 s, or longer if the machine needs longer, when a step is due 120
/// times a second and costs so much [s]. All steps that are due run; or only what fits into a frame.
std::vector<double> works(double cost, bool all) {
    std::vector<double> work;
    Machine machine{{0, 0, {{120, cost, 0}}, {}}};
    for (int i = 0; i < 30; ++i) {
        next_frame(machine, all ? 1 : 1.0 / 60);
        work.push_back(machine.work);
    }
    return work;
}

void print_load(std::ostream &out) {
    out << row({{"a step costs [ms]", 19}, {"work in frame 1, 2, 3, 10 [ms]", 34}, {"with a budget [ms]", 0}});
    for (const double cost : {0.004, 0.008, 0.012}) {
        std::string spiral;
        const std::vector<double> all = works(cost, true);
        for (const std::size_t i : {1u, 2u, 3u, 10u}) spiral += text(1000 * all[i - 1]) + "  ";
        out << row({{text(1000 * cost), 19}, {spiral, 34}, {text(1000 * works(cost, false).back()), 0}});
    }
}

//> Three screens, traced
void trace_screens(std::ostream &out) {
    out << "# screen[1/s]\tt[s]\tx by dt[px]\tx by frame[px]\n";
    for (const int frames : {10, 30, 144}) {
        Ship ship{0, 120};
        for (int i = 0; i <= frames / 2; ++i) {
            out << frames << '\t' << double(i) / frames << '\t' << ship.x << '\t' << 2 * i << '\n';
            ship = fly(ship, 1.0 / frames);
        }
        out << "\n\n";
    }
}

//> A tab that sleeps, traced
void trace_sleep(std::ostream &out) {
    out << "# t[s]\traw difference[px]\tby tick[px]\n";
    Tab tab{{}, {0, 120}, {0, 120}};
    for (int i = 0; i <= 60; ++i) {
        const double now = i / 30.0 + (i > 20 ? 2 : 0); // from frame 20 to frame 21, it sleeps
        tab = next_frame(tab, now);
        out << now << '\t' << tab.raw.x << '\t' << tab.ship.x << '\n';
    }
}

//> Jumps, traced
void trace_jumps(std::ostream &out) {
    out << "# screen[1/s]\tt[s]\tone step a frame[m]\tin steps[m]\n";
    for (const int frames : {10, 30, 144}) {
        Runner runner;
        Lane lane;
        for (int i = 0; i <= frames * 8 / 10; ++i) {
            out << frames << '\t' << double(i) / frames << '\t' << runner.place.y() << '\t' << lane.runner.place.y()
                << '\n';
            runner = step(runner, i == 0, 1.0 / frames);
            lane = next_frame(lane, 1.0 / frames, lane.runner.place.x() == 0);
        }
        out << "\n\n";
    }
}

//> Looking back and ahead, traced
void trace_ahead(std::ostream &out) {
    out << "# t[s]\tlast step[m]\tlooking back[m]\tlooking ahead[m]\n";
    Game game;
    for (int i = 0; i <= 120; ++i) { // at 144 frames a second
        game = next_frame(game, i / 144.0, i == 1);
        const Vec2 on = game.now.place - game.before.place;
        const double ahead = game.now.place.y() + game.spare / step_time * on.y();
        out << i / 144.0 << '\t' << game.now.place.y() << '\t' << game.shown.y() << '\t' << ahead << '\n';
    }
}

//> Cameras, traced
void trace_cameras(std::ostream &out) {
    out << "# screen[1/s]\tt[s]\ta tenth a frame[m]\tby half-life[m]\n";
    for (const int frames : {30, 144}) {
        Cameras cameras{{10, 0}, {10, 0}};
        for (int i = 0; i <= frames; ++i) {
            out << frames << '\t' << double(i) / frames << '\t' << cameras.tenth.x() << '\t' << cameras.ours.x()
                << '\n';
            cameras = next_frame(cameras, {0, 0}, 0.1, 1.0 / frames);
        }
        out << "\n\n";
    }
}

//> Laps, traced
void trace_laps(std::ostream &out) {
    out << "# a frame[s]\tthrown away[s]\tkept[s]\n";
    for (int ms = 10; ms <= 700; ms += 2)
        out << ms / 1000.0 << '\t' << lap_time(ms / 1000.0, false) << '\t' << lap_time(ms / 1000.0, true) << '\n';
}

//> The spiral, traced
void trace_spiral(std::ostream &out) {
    out << "# frame[1]\tall that's due[ms]\twith a budget[ms]\n";
    const std::vector<double> all = works(0.012, true), fits = works(0.012, false);
    for (std::size_t i = 0; i < 12; ++i) out << i + 1 << '\t' << 1000 * all[i] << '\t' << 1000 * fits[i] << '\n';
}

//> A friend's ship, traced
/// A packet 20 times a second from a ship on a curve; three of them are lost.
std::vector<Packet> sent_until(double time) {
    std::vector<Packet> packets;
    for (int i = 0; i <= 20; ++i)
        if ((i < 9 || i > 11) && i / 20.0 <= time) packets.push_back({i / 20.0, {5 * i / 20.0, 2 * std::sin(0.3 * i)}});
    return packets;
}

void trace_friend(std::ostream &out) {
    out << "# kind[1]\tx[m]\ty[m]\n"; // 0: packets, 1: seen
    for (const Packet &each : sent_until(1)) out << "0\t" << each.place.x() << '\t' << each.place.y() << '\n';
    out << "\n\n";
    for (int i = 6; i <= 66; ++i) {
        const Vec2 at = seen_at(sent_until(i / 60.0), i / 60.0);
        out << "1\t" << at.x() << '\t' << at.y() << '\n';
    }
}

//> Main
int main(int argc, char **argv) {
    return course::run(argc, argv,
                       {{"screens", print_screens},
                        {"jumps", print_jumps},
                        {"damping", print_damping},
                        {"laps", print_laps},
                        {"load", print_load},
                        {"12_time_based_motion_screens.tsv", trace_screens},
                        {"12_time_based_motion_sleep.tsv", trace_sleep},
                        {"12_time_based_motion_jumps.tsv", trace_jumps},
                        {"12_time_based_motion_ahead.tsv", trace_ahead},
                        {"12_time_based_motion_cameras.tsv", trace_cameras},
                        {"12_time_based_motion_laps.tsv", trace_laps},
                        {"12_time_based_motion_spiral.tsv", trace_spiral},
                        {"12_time_based_motion_friend.tsv", trace_friend}});
}
