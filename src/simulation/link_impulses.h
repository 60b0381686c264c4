#pragma once

#include "simulation/rope.h"

namespace ropesim {

// Solves T δ = r in place for impulses along the links `before` (links×2), one per link, mass i getting
// w[i] (δ[i] before[i] - δ[i-1] before[i-1]). T is by how much they shorten the links `after`, times those:
//   T δ [i] = -w[i] e[i]·d[i-1] δ[i-1] + (w[i] + w[i+1]) e[i]·d[i] δ[i] - w[i+1] e[i]·d[i+1] δ[i+1],
// d before, e after, w inverse masses. By elimination without pivoting (Thomas). A link between two masses
// that are held gets no impulse, and neither does one whose constraint those before it imply. Sizes `upper`,
// which holds the elimination's factors.
void solve_impulses(const Eigen::ArrayXd& weight, const Points& before, const Points& after,
                    Eigen::ArrayXd& upper, Eigen::ArrayXd& r);

}  // namespace ropesim
