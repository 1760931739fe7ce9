#pragma once
// Several scenes as one demo, for the host: a place of a chapter begins with the one that it names, "The game: NAME", and a
// choice offers the others. Controls and keys of one name are one, so that a value is kept from scene to scene.
#include "scene.hpp"

namespace demo {

class Scenes {
  public:
    struct Entry {
        std::string_view name;
        std::unique_ptr<Scene> (*make)();
    };
    Scenes(std::string_view about_all, std::vector<Entry> all) : title{about_all}, entries{std::move(all)} {}

    /// What the page must know: all controls and keys, each with the scenes that have it.
    About about() const {
        About all{title, {0, 0}, {16, 9}, {}, {}};
        const auto only = [&](std::string_view name) {
            return entries.size() > 1 ? std::vector{name} : std::vector<std::string_view>{};
        };
        if (entries.size() > 1) {
            all.controls.push_back(demo::choice("The game", {}, 0));
            for (const Entry &entry : entries) all.controls[0].options.push_back(entry.name);
            all.controls[0].high = double(entries.size() - 1);
        }
        for (const Entry &entry : entries) {
            const std::unique_ptr<Scene> scene = entry.make();
            if (&entry == &entries.front()) all.low = scene->view().low, all.high = scene->view().high;
            for (const Control &control : scene->controls)
                merge(all.controls, control, &Control::name, only(entry.name));
            for (const Key &key : scene->keys) merge(all.keys, key, &Key::key, only(entry.name));
        }
        return all;
    }

    std::size_t chosen(const Input &in) const { return entries.size() > 1 ? std::size_t(in["The game"]) : 0; }
    std::unique_ptr<Scene> make(std::size_t number) const { return entries[number].make(); }
    /// When the picture is taken that stands for a demo on paper, on a forge and in a browser without JavaScript: after the
    /// start [s].
    double still_time(const Input &in) const { return make(chosen(in))->still_time; }

  private:
    template <class T> static void merge(std::vector<T> &all, T one, std::string_view T::*name,
                                         const std::vector<std::string_view> &only) {
        const auto known = std::find_if(all.begin(), all.end(), [&](const T &each) { return each.*name == one.*name; });
        if (known != all.end()) known->only_with.insert(known->only_with.end(), only.begin(), only.end());
        else one.only_with = only, all.push_back(one);
    }
    std::string_view title;
    std::vector<Entry> entries;
};

/// For example: scenes<Opening, Lands>("A cannon on the ground.")
template <class... All> Scenes scenes(std::string_view title) {
    return {title, {{All::name, [] { return std::unique_ptr<Scene>{std::make_unique<All>()}; }}...}};
}

/// The scene that's played, and what the reader does in it.
class Player {
  public:
    Player() = default;
    explicit Player(const Scenes &of) : all{&of} {}

    void next(const Input &in) {
        if (!scene || all->chosen(in) != number) start(in);
        else if (set(in)) touch(), scene->changed();
        listen(in);
        for (int due = steps_due(spare, in, scene->step_time()); due > 0; --due) scene->step(scene->step_time());
    }

    Picture draw() const {
        Canvas canvas;
        scene->draw(canvas);
        const View view = scene->view();
        Picture &seen = canvas.picture;
        seen.low = view.low, seen.high = view.high, seen.stage = view.stage, seen.ground = view.ground;
        auto next = scene->handles_below ? seen.shapes.begin() : seen.shapes.end();
        for (const auto &[at, low, high, colour] : scene->handles)
            next = seen.shapes.insert(next, {.kind = Shape::handle, .colour = colour, .points = {at}}) + 1;
        return seen;
    }

  private:
    void start(const Input &in) {
        number = all->chosen(in);
        scene = all->make(number);
        spare = 0;
        held = -1;
        set(in);
        scene->begin();
    }
    /// Whether the controls have other values than before.
    bool set(const Input &in) {
        bool other = false;
        for (Control &control : scene->controls) {
            const double value = in[control.name];
            other = other || value != control.value;
            control.value = value;
        }
        return other;
    }
    void touch() {
        if (!scene->untouched) return;
        scene->untouched = false;
        scene->take_over();
    }
    void listen(const Input &in) {
        const bool was_down = scene->hand.down;
        scene->hand = {in.pointer, in.inside, in.down};
        if (const int handle = in.handle; handle >= 0 && handle < int(scene->handles.size())) {
            touch();
            Handle{*scene, std::size_t(handle)}.move(in.pointer);
            scene->drag();
        } else if (in.pressed) {
            touch();
            scene->press(in.pointer);
        }
        if (held >= 0 && in.handle < 0) scene->let_go();
        else if (held < 0 && was_down && !in.down) scene->release(in.pointer);
        held = in.down ? in.handle : -1; // a handle that arrow keys move is never held
        for (std::size_t i = 0; i < scene->keys.size(); ++i)
            if (scene->keys[i].key == in.key) touch(), scene->acts[i]();
    }

    const Scenes *all{};
    std::unique_ptr<Scene> scene{};
    std::size_t number{};
    double spare{}; // time that is left for the next step [s]
    int held{-1};   // which handle the pointer holds
};
} // namespace demo
