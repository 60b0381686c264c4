#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace ropesim {

// What of a scene is to be compared.
struct Choice {
    std::string rope;                  // by its name; the scene's first where it is ""
    std::vector<std::string> methods;  // that it is moved by
    std::vector<int> steps;            // per frame
};

// More would not be told apart.
inline constexpr std::size_t most_compared = 8;

// The scene whose ropes are the runs to compare. Without methods and steps these are the scene's own ropes
// as they are, or of a single rope symplectic Euler and Störmer-Verlet; else the chosen rope by each method,
// at each count of steps, in colours of their own: as many methods as steps, or one of either for all.
// Throws std::runtime_error where there is nothing to compare, or too much; or ropes differ in nodes.
Scene compared_scene(const Scene& scene, const Choice& choice);

// "Verlet: seed_verlet, 64 steps per frame"
std::string label(const Scene& scene, const SceneRope& rope);

}  // namespace ropesim
