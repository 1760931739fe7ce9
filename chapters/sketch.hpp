#pragma once
// A sketch: a scene of the reader's own, in exercises/sketches/ (docs/sketches.md). It may call the functions of all
// sections, by their namespaces, as trajectories::launch_velocity: the reader's own where they're done, ours elsewhere.
#include "scenes.hpp"

/// SKETCH(Moon, "A moon that follows the pointer"): which scene it is, and its title.
#define SKETCH(Type, title)                                                                                            \
    struct Sketched : Type {                                                                                           \
        static constexpr std::string_view name = title;                                                                \
    };                                                                                                                 \
    demo::Scenes sketched_scenes() { return demo::scenes<Sketched>(title); }

demo::Scenes sketched_scenes();
