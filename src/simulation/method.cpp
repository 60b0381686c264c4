#include "simulation/method.h"

#include "simulation/methods/methods.h"

#include <limits>
#include <stdexcept>
#include <string>

namespace ropesim {
namespace {

constexpr double unlimited = std::numeric_limits<double>::infinity();

constexpr Keeps nothing{};
constexpr Keeps momentum{.momentum = true};
constexpr Keeps symplectic{.symplectic = true, .momentum = true, .angular_momentum = true};
constexpr Keeps symmetric{.symplectic = true, .reversible = true, .momentum = true, .angular_momentum = true};

const Method table[] = {
    {"explicit_euler", Model::elastic, 1, 0.0, explicit_euler_stable, momentum, explicit_euler, nullptr,
     "shows how a method blows up: undamped, no step is stable"},
    {"symplectic_euler", Model::elastic, 1, 2.0, symplectic_euler_stable, symplectic,
     advance_by<symplectic_euler>, symplectic_euler,
     "the simplest that keeps its energy; the assignment's Euler"},
    {"stormer_verlet", Model::elastic, 2, 2.0, stormer_verlet_stable, symmetric, advance_by<stormer_verlet>,
     stormer_verlet, "as cheap as symplectic Euler and of order 2: the one to take"},
    {"backward_euler", Model::elastic, 1, unlimited, nullptr, momentum, backward_euler, nullptr,
     "any step, however stiff the rope; eats energy, so for ropes that come to rest"},
    {"implicit_midpoint", Model::elastic, 2, unlimited, nullptr, symmetric, implicit_midpoint, nullptr,
     "any step, however stiff the rope, and keeps its energy"},
    {"runge_kutta_4", Model::elastic, 4, 2.8284271247461903, runge_kutta_4_stable, momentum, runge_kutta_4,
     nullptr, "what most people reach for; loses energy, where a splitting keeps it"},
    {"blanes_moan_4", Model::elastic, 4, 5.0269072957885852, blanes_moan_4_stable, symmetric,
     advance_by<blanes_moan_4>, blanes_moan_4,
     "few large steps: the cheapest where a few pixels are allowed"},
    {"blanes_moan_6", Model::elastic, 6, 6.1500083017686670, blanes_moan_6_stable, symmetric,
     advance_by<blanes_moan_6>, blanes_moan_6,
     "errors below a pixel and far below: the most accurate for its cost"},
    {"xpbd", Model::elastic, 1, unlimited, nullptr, momentum, xpbd, nullptr,
     "springs of any stiffness at any step, by sweeps over the links; damps"},
    {"constraint_projection", Model::inextensible, 1, unlimited, nullptr, momentum, constraint_projection,
     nullptr, "a rope that does not stretch, by sweeps over its links; any step"},
    {"direct_projection", Model::inextensible, 2, unlimited, nullptr, symmetric, direct_projection, nullptr,
     "a rope that does not stretch, of order 2 and without loss: the one to take for stiff ropes"},
    {"seed_verlet", Model::elastic, 1, 2.0, symplectic_euler_stable, symplectic, advance_by<seed_verlet>,
     seed_verlet, "the assignment's Verlet to the letter: its start costs an order"},
    {"seed_constraints", Model::inextensible, 1, unlimited, nullptr, nothing, seed_constraints, nullptr,
     "the assignment's infinite stiffness to the letter: one sweep, halves"},
};

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

std::string letters(const Keeps& keeps) {
    std::string text;
    if (keeps.symplectic) text += 's';
    if (keeps.reversible) text += 'r';
    if (keeps.momentum) text += 'm';
    if (keeps.angular_momentum) text += 'a';
    return text.empty() ? "-" : text;
}

}  // namespace ropesim
