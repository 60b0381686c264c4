#pragma once

#include "simulation/method.h"

namespace ropesim {

// Acceleration of every mass by its springs and gravity; zero at pinned masses. A link of length zero has
// no direction and pulls nowhere. Resizes `acceleration` and `link_force` as needed.
void accelerations(const Rope& rope, const Points& position, Points& link_force, Points& acceleration);

// Moves the two ends of a link along it so that its length comes to `rest_length` where the shares add up
// to one: each end moves by its share of the excess. A link of length zero is left alone.
void pull_to_rest_length(Points& position, Eigen::Index link, double rest_length, double first_share,
                         double second_share);

// The share of its velocity that damping leaves to a mass after one step.
double velocity_kept(const Rope& rope, const Stepping& stepping);

// exp(-x) for x >= 0, by + * / alone: the C library's exp may round differently from machine to machine.
double decay(double x);

}  // namespace ropesim
