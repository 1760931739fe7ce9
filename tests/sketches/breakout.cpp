// ./course sketch breakout --watch
#include "sketch.hpp"
using namespace demo;

struct Brick {
    Vec2 low, high;
    Colour colour;
    int worth;
};

struct Bit {
    particles::Particle particle;
    Colour colour;
};

struct Breakout : Scene {
    Slider speed = slider("ball speed", "m/s", 4, 14, 0.5, 8);
    HeldKey left = held("left", "ArrowLeft");
    HeldKey right = held("right", "ArrowRight");
    Button again = button("n", "New game", [this] { new_game(); });

    static constexpr double radius = 0.2; // of the ball [m]
    static constexpr double half = 1.2;   // half the paddle [m]
    static constexpr double paddle_y = 0.7;

    std::vector<Brick> bricks;
    std::vector<Bit> bits;
    std::vector<Vec2> tail;
    Vec2 ball{8, 2};
    Vec2 direction{0.5, 0.85};
    Vec2 last_hand{0, 0};
    double paddle = 8;
    double wait = 1; // until the ball is served [s]
    int score = 0, best = 0, lives = 3, level = 1, combo = 0;
    bool over = false, demo_mode = true;

    View view() const override { return {{0, 0}, {16, 9}, Stage::night}; }

    void begin() override { new_game(); }

    void new_game() {
        score = combo = 0;
        lives = 3;
        level = 1;
        over = false;
        bits.clear();
        build();
        serve();
    }
    void build() {
        const Colour colours[] = {Colour::pink,  Colour::orange, Colour::amber,
                                  Colour::green, Colour::blue,   Colour::violet};
        bricks.clear();
        for (int row = 0; row < 6; ++row) {
            for (int column = 0; column < 12; ++column) {
                const Vec2 low{0.8 + 1.2 * column + 0.05, 7.4 - 0.5 * row};
                bricks.push_back({low, low + Vec2{1.1, 0.4}, colours[row], 10 * (6 - row)});
            }
        }
    }
    void serve() {
        wait = 1;
        combo = 0;
        direction = Vec2{0.45, 0.9}.normalized();
        tail.clear();
    }
    void press(const Vec2 &) override {
        if (over) new_game();
        wait = std::min(wait, 0.0);
    }
    void move_paddle(double dt) {
        if (demo_mode) {
            paddle += std::clamp(ball.x() + 0.7 * std::sin(3 * ball.x()) - paddle, -14 * dt, 14 * dt);
        } else {
            if (left) paddle -= 14 * dt;
            if (right) paddle += 14 * dt;
            // only follow the pointer if it has moved, or the keys would fight with it
            if (hand.inside && (hand.at - last_hand).norm() > 0.001) {
                paddle = hand.at.x();
                last_hand = hand.at;
            }
        }
        paddle = std::clamp(paddle, half, 16 - half);
    }
    void step(double dt) override {
        if (demo_mode && (!untouched || hand.inside)) { // somebody wants to play: from the start
            demo_mode = false;
            new_game();
        }
        move_paddle(dt);
        for (auto &[bit, colour] : bits) {
            bit.velocity.y() -= 6 * dt;
            bit.position += dt * bit.velocity;
            bit.age += dt;
        }
        std::erase_if(bits, [](const auto &bit) { return bit.particle.age > bit.particle.life; });
        if (over) return;
        if (wait > 0) {
            wait -= dt;
            ball = {paddle, paddle_y + radius + 0.15};
            return;
        }
        const double v = speed * (1 + 0.15 * (level - 1));
        ball += dt * v * direction;
        tail.push_back(ball);
        if (tail.size() > 20) tail.erase(tail.begin());

        if (ball.x() < radius) direction.x() = std::abs(direction.x());
        if (ball.x() > 16 - radius) direction.x() = -std::abs(direction.x());
        if (ball.y() > 8.1 - radius) direction.y() = -std::abs(direction.y());

        if (direction.y() < 0 && std::abs(ball.y() - paddle_y) < radius + 0.15
            && std::abs(ball.x() - paddle) < half + radius) {
            const double angle = std::clamp((ball.x() - paddle) / half, -1.0, 1.0) * 1.05; // from straight up [rad]
            direction = {std::sin(angle), std::cos(angle)};
            combo = 0;
        }
        hit_bricks();
        if (ball.y() < -1) {
            --lives;
            best = std::max(best, score);
            tail.clear();
            if (lives == 0) over = true;
            else serve();
        }
        if (bricks.empty()) {
            ++level;
            build();
            serve();
        }
        if (over && demo_mode) new_game();
    }
    void hit_bricks() {
        for (std::size_t i = 0; i < bricks.size(); ++i) {
            const Brick &brick = bricks[i];
            const Vec2 nearest{std::clamp(ball.x(), brick.low.x(), brick.high.x()),
                               std::clamp(ball.y(), brick.low.y(), brick.high.y())};
            const Vec2 away = ball - nearest;
            if (away.norm() > radius) continue;
            if (std::abs(away.x()) > std::abs(away.y())) direction.x() = std::copysign(direction.x(), away.x());
            else direction.y() = std::copysign(direction.y(), away.y());
            ++combo;
            score += brick.worth * combo;
            for (const Vec2 &velocity : particles::ring_burst(14, 3, 0))
                bits.push_back({{nearest, velocity, 0, 0.7}, brick.colour});
            bricks.erase(bricks.begin() + i);
            return; // one brick a step
        }
    }
    void draw(Canvas &canvas) const override {
        for (const Brick &brick : bricks) canvas.body(box(brick.low, brick.high), brick.colour);
        canvas.body(box({paddle - half, paddle_y - 0.15}, {paddle + half, paddle_y + 0.15}), Colour::ink);
        canvas.trail(tail, Colour::amber, 8);
        canvas.lamp(ball, radius, Colour::amber);
        for (const auto &[bit, colour] : bits)
            canvas.sparks(std::vector<Spark>{{bit.position, 0.15, 1 - bit.age / bit.life}}, colour);

        canvas.text({1, 8.5}, "score " + std::to_string(score), Colour::ink);
        canvas.text({6, 8.5}, "level " + std::to_string(level), Colour::ink);
        for (int i = 0; i < lives; ++i) canvas.dot({15.5 - 0.5 * i, 8.5}, 0.15, Colour::amber);
        if (combo > 2) canvas.plate({8, 3.5}, "x" + std::to_string(combo), Colour::pink);
        if (over) canvas.plate({8, 3}, "Game over: " + std::to_string(score) + ". Press to play again", Colour::ink);
        else if (demo_mode) canvas.plate({8, 2.2}, "Move the pointer, or press left and right", Colour::ink);
        canvas.text({11, 8.5}, "best " + std::to_string(best), Colour::dim);
    }
};
SKETCH(Breakout, "A small Breakout: hit more than one brick in a go, and each is worth more")
