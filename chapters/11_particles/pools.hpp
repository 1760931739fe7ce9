#pragma once
#include "particles.hpp"

/// Three kinds of pool, for the benchmark. Each begins full.
namespace particles {

//> A frame of one particle
/// Moves a particle on, and says whether it is still alive.
inline bool advance(Particle &particle, double dt) {
    particle.velocity += dt * Vec2{0, -9.81};
    particle.position += dt * particle.velocity;
    particle.age += dt;
    return particle.age < particle.life;
}

//> Linear search
/// To spawn, it searches from the first slot until it finds a free one.
class LinearSearch {
  public:
    explicit LinearSearch(const std::vector<Particle> &particles) : slots(particles.begin(), particles.end()) {}

    bool spawn(const Particle &particle) {
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
/// Beside the slots it keeps a list of the free ones. A particle that dies adds its slot; spawning takes the last one.
class FreeList {
  public:
    explicit FreeList(const std::vector<Particle> &particles) : slots(particles.begin(), particles.end()) {}

    bool spawn(const Particle &particle) {
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

//> Swap and pop
/// No gaps: the last particle moves into the place of one that dies, and new ones are added at the end.
class SwapPop {
  public:
    explicit SwapPop(const std::vector<Particle> &all) : particles{all}, capacity{all.size()} {}

    bool spawn(const Particle &particle) {
        if (particles.size() == capacity) return false;
        particles.push_back(particle);
        return true;
    }
    void step(double dt) {
        for (std::size_t i = 0; i < particles.size();) {
            if (advance(particles[i], dt)) {
                ++i;
            } else {
                particles[i] = particles.back(); // it has not moved in this frame yet, so i stays
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
