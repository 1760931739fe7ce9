#pragma once
// A scene: a small world that a reader may touch, as a struct with fields of its own.
//
//     struct Moon : demo::Scene {
//         static constexpr std::string_view name = "a moon";
//         demo::Slider pull = slider("pull", "1/s", 0, 9, 0.5, 3);
//         demo::Vec2 at{8, 4.5};
//         void step(double dt) override { at += dt * pull * (hand.at - at); }
//         void draw(demo::Canvas &canvas) const override { canvas.ball(at, 1, demo::Colour::amber); }
//     };
//
// It begins with its fields' values and with what `begin` does. Whatever calls an exercise belongs there, in `step` or in
// `draw`: there a page can say which function has failed.
#include "canvas.hpp"

#include <functional>
#include <memory>

namespace demo {

/// What is seen, and where it happens. It may be another one in each frame, so that a camera moves.
struct View {
    Vec2 low{0, 0}, high{16, 9}; ///< the part of the world [m]
    Stage stage{Stage::paper};
    double ground{0}; ///< how high the ground is, where the stage has one [m]
};

/// The mouse, or a finger.
struct Hand {
    Vec2 at{0, 0};      ///< where it is, or was last [m]
    bool inside{false}; ///< whether it's over the picture
    bool down{false};   ///< whether it presses
};

class Scene;

/// A control, as a number that the reader has set.
class Slider {
  public:
    operator double() const;

  private:
    friend class Scene;
    Slider(const Scene &of, std::size_t number) : scene{&of}, index{number} {}
    const Scene *scene;
    std::size_t index;
};

/// One of several words, as its number, from 0.
class Choice {
  public:
    operator int() const { return static_cast<int>(static_cast<double>(number)); }

  private:
    friend class Scene;
    explicit Choice(const Slider &slider) : number{slider} {}
    Slider number;
};

/// A key that acts while it's down, or its button.
class HeldKey {
  public:
    operator bool() const { return number != 0; }

  private:
    friend class Scene;
    explicit HeldKey(const Slider &slider) : number{slider} {}
    Slider number;
};

/// Something that acts once, when its button or key is pressed.
class Button {
    friend class Scene;
    Button() = default;
};

/// A point that the reader may drag, within its bounds. It's drawn on top of all, or below: see `handles_below`.
class Handle {
  public:
    Vec2 at() const;
    operator Vec2() const { return at(); }
    void move(const Vec2 &to);

  private:
    friend class Scene;
    friend class Player;
    Handle(Scene &of, std::size_t number) : scene{&of}, index{number} {}
    Scene *scene;
    std::size_t index;
};

class Scene {
  public:
    Scene() = default;
    Scene(const Scene &) = delete; // its controls know where it is
    Scene &operator=(const Scene &) = delete;
    virtual ~Scene() = default;

    virtual View view() const { return {}; }
    /// Once, before all steps.
    virtual void begin() {}
    /// How long a step is [s]; the host takes as many as are due.
    virtual double step_time() const { return 1.0 / 60; }
    virtual void step(double /*dt*/) {}
    virtual void draw(Canvas &) const = 0;

    /// The pointer goes down, and not on a handle; it goes up again.
    virtual void press(const Vec2 & /*at*/) {}
    virtual void release(const Vec2 & /*at*/) {}
    /// A handle has been dragged; it's let go, after that.
    virtual void drag() {}
    virtual void let_go() {}
    /// A control has another value.
    virtual void changed() {}
    /// The reader does something for the first time: what the scene has played by itself may go now.
    virtual void take_over() {}

    Hand hand;
    /// Nobody has touched it: it plays what it is about, by itself.
    bool untouched = true;
    /// When its still picture is taken, after the start [s].
    double still_time = 2;
    /// Where a body is what the reader grabs: its handle lies under all that's drawn, and shows only as a rim.
    bool handles_below = false;

  protected:
    Slider slider(std::string_view name, std::string_view unit, double low, double high, double step, double value) {
        return add({name, unit, low, high, step, value});
    }
    Choice choice(std::string_view name, std::vector<std::string_view> options, int chosen = 0) {
        return Choice{add(demo::choice(name, std::move(options), chosen))};
    }
    /// @param key as browsers call it: "n", "ArrowUp"; here and in `button`
    HeldKey held(std::string_view name, std::string_view key) { return HeldKey{add(demo::held(name, key))}; }
    Button button(std::string_view key, std::string_view meaning, std::function<void()> act) {
        keys.push_back({key, meaning});
        acts.push_back(std::move(act));
        return {};
    }
    Handle handle(const Vec2 &at, const Vec2 &low, const Vec2 &high, Colour colour = Colour::orange) {
        handles.push_back({at, low, high, colour});
        return {*this, handles.size() - 1};
    }

  private:
    friend class Slider;
    friend class Handle;
    friend class Scenes;
    friend class Player;
    struct Within {
        Vec2 at, low, high;
        Colour colour;
    };
    Slider add(Control control) {
        controls.push_back(std::move(control));
        return {*this, controls.size() - 1};
    }
    std::vector<Control> controls;
    std::vector<Key> keys;
    std::vector<std::function<void()>> acts; // of the keys
    std::vector<Within> handles;
};

inline Slider::operator double() const { return scene->controls[index].value; }
inline Vec2 Handle::at() const { return scene->handles[index].at; }
inline void Handle::move(const Vec2 &to) {
    Scene::Within &here = scene->handles[index];
    here.at = to.cwiseMax(here.low).cwiseMin(here.high);
}
} // namespace demo
