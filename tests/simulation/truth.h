#pragma once

#include "simulation/method.h"

namespace ropesim {

// Where the masses of a rope are at `time`, from rest, to about 1e-11: by the classical Runge-Kutta method in
// long double, `steps` of it per unit of time, on equations that share no code with the methods.
//   elastic: Newton's, spring by spring.
//   inextensible: Lagrange's, the angles of the links and the place of mass 0 for coordinates, pins as
//   constraints of the accelerations: dense, so for ropes of a few masses.
Points truth(const Rope& rope, Model model, double time, long steps);

}  // namespace ropesim
