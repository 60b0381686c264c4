#pragma once

#include "simulation/instruction_set.h"
#include "simulation/rope.h"

namespace ropesim {

// A chain's tridiagonal system, one row per link; scratch for solving it.
struct LinkSystem {
    Eigen::ArrayXd lower;  // what couples a link to the one before
    Eigen::ArrayXd diagonal;
    Eigen::ArrayXd upper;  // to the one after
};

// Solves T δ = r in place for impulses along the links `before` (links×2), one per link, mass i getting
// w[i] (δ[i] before[i] - δ[i-1] before[i-1]). T is by how much they shorten the links `after`, times those:
//   T δ [i] = -w[i] e[i]·d[i-1] δ[i-1] + (w[i] + w[i+1]) e[i]·d[i] δ[i] - w[i+1] e[i]·d[i+1] δ[i+1],
// d before, e after, w inverse masses. By elimination without pivoting from both ends to the middle link
// (Babuška: Numerical Stability in Problems of Linear Algebra, SIAM J. Numer. Anal. 9, 1972): two chains of
// divisions that do not wait for each other. A link between two masses that are held gets no impulse, and
// neither does one whose constraint those that are eliminated before it imply.
void solve_impulses(const Eigen::ArrayXd& weight, const Points& before, const Points& after,
                    InstructionSet instructions, LinkSystem& system, Eigen::ArrayXd& r);

}  // namespace ropesim
