#include "simulation/implicit_springs.h"

#include "simulation/links.h"
#include "simulation/method.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ropesim {
namespace {

constexpr double epsilon = std::numeric_limits<double>::epsilon();

double length(double dx, double dy) {
    return std::sqrt(dx * dx + dy * dy + shortest_squared);
}

void resize(ImplicitSprings& springs, Eigen::Index masses) {
    springs.link.resize(masses - 1, 2);
    springs.shift.resize(masses, 2);
    springs.residual.resize(masses, 2);
    springs.step.resize(masses, 2);
    springs.system.diagonal.resize(masses, 3);
    springs.system.coupling.resize(masses - 1, 3);
}

void place_links(ImplicitSprings& springs) {
    const Eigen::Index links = springs.link.rows();
    springs.link = springs.unsprung + (springs.shift.bottomRows(links) - springs.shift.topRows(links));
}

// Fills the residual; the greatest ratio of a row of it to the terms that it is the difference of. To the
// force of a link belongs what the rounding of its vector does to it: that times k max(1, l/L).
double evaluate_residual(const Rope& rope, double c, ImplicitSprings& springs) {
    const Eigen::Index masses = springs.shift.rows();
    double worst = 0.0;
    double before_x = 0.0, before_y = 0.0, before_stiffness = 0.0, before_scale = 0.0;
    for (Eigen::Index i = 0; i < masses; ++i) {
        double pull_x = 0.0, pull_y = 0.0, stiffness = 0.0, scale = 0.0;
        if (i + 1 < masses) {
            const double dx = springs.link(i, 0);
            const double dy = springs.link(i, 1);
            const double L = length(dx, dy);
            const double pull = c * rope.stiffness * (1.0 - rope.rest_length / L);
            pull_x = pull * dx;
            pull_y = pull * dy;
            stiffness = c * rope.stiffness * std::max(1.0, rope.rest_length / L);
            scale = stiffness * (L + std::abs(springs.unsprung(i, 0)) + std::abs(springs.unsprung(i, 1)));
        }
        if (rope.inverse_mass(i) > 0.0) {
            const double m = rope.mass(i);
            const double ux = springs.shift(i, 0);
            const double uy = springs.shift(i, 1);
            springs.residual.row(i) << pull_x - before_x - m * ux, pull_y - before_y - m * uy;
            const double off = std::abs(springs.residual(i, 0)) + std::abs(springs.residual(i, 1));
            const double terms =
                scale + before_scale + (m + stiffness + before_stiffness) * (std::abs(ux) + std::abs(uy));
            if (!(off <= worst * terms)) worst = off / terms;
        } else {
            springs.residual.row(i) = 0.0;
        }
        before_x = pull_x;
        before_y = pull_y;
        before_stiffness = stiffness;
        before_scale = scale;
    }
    return worst;
}

// M + c ∂²U, with rows and columns of pinned masses those of the unit matrix.
void fill_hessian(const Rope& rope, double c, bool without_compression, ImplicitSprings& springs) {
    Eigen::ArrayX3d& diagonal = springs.system.diagonal;
    const Eigen::Index masses = diagonal.rows();
    const auto free = [&](Eigen::Index i) { return rope.inverse_mass(i) > 0.0; };
    for (Eigen::Index i = 0; i < masses; ++i) {
        const double m = free(i) ? rope.mass(i) : 1.0;
        diagonal.row(i) << m, 0.0, m;
    }
    for (Eigen::Index i = 0; i + 1 < masses; ++i) {
        const Eigen::Array3d stiffness =
            c * link_stiffness(rope, springs.link(i, 0), springs.link(i, 1), without_compression);
        if (free(i)) diagonal.row(i) += stiffness.transpose();
        if (free(i + 1)) diagonal.row(i + 1) += stiffness.transpose();
        const double couples = free(i) && free(i + 1) ? -1.0 : 0.0;
        springs.system.coupling.row(i) = couples * stiffness.transpose();
    }
}

bool find_step(const Rope& rope, double c, ImplicitSprings& springs) {
    fill_hessian(rope, c, false, springs);
    if (!factor(springs.system)) {
        fill_hessian(rope, c, true, springs);
        if (!factor(springs.system)) return false;
    }
    springs.step = springs.residual;
    solve(springs.system, springs.step);
    return true;
}

struct Change {
    double value = 0.0;
    double rounding = 0.0;  // what it may be off by
};

// Of the incremental potential along a share t of the step, as a sum of differences, so that its rounding
// goes to zero with the step: m t s (u + t s/2), and c k/2 (L' - L)(L' + L - 2l) for each link.
Change potential_change(const Rope& rope, double c, const ImplicitSprings& springs, double t) {
    Change change;
    const auto add = [&](double term, double size) {
        change.value += term;
        change.rounding += 8.0 * epsilon * size;
    };
    const Eigen::Index masses = springs.shift.rows();
    for (Eigen::Index i = 0; i < masses; ++i) {
        if (rope.inverse_mass(i) == 0.0) continue;
        for (int axis = 0; axis < 2; ++axis) {
            const double moved = t * springs.step(i, axis);
            const double shift = springs.shift(i, axis);
            add(rope.mass(i) * moved * (shift + 0.5 * moved),
                rope.mass(i) * std::abs(moved) * (std::abs(shift) + std::abs(moved)));
        }
    }
    for (Eigen::Index i = 0; i + 1 < masses; ++i) {
        const double dx = springs.link(i, 0);
        const double dy = springs.link(i, 1);
        const double moved_x = t * (springs.step(i + 1, 0) - springs.step(i, 0));
        const double moved_y = t * (springs.step(i + 1, 1) - springs.step(i, 1));
        const double both = length(dx, dy) + length(dx + moved_x, dy + moved_y);
        const double longer = (moved_x * (2.0 * dx + moved_x) + moved_y * (2.0 * dy + moved_y)) / both;
        const double half = 0.5 * c * rope.stiffness;
        add(half * longer * (both - 2.0 * rope.rest_length),
            half * (std::abs(moved_x) + std::abs(moved_y)) * (both + 2.0 * rope.rest_length));
    }
    return change;
}

// Halves the step until the potential falls by a share of what its slope promises, and takes it.
bool take_step(const Rope& rope, double c, ImplicitSprings& springs) {
    constexpr double sufficient = 1e-4;  // Nocedal, Wright 2006, 3.1
    constexpr int most_halvings = 60;
    const double slope = -(springs.residual * springs.step).sum();
    double t = 1.0;
    for (int halving = 0; halving <= most_halvings; ++halving, t *= 0.5) {
        const Change change = potential_change(rope, c, springs, t);
        if (!(change.value <= sufficient * t * slope + change.rounding)) continue;
        springs.shift += t * springs.step;
        return true;
    }
    return false;
}

bool take_whole_or_halves(ImplicitStep* take_step, const Rope& rope, double h, double kept, int halvings_left,
                          State& state, Scratch& scratch) {
    if (take_step(rope, h, kept, state, scratch)) return true;
    if (halvings_left == 0) return false;
    for (int half = 0; half < 2; ++half)
        if (!take_whole_or_halves(take_step, rope, h / 2.0, std::sqrt(kept), halvings_left - 1, state,
                                  scratch))
            return false;
    return true;
}

}  // namespace

void place_unsprung(const Points& position, const Points& moved, ImplicitSprings& springs) {
    const Eigen::Index links = position.rows() - 1;
    springs.unsprung = (position.bottomRows(links) - position.topRows(links)) +
                       (moved.bottomRows(links) - moved.topRows(links));
}

void take_implicit_steps(ImplicitStep* take_step, const Rope& rope, const Stepping& stepping, State& state,
                         Scratch& scratch) {
    constexpr int most_halvings = 20;
    const double kept = velocity_kept(rope, stepping);
    for (long step = 0; step < stepping.steps; ++step) {
        if (take_whole_or_halves(take_step, rope, stepping.step_size, kept, most_halvings, state, scratch))
            continue;
        state.position = std::numeric_limits<double>::quiet_NaN();
        return;
    }
}

Eigen::Array3d link_stiffness(const Rope& rope, double dx, double dy, bool without_compression) {
    const double L = length(dx, dy);
    const double nx = dx / L;
    const double ny = dy / L;
    const double across = 1.0 - rope.rest_length / L;
    const double kept = without_compression && across < 0.0 ? 0.0 : across;
    return rope.stiffness *
           Eigen::Array3d(nx * nx + kept * ny * ny, (1.0 - kept) * nx * ny, ny * ny + kept * nx * nx);
}

bool solve_implicit_springs(const Rope& rope, double c, ImplicitSprings& springs, Cost& cost) {
    resize(springs, springs.unsprung.rows() + 1);
    springs.shift = 0.0;
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
        place_links(springs);
        ++cost.evaluations;
        if (evaluate_residual(rope, c, springs) <= implicit_tolerance) return true;
        ++cost.solves;
        if (!find_step(rope, c, springs) || !take_step(rope, c, springs)) return false;
    }
    return false;
}

}  // namespace ropesim
