#include "../program.hpp"

#include "game.hpp"

#include <map>

using namespace table_hockey;
using course::row, course::text;

//> Two shots
/// Both mallets rest, and somebody on the left has just hit the disc, this many degrees upwards.
World after_a_shot(double angle) {
    World now = opening();
    now.disc = {{-0.8, -0.3}, trajectories::launch_velocity(4, angle)};
    return now;
}

bool is_over(const World &now) { return now.left.goals + now.right.goals > 0 || now.disc.velocity.isZero(0); }

/// A turn is when the disc's velocity changes by more than the felt can change it.
void print_shots(std::ostream &out) {
    out << row({{"shot [°]", 12}, {"turns", 9}, {"time [s]", 12}, {"goals", 0}});
    for (const double angle : {20, 25, 35}) {
        World now = after_a_shot(angle);
        int turns = 0, steps = 0;
        for (; !is_over(now); ++steps) {
            const Disc before = now.disc;
            now = step(now, {}, step_time);
            if (is_over(now)) continue;
            turns += (now.disc.velocity - before.velocity).norm() > 2 * felt * step_time;
        }
        out << row({{text(angle), 12},
                    {std::to_string(turns), 9},
                    {text(std::round(steps * step_time * 100) / 100), 12},
                    {std::to_string(now.left.goals) + " : " + std::to_string(now.right.goals), 0}});
    }
}

/// Where the disc is after each step, until it's in a goal.
void trace_shots(std::ostream &out) {
    out << "# t[s]\tx[m]\ty[m]\n";
    for (const double angle : {20, 25}) {
        World now = after_a_shot(angle);
        for (int i = 0; !is_over(now); ++i, now = step(now, {}, step_time))
            out << i * step_time << '\t' << now.disc.place.x() << '\t' << now.disc.place.y() << '\n';
        out << "\n\n";
    }
}

//> A hundred matches
/// A hundred matches of the beginner against the machine: how many goals it was ahead, and how often. They take seconds, so
/// they're played once.
std::map<int, int> leads(Level level) {
    static std::map<Level, std::map<int, int>> played;
    std::map<int, int> &matches = played[level];
    if (!matches.empty()) return matches;
    for (unsigned seed = 0; seed < 100; ++seed) {
        const Goals goals = play_match(seed, level);
        ++matches[goals.left - goals.right];
    }
    return matches;
}

void print_matches(std::ostream &out) {
    out << row({{"machine", 12}, {"won", 8}, {"drawn", 8}, {"lost", 0}});
    for (const auto &[level, name] : {std::pair{Level::easy, "easy"}, {Level::difficult, "hard"}}) {
        int won = 0, drawn = 0, lost = 0;
        for (const auto &[lead, count] : leads(level)) (lead > 0 ? won : lead == 0 ? drawn : lost) += count;
        out << row({{name, 12}, {std::to_string(won), 8}, {std::to_string(drawn), 8}, {std::to_string(lost), 0}});
    }
}

void trace_matches(std::ostream &out) {
    out << "# goals_ahead[1]\teasy[1]\thard[1]\n";
    std::map<int, int> against_easy = leads(Level::easy), against_hard = leads(Level::difficult);
    for (int lead = -goals_to_win; lead <= goals_to_win; ++lead)
        out << lead << '\t' << against_easy[lead] << '\t' << against_hard[lead] << '\n';
}

//> The parts
int main(int argc, char **argv) {
    return course::run(argc, argv,
                       {{"shots", print_shots},
                        {"matches", print_matches},
                        {"13_table_hockey_shots.tsv", trace_shots},
                        {"13_table_hockey_matches.tsv", trace_matches}});
}
