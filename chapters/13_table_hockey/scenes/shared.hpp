#pragma once
// A match, and how a reader takes part in it: what the scenes of this chapter share.
#include "../../scene.hpp"
#include "table.hpp"

namespace play {
using demo::View;

constexpr double patience = 10;  ///< so long it waits for a player who went away [s]
constexpr double break_time = 4; ///< after a match [s]

/// Where a player sits: four keys, and a mallet to drag. Whichever moved last leads.
struct Seat {
    HeldKey up, left, down, right;
    Handle wanted;           ///< where the mallet is to go
    bool by_pointer = false; ///< or else by keys
    bool moved = false;      ///< since the last step
    Vec2 before{0, 0};       ///< where `wanted` was after that

    void point(const Vec2 &at) {
        wanted.move(at);
        before = wanted.at();
        by_pointer = moved = true;
    }
    /// One of the scene's handles was dragged: was it this one?
    void drag() {
        if (wanted.at() != before) point(wanted.at());
    }
    Vec2 direction() const { return {double(right - left), double(up - down)}; }
    /// Whether the reader did something here since this was asked last.
    bool is_led() {
        const bool keys = !direction().isZero(0), led = moved || keys;
        if (keys) by_pointer = false;
        moved = false;
        return led;
    }
    Vec2 hand(const Player &player) const { return by_pointer ? wanted.at() : led(player, direction()); }
    void follow(const Player &player) {
        if (!by_pointer) wanted.move(player.mallet);
        before = wanted.at();
    }
};

struct Match : Scene {
    Choice well = choice("The well", {"off", "on"});
    Button again = button("n", "New game", [this] { start(); });
    World world;
    unsigned matches = 0;   ///< that were begun
    double time = 0;        ///< since this one began [s]
    double over = 0;        ///< how long it has been won [s]
    double idle = patience; ///< since the reader did something [s]
    double lamps[2]{};      ///< of the left goal and the right one: 1 when it's scored, then fading
    std::vector<Vec2> way;  ///< of the disc, lately

    Match() {
        still_time = 3;
        handles_below = true;
    }

    /// Where each player's hand goes.
    virtual Vec2 left_hand() const = 0;
    virtual Vec2 right_hand() const = 0;
    /// What tells a reader how to take part.
    virtual std::string hint() const { return ""; }

    View view() const override { return {{-1.28, -0.78}, {1.28, 0.84}, Stage::felt}; }
    void begin() override { start(); }
    void start() {
        world = opening();
        time = over = lamps[0] = lamps[1] = 0;
        way.clear();
        ++matches;
    }

    Seat blue_seat() {
        return {held("blue up", "w"), held("blue left", "a"), held("blue down", "s"), held("blue right", "d"),
                handle({-0.5, 0}, in_own_half({-1, -1}), in_own_half({0, 1}), Colour::blue)};
    }
    Seat orange_seat() {
        return {held("orange up", "ArrowUp"), held("orange left", "ArrowLeft"), held("orange down", "ArrowDown"),
                held("orange right", "ArrowRight"),
                handle({0.5, 0}, seen_from(1, in_own_half({0, -1})), seen_from(1, in_own_half({-1, 1})))};
    }
    bool is_played() const { return idle < patience; }
    /// Whoever comes begins a match, and whoever leaves goes on with it for a while.
    /// @param led   whether the reader leads a mallet now
    /// @param here  whether a pointer is there, though it rests
    void look_who_plays(bool led, bool here, double dt) {
        const bool was_played = is_played();
        idle = led || (here && was_played) ? 0 : idle + dt;
        if (is_played() && !was_played) start();
    }

    void step(double dt) override {
        if (is_won(world)) {
            over += dt;
            lamps[world.left.goals > world.right.goals] = 0.5 + 0.5 * std::cos(8 * over); // where the loser let it in
            if (over > break_time && !is_played()) start();
            return;
        }
        const int left = world.left.goals, right = world.right.goals;
        world = table_hockey::step(world, {left_hand(), right_hand(), well == 1}, dt);
        round_off(world);
        time += dt;
        lamps[0] = world.right.goals != right ? 1 : std::max(0.0, lamps[0] - dt);
        lamps[1] = world.left.goals != left ? 1 : std::max(0.0, lamps[1] - dt);
        way.push_back(world.disc.place);
        if (lamps[0] == 1 || lamps[1] == 1) way.clear();
        if (way.size() > 7) way.erase(way.begin());
    }

    void draw(Canvas &canvas) const override {
        draw_table(canvas, well == 1);
        draw_goal(canvas, -1, lamps[0]);
        draw_goal(canvas, 1, lamps[1]);
        draw_mallet(canvas, world.left, Colour::blue);
        draw_mallet(canvas, world.right, Colour::orange);
        if (way.size() > 1) canvas.trail(way, Colour::amber, 9).strength = 0.6;
        canvas.ball(world.disc.place, disc_radius, Colour::amber);
        draw_sparks(canvas, world.sparks);
        draw_arm(canvas, world.left, Colour::blue);
        draw_arm(canvas, world.right, Colour::orange);
        draw_score(canvas, -0.16, world.left.goals, Colour::blue);
        draw_score(canvas, 0.16, world.right.goals, Colour::orange);
        const bool blue = world.left.goals > world.right.goals;
        if (is_won(world))
            canvas.plate({0, 0.22}, blue ? "blue wins" : "orange wins", blue ? Colour::blue : Colour::orange, 44);
        else if (!is_played() && !hint().empty()) canvas.text({0, -0.72}, hint(), Colour::ink, 22, Anchor::middle);
    }
};
} // namespace play
