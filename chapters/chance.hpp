#pragma once
// Random numbers that are the same in every run, and on every machine: for the games, their demos and the programs.

namespace course {

/// A linear congruential generator. Its upper bits are the better ones.
struct Dice {
    unsigned seed;

    unsigned roll() { return seed = seed * 1664525u + 1013904223u; }
    double one() { return roll() / 4294967296.0; } ///< at least 0, and less than 1
};

/// At least 0 and less than 1: always the same number for the same two, and another one for others.
inline double chance(unsigned seed, unsigned number) {
    unsigned mixed = (seed * 7919 + number + 11) * 2654435761u;
    mixed = (mixed ^ mixed >> 15) * 2246822519u;
    return double((mixed ^ mixed >> 13) >> 20) / 4096;
}

} // namespace course
