#pragma once

#include "simulation/method.h"

namespace ropesim {

// Added to the square of a link's length, so that 0 * (rest length / length) is 0. Lengths above 1e-91 are
// those without it, to the last bit.
inline constexpr double shortest_squared = 1e-200;

// scratch.acceleration: that of every mass by its springs and gravity; zero at pinned masses. A link of
// length zero has no direction and pulls nowhere. Sizes scratch.link_force as needed and counts itself.
void accelerations(const Rope& rope, const Points& position, Scratch& scratch);

// The same from and to bare arrays: x of all masses, then their y.
void accelerations(const Rope& rope, const double* position, double* acceleration, Scratch& scratch);

// From one end of a link to the other, once the masses have moved.
Eigen::Array2d link_after(const Points& position, const Points& moved, Eigen::Index link);

// Changes by how much the two ends of a link have moved, along the link, so that its length comes to
// `rest_length` where the shares add up to one: each end yields its share of the excess. A link of length
// zero is left alone.
void pull_to_rest_length(const Points& position, Points& moved, Eigen::Index link, double rest_length,
                         double first_share, double second_share);

// The share of its velocity that damping leaves to a mass after one step.
double velocity_kept(const Rope& rope, const Stepping& stepping);

// The damping of a step as an exponent: a velocity decays to exp(-damping_per_step). The rate's share is
// proportional to the step, the factor's is -log(1 - factor); infinite where the factor is 1.
double damping_per_step(const Rope& rope, const Stepping& stepping);

// exp(-x), and its mean over [0, x], (1 - exp(-x)) / x, by + * / alone: the C library's exp may round
// differently from machine to machine.
double decay(double x);
double mean_decay(double x);

}  // namespace ropesim
