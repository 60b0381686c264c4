#pragma once

#include "simulation/block_tridiagonal.h"
#include "simulation/rope.h"

namespace ropesim {

struct Cost;
struct Scratch;
struct Stepping;

// Working arrays of the Newton iteration below; nothing in them outlives a step.
struct ImplicitSprings {
    Points unsprung;  // links×2, from mass i to mass i + 1, where the masses would be without springs
    Points link;      // links×2, the same where they are
    Points shift;     // masses×2, what springs add to the positions
    Points residual;  // masses×2, force of the springs times c, less mass times shift
    Points step;      // masses×2
    BlockTridiagonal system;
};

// By how much springs shift the masses in an implicit step, `shift` = u, from where they would be without:
//   M u = c f(y + u),   `unsprung` the links of y, c = h² or (h/2)², f the springs' forces; 0 at pins.
// Such a u is where the incremental potential ½ uᵀM u + c U(y + u) is stationary (Martin, Thomaszewski,
// Grinspun, Gross: Example-Based Elastic Materials, 2011, 4; Hairer, Lubich, Wanner: Geometric Numerical
// Integration, 2006, VIII.6.1). Newton goes down that potential, by its exact Hessian M + c ∂²U where it is
// positive definite. A compressed link has negative stiffness across, k (1 - l/L): where the Hessian is not
// positive definite because of it, that part of the compressed links is left out of it for one iteration.
// Each step is halved until the potential falls (Nocedal, Wright: Numerical Optimization, 2006, 3.1).
// Done when every row is off by no more than `implicit_tolerance` of the terms that it is the difference of;
// false where that is not reached in `most_iterations`. Adds to the cost.
inline constexpr double implicit_tolerance = 4e-15;
inline constexpr int most_iterations = 100;
bool solve_implicit_springs(const Rope& rope, double c, ImplicitSprings& springs, Cost& cost);

// Fills `unsprung`: the links where the masses have moved so.
void place_unsprung(const Points& position, const Points& moved, ImplicitSprings& springs);

// A step of size h in which damping leaves the share `kept` of a velocity. False, and the state as it was,
// where its iteration finds no solution.
using ImplicitStep = bool(const Rope& rope, double h, double kept, State& state, Scratch& scratch);

// Advances by steps; where one finds no solution, as from a crumpled rope that shoots apart in it, by two of
// half its size, and these likewise: halved often enough, M outweighs c ∂²U, and Newton's way is straight.
// Positions are NaN where that does not help either.
void take_implicit_steps(ImplicitStep* take_step, const Rope& rope, const Stepping& stepping, State& state,
                         Scratch& scratch);

// The stiffness of a spring from link vector (dx, dy), its force's derivative: k n nᵀ + k (1 - l/L) (1 - n
// nᵀ), as xx, xy, yy. `without_compression` leaves the second part out where it is negative. Zero length: no
// direction, and none where left out.
Eigen::Array3d link_stiffness(const Rope& rope, double dx, double dy, bool without_compression);

}  // namespace ropesim
