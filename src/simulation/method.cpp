#include "simulation/method.h"

#include "simulation/methods/methods.h"

#include <array>
#include <limits>
#include <stdexcept>
#include <string>

namespace ropesim {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

const std::array<Method, 6> table{{
    {"explicit_euler", Model::elastic, 1, 0.0, explicit_euler_stable, explicit_euler,
     "shows how a method blows up: undamped, no step is stable"},
    {"symplectic_euler", Model::elastic, 1, 2.0, symplectic_euler_stable, symplectic_euler,
     "the simplest that keeps its energy; the assignment's Euler"},
    {"stormer_verlet", Model::elastic, 2, 2.0, stormer_verlet_stable, stormer_verlet,
     "as cheap as symplectic Euler and of order 2: the one to take"},
    {"constraint_projection", Model::inextensible, 1, unlimited, nullptr, constraint_projection,
     "a rope that does not stretch, by sweeps over its links; any step"},
    {"seed_verlet", Model::elastic, 1, 2.0, symplectic_euler_stable, seed_verlet,
     "the assignment's Verlet to the letter: its start costs an order"},
    {"seed_constraints", Model::inextensible, 1, unlimited, nullptr, seed_constraints,
     "the assignment's infinite stiffness to the letter: one sweep, halves"},
}};

}  // namespace

Stepping stepping(double frame_time, long steps_per_frame) {
    return {.steps = steps_per_frame, .step_size = frame_time / static_cast<double>(steps_per_frame)};
}

std::span<const Method> methods() {
    return table;
}

const Method& find_method(std::string_view name) {
    std::string known;
    for (const Method& method : table) {
        if (method.name == name) return method;
        known += (known.empty() ? "" : ", ") + std::string(method.name);
    }
    throw std::runtime_error("unknown method '" + std::string(name) + "'; expected one of: " + known);
}

std::string_view name(Model model) {
    return model == Model::elastic ? "elastic" : "inextensible";
}

}  // namespace ropesim
