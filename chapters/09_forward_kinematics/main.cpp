#include "../program.hpp"

#include "game.hpp"

using namespace forward_kinematics;
using course::row, course::text;

//> Five arms
std::string degrees(double angle) { return text(angle / degree); }

void print_arms(std::ostream &out) {
    out << row({{"lengths [m]", 13}, {"angles [°]", 14}, {"elbow [m]", 22}, {"hand [m]", 0}});
    for (const auto &[first, second] : {std::pair{Link{3, 30 * degree}, Link{2, 45 * degree}},
                                        {Link{3, 45 * degree}, Link{5, 90 * degree}},
                                        {Link{3, 0}, Link{5, 0}},
                                        {Link{3, 90 * degree}, Link{5, -90 * degree}},
                                        {Link{3, 30 * degree}, Link{5, 60 * degree}}}) {
        const auto [elbow, hand] = two_links(first, second);
        out << row({{text(first.length) + " and " + text(second.length), 13},
                    {degrees(first.angle) + " and " + degrees(second.angle), 14},
                    {text(elbow), 22},
                    {text(hand), 0}});
    }
}

//> Frames in frames
void print_frames(std::ostream &out) {
    out << row({{"frame", 18}, {"x axis", 14}, {"y axis", 14}, {"origin [m]", 0}});
    const Frame outer{{0.8, 0.6}, {-0.6, 0.8}, {3, 1}}, inner{{0, 1}, {-1, 0}, {2, 1}};
    for (const auto &[name, frame] : {std::pair{"torso", outer},
                                      {"arm in torso", inner},
                                      {"arm in the world", compose(outer, inner)},
                                      {"the other way", compose(inner, outer)}})
        out << row({{name, 18}, {text(frame.x_axis), 14}, {text(frame.y_axis), 14}, {text(frame.origin), 0}});
}

//> An arm of three links
void print_joints(std::ostream &out) {
    const std::vector<Link> links(3, {2, 30 * degree});
    for (const Vec2 &joint : joints({1, 0}, links)) out << text(joint) << '\n';
}

//> From folded to straight
double area(const Vec2 &a, const Vec2 &b) { return a.x() * b.y() - a.y() * b.x(); }

void print_jacobians(std::ostream &out) {
    out << row({{"elbow [°]", 11}, {"first joint [m/rad]", 23}, {"elbow [m/rad]", 23}, {"area [m²]", 0}});
    for (const double bent : {90.0, 60.0, 30.0, 0.0}) {
        const std::vector<Vec2> columns = jacobian({{3, 45 * degree}, {5, bent * degree}});
        out << row({{text(bent), 11},
                    {text(columns[0]), 23},
                    {text(columns[1]), 23},
                    {text(area(columns[0], columns[1])), 0}});
    }
}

//> Seen from a frame
void print_views(std::ostream &out) {
    out << row({{"in the world [m]", 18}, {"as the frame sees it [m]", 26}, {"and back [m]", 0}});
    const Frame frame{{0.8, 0.6}, {-0.6, 0.8}, {3, 1}};
    for (const Vec2 &point : {Vec2{4, 3}, Vec2{3, 1}, Vec2{0, 0}, Vec2{3.8, 1.6}}) {
        const Vec2 local = to_local(frame, point);
        out << row({{text(point), 18}, {text(local), 26}, {text(in_world(frame, local)), 0}});
    }
}

//> How far an arm can turn
void print_turns(std::ostream &out) {
    out << row({{"joint", 7}, {"by [°]", 8}, {"it turns by [°]", 17}, {"lowest then [m]", 0}});
    const Vec2 base{0, 1};
    for (const auto &[joint, by] : {std::pair{0, -30.0}, {0, -90.0}, {1, -120.0}, {2, -90.0}, {0, 360.0}}) {
        std::vector<Link> links{{2, 60 * degree}, {2, -50 * degree}, {1, 30 * degree}};
        const double turn = turn_above_ground(base, links, joint, by * degree);
        links[std::size_t(joint)].angle += turn;
        double lowest = base.y();
        for (const Vec2 &each : joints(base, links)) lowest = std::min(lowest, each.y());
        out << row({{text(joint), 7}, {text(by), 8}, {degrees(turn), 17}, {text(lowest), 0}});
    }
}

//> The opening's arm, traced
void trace_arm(std::ostream &out) {
    out << "# x[m]\ty[m]\n0\t0\n";
    const auto [elbow, hand] = two_links({3, 30 * degree}, {2, 45 * degree});
    for (const Vec2 &at : {elbow, hand}) out << at.x() << '\t' << at.y() << '\n';
}

//> What the hand draws, traced
void trace_drawing(std::ostream &out) {
    out << "# x[m]\ty[m]\n";
    Arm arm{{3, 0}, {2, 0}, {}};
    for (int i = 0; i <= 360; ++i) next_frame(arm, 1, 4, degree);
    for (const Vec2 &at : arm.trail) out << at.x() << '\t' << at.y() << '\n';
}

//> A torso and an arm, traced
void trace_torso(std::ostream &out) {
    out << "# from: x[m]\ty[m]\tarrow: x[m]\ty[m]\n";
    const Frame torso{{0.8, 0.6}, {-0.6, 0.8}, {3, 1}}, arm = compose(torso, {{0, 1}, {-1, 0}, {2, 1}});
    for (const Frame &frame : {Frame{}, torso, arm})
        for (const Vec2 &axis : {frame.x_axis, frame.y_axis})
            out << frame.origin.x() << '\t' << frame.origin.y() << '\t' << axis.x() << '\t' << axis.y() << '\n';
}

//> From another base, traced
void trace_base(std::ostream &out) {
    out << "# x[m]\ty[m]\tas printed: x[m]\ty[m]\n";
    const Link first{3, 45 * degree}, second{5, 90 * degree};
    const Vec2 base{10, 0};
    const std::vector<Vec2> all = joints(base, {first, second});
    // as printed, the base is where our hand is: the joints turn it
    const Vec2 printed[]{base, in_world(end_of(first), base), in_world(compose(end_of(first), end_of(second)), base)};
    for (std::size_t i = 0; i < all.size(); ++i)
        out << all[i].x() << '\t' << all[i].y() << '\t' << printed[i].x() << '\t' << printed[i].y() << '\n';
}

//> A tentacle, traced
void trace_tentacle(std::ostream &out) {
    out << "# x[m]\ty[m]\tmoment[1]\n";
    for (int moment = 0; moment < 4; ++moment) {
        for (const Vec2 &at : joints({4.5 * moment, 0}, tentacle(20, 4, 0.15, 0.25, 0.5 * moment)))
            out << at.x() << '\t' << at.y() << '\t' << moment << '\n';
        out << '\n';
    }
}

//> How the hand moves, traced
void trace_arrows(std::ostream &out) {
    out << "# x[m]\ty[m]\tfirst joint: x[m/s]\ty[m/s]\telbow: x[m/s]\ty[m/s]\n";
    for (const double bent : {90.0, 0.0}) {
        const std::vector<Link> links{{3, 45 * degree}, {2, bent * degree}};
        const std::vector<Vec2> all = joints({0, 0}, links), columns = jacobian(links);
        for (const Vec2 &at : all) {
            out << at.x() << '\t' << at.y();
            for (const Vec2 &column : columns) out << '\t' << column.x() << '\t' << column.y();
            out << '\n';
        }
        out << "\n\n";
    }
}

//> The area of the two arrows, traced
void trace_area(std::ostream &out) {
    out << "# elbow[deg]\tarea[m^2]\n";
    for (int bent = -180; bent <= 180; bent += 5) {
        const std::vector<Vec2> columns = jacobian({{3, 45 * degree}, {5, bent * degree}});
        out << bent << '\t' << area(columns[0], columns[1]) << '\n';
    }
}

//> A box that is carried, traced
void trace_carried(std::ostream &out) {
    out << "# kind[1]\tx[m]\ty[m]\n"; // 0: the arm, 1: the box; an empty line after each
    std::vector<Link> links{{3, 100 * degree}, {3, -80 * degree}};
    const Vec2 base{0, 0};
    Box box{{{1, 0}, {0, 1}, {3.0, 3.6}}, {}, false};
    box.place.origin = hand_of(base, links).origin + Vec2{0.45, 0.1};
    take(box, hand_of(base, links));
    for (int moment = 0; moment < 3; ++moment) {
        for (const Vec2 &at : joints(base, links)) out << "0\t" << at.x() << '\t' << at.y() << '\n';
        out << '\n';
        next_frame(box, hand_of(base, links));
        for (const Vec2 &corner :
             {Vec2{-0.4, -0.4}, Vec2{0.4, -0.4}, Vec2{0.4, 0.4}, Vec2{-0.4, 0.4}, Vec2{-0.4, -0.4}}) {
            const Vec2 at = in_world(box.place, corner);
            out << "1\t" << at.x() << '\t' << at.y() << '\n';
        }
        out << '\n';
        links[0].angle -= 25 * degree;
        links[1].angle -= 20 * degree;
    }
}

//> An arm above the ground, traced
void trace_ground(std::ostream &out) {
    out << "# x[m]\ty[m]\tturned: x[m]\ty[m]\n";
    const Vec2 base{0, 1};
    const std::vector<Link> links{{2, 60 * degree}, {2, -50 * degree}, {1, 30 * degree}};
    std::vector<Link> turned = links;
    turned[1].angle += turn_above_ground(base, links, 1, -120 * degree);
    const std::vector<Vec2> before = joints(base, links), after = joints(base, turned);
    for (std::size_t i = 0; i < before.size(); ++i)
        out << before[i].x() << '\t' << before[i].y() << '\t' << after[i].x() << '\t' << after[i].y() << '\n';
}

//> Main
int main(int argc, char **argv) {
    return course::run(argc, argv,
                       {{"arms", print_arms},
                        {"frames", print_frames},
                        {"joints", print_joints},
                        {"jacobians", print_jacobians},
                        {"views", print_views},
                        {"turns", print_turns},
                        {"09_forward_kinematics_arm.tsv", trace_arm},
                        {"09_forward_kinematics_drawing.tsv", trace_drawing},
                        {"09_forward_kinematics_torso.tsv", trace_torso},
                        {"09_forward_kinematics_base.tsv", trace_base},
                        {"09_forward_kinematics_tentacle.tsv", trace_tentacle},
                        {"09_forward_kinematics_arrows.tsv", trace_arrows},
                        {"09_forward_kinematics_area.tsv", trace_area},
                        {"09_forward_kinematics_carried.tsv", trace_carried},
                        {"09_forward_kinematics_ground.tsv", trace_ground}});
}
