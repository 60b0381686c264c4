#pragma once

#include "simulation/diagnostics.h"
#include "simulation/method.h"

#include <ostream>

namespace ropesim {

// Ropes that the tests share, and what mathematics says of them.

// A straight rope of unit spacing from the origin along `direction` (a unit vector), mass 0 pinned.
Rope straight_rope(int masses, const Eigen::Array2d& direction, const Eigen::Array2d& gravity);

// The seed's rope: from (0, 200) to (-400, 200), mass 0 pinned, k = 100.
Rope seed_rope(int masses);

// Positions along the chain's own line, of a rope that only ever moves along it, at time `time`: the exact
// sum of its normal modes, u'' + damping u' + (k/m) (D Dᵀ) u = 0 about the equilibrium. Links must not pass
// through zero length. For a rope hanging down from the origin; result is y.
Eigen::ArrayXd hanging_chain(const Rope& rope, double time);

// Angle from the vertical, at time `time`, of a pendulum of length l let go at rest at angle `start`:
// sin(θ/2) = κ cd(ω t, κ), κ = sin(start/2), ω² = g/l (Abramowitz, Stegun 1964, 16.4 for sn, cn, dn).
double pendulum_angle(double start, double omega, double time);

// Advances from rest to frame `frames` and returns the positions there.
Points positions_at(const Rope& rope, const Method& method, const Stepping& stepping, long frames);

// How a test names a row of the table.
inline void PrintTo(const Method& method, std::ostream* out) {
    *out << method.name;
}

}  // namespace ropesim
