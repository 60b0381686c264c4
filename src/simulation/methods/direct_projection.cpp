#include "simulation/diagnostics.h"
#include "simulation/lanes.h"
#include "simulation/link_impulses.h"
#include "simulation/links.h"
#include "simulation/methods/methods.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>
#include <string>

namespace ropesim {
namespace {

using Eigen::Index;

// The constraints of a step, |e|² = l² for the links e that it ends with, are met to this share of l². Seven
// times the rounding of |e|² itself.
constexpr double tolerance = 1.6e-15;
// Newton's iteration doubles the digits each time: it needs 2 to 5. What it has not met after this many is
// taken where rounding alone can be what is left (heavy beside light masses), and else is no solution.
constexpr int most_iterations = 25;
constexpr double rounding = 1e-11;

Eigen::Array2d difference(const Points& points, Index link) {
    return {points(link + 1, 0) - points(link, 0), points(link + 1, 1) - points(link, 1)};
}

// Inverse masses; zero also where a rope is pulled straight between two pins: there it has but one shape, and
// the constraints along it do not determine its tension.
void find_weights(const Rope& rope, const State& state, Eigen::ArrayXd& weight) {
    weight = rope.inverse_mass;
    Index pin = -1;
    for (Index mass = 0; mass < weight.size(); ++mass) {
        if (rope.inverse_mass(mass) > 0.0) continue;
        if (pin >= 0) {
            const double dx = state.position(mass, 0) - state.position(pin, 0);
            const double dy = state.position(mass, 1) - state.position(pin, 1);
            const double reach = rope.rest_length * static_cast<double>(mass - pin);
            if (std::sqrt(dx * dx + dy * dy) >= reach * (1.0 - 1e-12)) weight.segment(pin, mass - pin) = 0.0;
        }
        pin = mass;
    }
}

void require_rest_lengths(const Rope& rope, const State& state) {
    for (Index link = 0; link + 1 < state.position.rows(); ++link) {
        const Eigen::Array2d d = difference(state.position, link);
        const double length = std::sqrt(d.x() * d.x() + d.y() * d.y());
        if (!is_rest_length(rope.rest_length, length))
            throw std::runtime_error(
                "direct_projection: link " + std::to_string(link) + " is " + std::to_string(length) +
                " long at the start; expected its rest length, " + std::to_string(rope.rest_length));
    }
}

// Adds to each mass, by its weight, the impulses along the links: less that of the link before, then that of
// the one after.
void add_impulses(const Eigen::ArrayXd& weight, const Points& links, const Eigen::ArrayXd& impulse,
                  Points& vectors) {
    const double* const w = weight.data();
    const double* const along = impulse.data();
    for (int axis = 0; axis < 2; ++axis) {
        const double* const link = links.col(axis).data();
        double* const vector = vectors.col(axis).data();
        for (Index i = 0; i < impulse.size(); ++i) vector[i + 1] -= w[i + 1] * (along[i] * link[i]);
        for (Index i = 0; i < impulse.size(); ++i) vector[i] += w[i] * (along[i] * link[i]);
    }
}

// The greatest of the numbers' magnitudes; not a number where one of them is none. Without their sign,
// doubles are in the order of the integers of the same bits.
double greatest_magnitude(const Eigen::ArrayXd& numbers) {
    constexpr std::int64_t all_but_sign = std::numeric_limits<std::int64_t>::max();
    std::int64_t greatest = 0;
    const double* const number = numbers.data();
    for (Index i = 0; i < numbers.size(); ++i)
        greatest = std::max(greatest, std::bit_cast<std::int64_t>(number[i]) & all_but_sign);
    return std::bit_cast<double>(greatest);
}

// Where the links are once the masses have moved, and half of what each lacks in |e|² to l². The greatest
// such lack of a link that can move, as a share of l².
double evaluate_lack(const Rope& rope, DirectProjection& work, const Points& moved) {
    const double squared = rope.rest_length * rope.rest_length;
    for (int axis = 0; axis < 2; ++axis) {
        const double* const before = work.before.col(axis).data();
        const double* const way = moved.col(axis).data();
        double* const after = work.after.col(axis).data();
        for (Index i = 0; i < work.lack.size(); ++i) after[i] = before[i] + (way[i + 1] - way[i]);
    }
    const double* const half = work.half.data();
    const double* const ex = work.after.col(0).data();
    const double* const ey = work.after.col(1).data();
    double* const lack = work.lack.data();
    for (Index i = 0; i < work.lack.size(); ++i)
        lack[i] = half[i] * (ex[i] * ex[i] + ey[i] * ey[i] - squared);
    return 2.0 * greatest_magnitude(work.lack) / squared;
}

// Newton's iteration for the impulses along the links `before` by which the links keep their length. False
// where it finds none.
bool keep_lengths(const Rope& rope, Points& moved, Scratch& scratch) {
    DirectProjection& work = scratch.direct_projection;
    double last = std::numeric_limits<double>::infinity();
    for (int iteration = 0; iteration < most_iterations; ++iteration) {
        const double worst = evaluate_lack(rope, work, moved);
        if (worst <= tolerance || (worst <= rounding && worst > 0.5 * last)) return true;
        if (!std::isfinite(worst)) return false;
        last = worst;
        ++scratch.cost.solves;
        solve_impulses(work.weight, work.before, work.after, scratch.instructions, work.system, work.lack);
        add_impulses(work.weight, work.before, work.lack, moved);
        work.impulse += work.lack;
    }
    return false;
}

// The impulses of this step, from those of the two before: the first step has but half a kick to make up for.
// Steps are counted from the last that had nothing before it.
void guess_impulses(long step, DirectProjection& work) {
    if (step == 1) work.impulse *= 2.0;
    if (step <= 2) {
        work.impulse_before = work.impulse;
        return;
    }
    work.impulse_before = 2.0 * work.impulse - work.impulse_before;
    work.impulse.swap(work.impulse_before);
}

void find_links(const Points& position, Points& links) {
    for (Index i = 0; i < links.rows(); ++i)
        for (int axis = 0; axis < 2; ++axis) links(i, axis) = position(i + 1, axis) - position(i, axis);
}

// Takes from the velocities what would change the length of a link (RATTLE's second half).
void keep_lengths_at_rest(State& state, Scratch& scratch) {
    DirectProjection& work = scratch.direct_projection;
    find_links(state.position, work.before);
    for (Index i = 0; i < work.lack.size(); ++i)
        work.lack(i) = work.before(i, 0) * (state.velocity(i + 1, 0) - state.velocity(i, 0)) +
                       work.before(i, 1) * (state.velocity(i + 1, 1) - state.velocity(i, 1));
    ++scratch.cost.solves;
    solve_impulses(work.weight, work.before, work.before, scratch.instructions, work.system, work.lack);
    add_impulses(work.weight, work.before, work.lack, state.velocity);
}

void begin(const Rope& rope, const State& state, DirectProjection& work) {
    const Index links = state.position.rows() - 1;
    work.before.resize(links, 2);
    work.after.resize(links, 2);
    work.lack.resize(links);
    work.impulse.setZero(links);
    work.impulse_before.setZero(links);
    find_weights(rope, state, work.weight);
    work.half = (work.weight.head(links) + work.weight.tail(links) > 0.0)
                    .select(Eigen::ArrayXd::Constant(links, 0.5), 0.0);
    require_rest_lengths(rope, state);
}

// One step from where `work.impulse` is guessed to lead. False, and the state as it was, where no impulses
// keep the lengths.
bool take_step_in_lanes(const Rope& rope, double h, double kept_half, State& state, Scratch& scratch) {
    DirectProjection& work = scratch.direct_projection;
    Points& moved = scratch.displacement;
    const Points& fall = scratch.kick;
    find_links(state.position, work.before);
    moved = h * (kept_half * state.velocity + h / 2.0 * fall);
    add_impulses(work.weight, work.before, work.impulse, moved);
    if (!keep_lengths(rope, moved, scratch)) return false;
    state.position += moved;
    state.velocity = kept_half * (moved / h + h / 2.0 * fall);
    return true;
}

bool take_step(const Rope& rope, double h, double kept_half, State& state, Scratch& scratch) {
    bool taken = false;
    in_lanes(scratch.instructions,
             [&](auto) { taken = take_step_in_lanes(rope, h, kept_half, state, scratch); });
    return taken;
}

// A step that is too large for Newton's iteration, as two of half its size, and these likewise.
bool take_two_steps(const Rope& rope, double h, double kept_half, int halvings_left, State& state,
                    Scratch& scratch) {
    for (int half = 0; half < 2; ++half) {
        scratch.direct_projection.impulse = 0.0;
        if (take_step(rope, h, kept_half, state, scratch)) continue;
        if (halvings_left == 0 ||
            !take_two_steps(rope, h / 2.0, std::sqrt(kept_half), halvings_left - 1, state, scratch))
            return false;
    }
    scratch.direct_projection.impulse = 0.0;
    return true;
}

}  // namespace

// Direct projection (SHAKE): Störmer-Verlet whose links keep their length by forces along their directions at
// the start of the step, found by Newton's iteration on the chain's tridiagonal system. Order 2, symplectic,
// symmetric; no secular drift of the energy.
//   v½ = v + h/2 g,   x' = x + h v½ + Σ λ w d(x) with |d(x')| = l,   v½ = (x' - x)/h,   v' = v½ + h/2 g
// RATTLE's projection of the velocities is along the same directions as the next step's forces, which make up
// for it: it moves no position, so that only the last step's need it. Damping is exact on both sides of the
// step (Strang splitting). Ryckaert, Ciccotti, Berendsen: J. Comput. Phys. 23, 1977; Andersen: Rattle,
// J. Comput. Phys. 52, 1983; Hairer, Lubich, Wanner: Geometric Numerical Integration, 2006, VII.1.4.
// A step whose iteration does not converge, as where a link turns far in it, is made in two halves instead.
// Throws std::runtime_error where a link does not start at its rest length.
void direct_projection(const Rope& rope, const Stepping& stepping, State& state, Scratch& scratch) {
    constexpr int most_halvings = 10;
    const double h = stepping.step_size;
    const double kept_half = std::sqrt(velocity_kept(rope, stepping));
    DirectProjection& work = scratch.direct_projection;
    begin(rope, state, work);
    scratch.kick = rope.free_fall;
    for (Index i = 0; i < work.weight.size(); ++i)
        if (work.weight(i) == 0.0) scratch.kick.row(i) = 0.0;
    for (long step = 0, first = 0; step < stepping.steps; ++step) {
        guess_impulses(step - first, work);
        if (take_step(rope, h, kept_half, state, scratch)) continue;
        if (!take_two_steps(rope, h / 2.0, std::sqrt(kept_half), most_halvings - 1, state, scratch)) {
            state.position = std::numeric_limits<double>::quiet_NaN();
            return;
        }
        first = step + 1;
    }
    keep_lengths_at_rest(state, scratch);
}

}  // namespace ropesim
