#pragma once

#include "simulation/method.h"

namespace ropesim {

// Advances by the plain form of a method that the program has a fast form of: whole arrays, one formula after
// the other, as the method's comment has them.
void advance_plainly(std::string_view method, const Rope& rope, const Stepping& stepping, State& state);

// The names that it knows.
inline constexpr std::string_view plain_methods[] = {"symplectic_euler", "stormer_verlet", "seed_verlet",
                                                     "blanes_moan_4",    "blanes_moan_6",  "runge_kutta_4"};

// By Hooke's law, spring by spring.
Points plain_accelerations(const Rope& rope, const Points& position);

}  // namespace ropesim
