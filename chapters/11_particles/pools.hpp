#pragma once
#include "particles.hpp"

/// Three ways to keep particles, for the benchmark: what they have in common is that they are full when they begin.
namespace particles {

//> A frame of one particle
/// Moves it on; says whether it still lives.
inline bool advance(Particle &particle, double dt) {
    particle.velocity += dt * Vec2{0, -9.81};
    particle.position += dt * particle.velocity;
    particle.age += dt;
    return particle.age < particle.life;
}

//> Linear search
/// Who starts looks from the first slot on until it finds one that is free.
class LinearSearch {
  public:
    explicit LinearSearch(const std::vector<Particle> &particles) : slots(particles.begin(), particles.end()) {}

    bool start(const Particle &particle) {
        for (auto &slot : slots)
            if (!slot) {
                slot = particle;
                return true;
            }
        return false;
    }
    void step(double dt) {
        for (auto &slot : slots)
            if (slot && !advance(*slot, dt)) slot.reset();
    }

  private:
    Pool slots;
};

//> A free list
/// Beside the slots it keeps a list of those that are free. Who dies adds a slot to it, who starts takes the last one.
class FreeList {
  public:
    explicit FreeList(const std::vector<Particle> &particles) : slots(particles.begin(), particles.end()) {}

    bool start(const Particle &particle) {
        if (free.empty()) return false;
        slots[free.back()] = particle;
        free.pop_back();
        return true;
    }
    void step(double dt) {
        for (std::size_t i = 0; i < slots.size(); ++i)
            if (slots[i] && !advance(*slots[i], dt)) {
                slots[i].reset();
                free.push_back(i);
            }
    }

  private:
    Pool slots;
    std::vector<std::size_t> free;
};

//> Swap and remove
/// No gaps: the last one moves into the place of who dies, and who starts stands at the end.
class SwapRemove {
  public:
    explicit SwapRemove(const std::vector<Particle> &all) : particles{all}, capacity{all.size()} {}

    bool start(const Particle &particle) {
        if (particles.size() == capacity) return false;
        particles.push_back(particle);
        return true;
    }
    void step(double dt) {
        for (std::size_t i = 0; i < particles.size();) {
            if (advance(particles[i], dt)) {
                ++i;
            } else {
                particles[i] = particles.back(); // it has not moved on in this frame, so i stays
                particles.pop_back();
            }
        }
    }

  private:
    std::vector<Particle> particles;
    std::size_t capacity;
};
//>
} // namespace particles
