#include "../program.hpp"

#include "game.hpp"

#include <algorithm>
#include <numbers>

using namespace inverse_kinematics;
using course::row, course::text;
using forward_kinematics::joints;

//> Which angles?
double in_degrees(double angle) { return angle * 180 / std::numbers::pi; }
std::string degrees(double angle) { return text(in_degrees(angle)); }
double radians(double angle) { return angle / 180 * std::numbers::pi; }

std::string lengths(const Arm &arm) { return text(arm.first) + " and " + text(arm.second); }

void print_poses(std::ostream &out) {
    out << row({{"lengths [m]", 13}, {"target [m]", 14}, {"first [°]", 11}, {"second [°]", 0}});
    for (const auto &[arm, target] : {std::pair{Arm{3, 2}, Vec2{3, 2}},
                                      {Arm{3, 2}, {4, 1}},
                                      {Arm{3, 2}, {3, 4}},
                                      {Arm{3, 2}, {1, 0}},
                                      {Arm{3, 2}, {5, 1}},
                                      {Arm{2, 2}, {0, 0}}}) {
        const std::vector<Pose> all = poses(arm, target);
        if (all.empty()) out << row({{lengths(arm), 13}, {text(target), 14}, {"none", 0}});
        for (const Pose &pose : all)
            out << row({{lengths(arm), 13}, {text(target), 14}, {degrees(pose.first), 11}, {degrees(pose.second), 0}});
    }
}

//> As near as it gets
void print_nearest(std::ostream &out) {
    out << row({{"target [m]", 14}, {"nearest [m]", 24}, {"away [m]", 0}});
    for (const Vec2 &target : {Vec2{3, 2}, Vec2{6, 8}, Vec2{0.3, 0.4}, Vec2{0, 0}, Vec2{-4, 4}}) {
        const Vec2 nearest = nearest_reachable({3, 2}, target);
        out << row({{text(target), 14}, {text(nearest), 24}, {text((target - nearest).norm()), 0}});
    }
}

//> Two apples
Vec2 hand_of(const Arm &arm, const Pose &pose) {
    return joints({0, 0}, {{arm.first, pose.first}, {arm.second, pose.second}}).back();
}

/// A player who waits below the first apple until it's caught, and then goes for the second one.
Vec2 pointer_of(const Orchard &now) { return now.caught == 0 ? Vec2{3, 1} : Vec2{-3, 0}; }
Orchard two_apples() { return {poses(picker, {4, 0}).front(), {{{3, 4}, 0}, {{-3, 9}, 0}}, 0, 0}; }

void print_apples(std::ostream &out) {
    out << row({{"time [s]", 10}, {"hand [m]", 24}, {"in the air", 12}, {"caught", 8}, {"missed", 0}});
    Orchard now = two_apples();
    for (int frame = 0; frame <= 105; ++frame) {
        if (frame % 15 == 0)
            out << row({{text(frame / 60.0), 10},
                        {text(hand_of(picker, now.pose)), 24},
                        {text(double(now.apples.size())), 12},
                        {text(now.caught), 8},
                        {text(now.missed), 0}});
        now = next_frame(now, pointer_of(now), 1.0 / 60);
    }
}

//> Led around
/// A place on a circle about the first joint.
Vec2 on_circle(double angle) { return {3 * std::cos(radians(angle)), 3 * std::sin(radians(angle))}; }

void print_led(std::ostream &out) {
    out << row({{"led to [°]", 12}, {"the first of both [°]", 24}, {"goes on [°]", 0}});
    Pose pose = poses({3, 2}, on_circle(0)).front();
    for (int angle = 0; angle <= 360; angle += 30) {
        const Pose first = poses({3, 2}, on_circle(angle)).front();
        pose = continued({3, 2}, pose, on_circle(angle));
        if (angle % 60 == 0)
            out << row({{text(angle), 12},
                        {degrees(first.first) + ", " + degrees(first.second), 24},
                        {degrees(pose.first) + ", " + degrees(pose.second), 0}});
    }
}

//> Two links, sweep by sweep
void print_sweeps(std::ostream &out) {
    const Vec2 target{0, 1};
    std::vector<Link> links{{1, 0}, {1, 0}};
    out << row({{"sweeps", 9}, {"hand [m]", 23}, {"off by [m]", 0}});
    for (int sweeps = 0; sweeps <= 3; ++sweeps) {
        const Vec2 hand = joints({0, 0}, links).back();
        out << row({{text(double(sweeps)), 9}, {text(hand), 23}, {text((hand - target).norm()), 0}});
        links = ccd_sweep({0, 0}, links, target);
    }
}

//> Sweeps and steps
const Vec2 high{0, 20};                                      // a base without a ground to fear [m]
const std::vector<Link> bent(4, Link{1, radians(20)});       // four links of 1 m
const std::vector<Limits> no_limits(4, Limits{-1000, 1000}); // [rad]
constexpr double damping = 0.3;                              // [m]

double error_of(const std::vector<Link> &links, const Vec2 &target) {
    return (joints(high, links).back() - high - target).norm();
}
/// How far the hand is off at first, and after each of so many steps [m].
template <class Step> std::vector<double> errors(const Vec2 &target, int steps, Step step) {
    std::vector<Link> links = bent;
    std::vector<double> all{error_of(links, target)};
    for (int i = 0; i < steps; ++i) {
        links = step(links);
        all.push_back(error_of(links, target));
    }
    return all;
}
std::vector<double> sweep_errors(const Vec2 &target, int steps) {
    return errors(target, steps, [&](const std::vector<Link> &links) { return ccd_sweep(high, links, high + target); });
}
std::vector<double> step_errors(const Vec2 &target, int steps) {
    return errors(target, steps, [&](const std::vector<Link> &links) {
        return damped_step(high, links, no_limits, high + target, damping);
    });
}

/// How often it takes until the hand is within 1 mm, or "more".
std::string count_until_there(const std::vector<double> &errors) {
    for (std::size_t i = 0; i < errors.size(); ++i)
        if (errors[i] <= 1e-3) return text(double(i));
    return "more";
}
void print_errors(std::ostream &out) {
    out << row({{"target [m]", 14}, {"sweeps to 1 mm", 16}, {"damped steps to 1 mm", 0}});
    for (const Vec2 &target : {Vec2{2, 1}, Vec2{1, 2}, Vec2{3.9, 0}, Vec2{3.99, 0}})
        out << row({{text(target), 14},
                    {count_until_there(sweep_errors(target, 1000)), 16},
                    {count_until_there(step_errors(target, 1000)), 0}});
}

//> Stretched
/// How far the elbow of 3 m and 2 m turns in one step, when the hand should come 0.5 m nearer to the first joint.
double elbow_turn(double bend, double of_damping) {
    const std::vector<Link> links{{3, 0}, {2, radians(bend)}};
    const Vec2 hand = joints(high, links).back() - high;
    const std::vector<Link> after =
        damped_step(high, links, {{-1e5, 1e5}, {-1e5, 1e5}}, high + hand - 0.5 * hand.normalized(), of_damping);
    return std::abs(after[1].angle - links[1].angle);
}
void print_stretched(std::ostream &out) {
    out << row({{"elbow [°]", 11}, {"hardly damped [°]", 19}, {"damped by 0.5 m [°]", 0}});
    for (const double bend : {60.0, 20.0, 5.0, 1.0, 0.1, 0.0})
        out << row({{text(bend), 11}, {degrees(elbow_turn(bend, 1e-4)), 19}, {degrees(elbow_turn(bend, 0.5)), 0}});
}

//> A letter
const std::vector<Vec2> letter_f{{1.5, 0.5}, {1.5, 3}, {3, 3}, {1.5, 3}, {1.5, 1.8}, {2.6, 1.8}}; // [m]

std::vector<Pose> written() { return write({3, 2}, poses({3, 2}, letter_f.front()).front(), letter_f); }

void print_letter(std::ostream &out) {
    const std::vector<Pose> all = written();
    double turn = 0;
    for (std::size_t i = 1; i < all.size(); ++i)
        turn = std::max({turn, std::abs(all[i].first - all[i - 1].first), std::abs(all[i].second - all[i - 1].second)});
    out << "poses: " << all.size() << ", largest turn from one to the next: " << degrees(turn) << "°\n";
    out << "from " << text(hand_of({3, 2}, all.front())) << " to " << text(hand_of({3, 2}, all.back())) << '\n';
}

//> Arms, traced
void trace_joints(std::ostream &out, const std::vector<Vec2> &all) {
    for (const Vec2 &at : all) out << at.x() << '\t' << at.y() << '\n';
    out << '\n';
}
void trace_arm(std::ostream &out, const Arm &arm, const Pose &pose) {
    trace_joints(out, joints({0, 0}, {{arm.first, pose.first}, {arm.second, pose.second}}));
}

//> Both poses of the opening's arm, traced
void trace_both(std::ostream &out) {
    out << "# x[m]\ty[m]\n";
    for (const Pose &pose : poses({3, 2}, {3, 2})) trace_arm(out, {3, 2}, pose);
}

//> Both elbows for many targets, traced
void trace_grid(std::ostream &out) {
    out << "# kind[1]\tx[m]\ty[m]\n"; // 0: a target, 1: the left elbow's arm, 2: the right one's; each in its cell
    for (int column = -2; column <= 2; ++column)
        for (int row = -1; row <= 1; ++row) {
            const Vec2 target{2.0 * column, 1.5 * row + 1.5}, cell{8.2 * column, 6.2 * row};
            out << "0\t" << cell.x() + target.x() << '\t' << cell.y() + target.y() << "\n\n";
            int kind = 1;
            for (const Pose &pose : poses({3, 2}, target)) {
                for (const Vec2 &at : joints(cell, {{3, pose.first}, {2, pose.second}}))
                    out << kind << '\t' << at.x() << '\t' << at.y() << '\n';
                out << '\n';
                ++kind;
            }
        }
}

//> How far it bends, traced
void trace_bend(std::ostream &out) {
    out << "# distance[m]\tsecond angle[deg]\n";
    for (int step = 0; step <= 80; ++step) {
        const double distance = 3 - 2 * std::cos(radians(180.0 * step / 80)); // closer together where it's steep
        out << distance << '\t' << in_degrees(poses({3, 2}, {distance, 0}).front().second) << '\n';
    }
}

//> From out of reach, traced
void trace_reach(std::ostream &out) {
    out << "# x[m]\ty[m]\tto the nearest: x[m]\ty[m]\n";
    for (const Vec2 &target :
         {Vec2{6, 4}, Vec2{-6, 2}, Vec2{1, -6.5}, Vec2{-4.5, 4.5}, Vec2{0.3, 0.4}, Vec2{-0.45, -0.2}, Vec2{3, -2}}) {
        const Vec2 way = nearest_reachable({3, 2}, target) - target;
        out << target.x() << '\t' << target.y() << '\t' << way.x() << '\t' << way.y() << '\n';
    }
}

//> Led around, traced
void trace_led(std::ostream &out) {
    out << "# led to[deg]\tthe first of both[deg]\tgoes on[deg]\n";
    Pose pose = poses({3, 2}, on_circle(0)).front();
    for (int angle = 0; angle <= 540; angle += 5) {
        pose = continued({3, 2}, pose, on_circle(angle));
        out << angle << '\t' << in_degrees(poses({3, 2}, on_circle(angle)).front().first) << '\t'
            << in_degrees(pose.first) << '\n';
    }
}

//> A tentacle's sweeps, traced
void trace_sweeps(std::ostream &out) {
    out << "# x[m]\ty[m]\tsweeps[1]\n";
    std::vector<Link> links(12, Link{0.35, radians(3)});
    for (int sweep = 0; sweep <= 3; ++sweep) {
        for (const Vec2 &at : joints({0, 0}, links)) out << at.x() << '\t' << at.y() << '\t' << sweep << '\n';
        out << "\n\n";
        links = ccd_sweep({0, 0}, links, {2, 2.5});
    }
}

//> Errors of sweeps and of steps, traced
void trace_errors(std::ostream &out) {
    out << "# count[1]\tfar: sweeps[m]\tsteps[m]\tnear: sweeps[m]\tsteps[m]\n";
    const auto far_sweeps = sweep_errors({1, 2}, 40), far_steps = step_errors({1, 2}, 40);
    const auto near_sweeps = sweep_errors({3.99, 0}, 40), near_steps = step_errors({3.99, 0}, 40);
    for (std::size_t i = 0; i <= 40; ++i) // below 1e-9 m there's nothing to see but rounding
        out << i << '\t' << std::max(far_sweeps[i], 1e-9) << '\t' << std::max(far_steps[i], 1e-9) << '\t'
            << std::max(near_sweeps[i], 1e-9) << '\t' << std::max(near_steps[i], 1e-9) << '\n';
}

//> Stretched, traced
void trace_stretched(std::ostream &out) {
    out << "# elbow[deg]\thardly damped[deg]\tby 0.1 m[deg]\tby 0.5 m[deg]\n";
    for (int step = 0; step <= 60; ++step) {
        const double bend = std::pow(10, -1 + 3.0 * step / 60) * 0.9;
        out << bend;
        for (const double of_damping : {1e-4, 0.1, 0.5}) out << '\t' << in_degrees(elbow_turn(bend, of_damping));
        out << '\n';
    }
}

//> The drawn letter, traced
void trace_letter(std::ostream &out) {
    out << "# kind[1]\tx[m]\ty[m]\n"; // 0: where the hand has been, 1: the arm, in some of its poses
    const std::vector<Pose> all = written();
    for (const Pose &pose : all) out << "0\t" << hand_of({3, 2}, pose).x() << '\t' << hand_of({3, 2}, pose).y() << '\n';
    for (const std::size_t i : {std::size_t(0), all.size() * 2 / 5, all.size() - 1}) {
        out << '\n';
        for (const Vec2 &at : joints({0, 0}, {{3, all[i].first}, {2, all[i].second}}))
            out << "1\t" << at.x() << '\t' << at.y() << '\n';
    }
}

//> Main
int main(int argc, char **argv) {
    return course::run(argc, argv,
                       {{"poses", print_poses},
                        {"nearest", print_nearest},
                        {"apples", print_apples},
                        {"led", print_led},
                        {"sweeps", print_sweeps},
                        {"errors", print_errors},
                        {"stretched", print_stretched},
                        {"letter", print_letter},
                        {"10_inverse_kinematics_both.tsv", trace_both},
                        {"10_inverse_kinematics_grid.tsv", trace_grid},
                        {"10_inverse_kinematics_bend.tsv", trace_bend},
                        {"10_inverse_kinematics_reach.tsv", trace_reach},
                        {"10_inverse_kinematics_led.tsv", trace_led},
                        {"10_inverse_kinematics_sweeps.tsv", trace_sweeps},
                        {"10_inverse_kinematics_errors.tsv", trace_errors},
                        {"10_inverse_kinematics_stretched.tsv", trace_stretched},
                        {"10_inverse_kinematics_letter.tsv", trace_letter}});
}
