#pragma once
// What the host asks of a demo (see demo.hpp), for one that has scenes: read after `const demo::Scenes scenes` in play.
namespace play {
using State = demo::Player;
const demo::About about = scenes.about();
const demo::Scenes &still = scenes; // each has a moment of its own
inline State begin() { return State{scenes}; }
inline State next(State now, const demo::Input &in) {
    now.next(in);
    return now;
}
inline demo::Picture draw(const State &now, const demo::Input &) { return now.draw(); }
} // namespace play
