#include "simulation/leaps.h"

#include "simulation/bundle_steps.h"
#include "simulation/method.h"

#include <algorithm>
#include <array>
#include <cstddef>
#include <span>

namespace ropesim {
namespace {

bool moves(const Leap& leap) {
    return leap.kick != 0.0 || leap.drift != 0.0;
}

bool damps(const Leap& leap) {
    return leap.before != 1.0 || leap.after != 1.0 || leap.kept != 1.0;
}

std::span<const Leap> of_a_step(const Leaps& leaps) {
    return std::span(leaps.leaps).first(leaps.count);
}

bool damps(const Leaps& leaps) {
    const auto each = of_a_step(leaps);
    return damps(leaps.opening) ||
           std::any_of(each.begin(), each.end(), [](const Leap& leap) { return damps(leap); });
}

// Loops that need the accelerations.
long evaluations(const Leaps& leaps) {
    const auto each = of_a_step(leaps);
    return (leaps.opening.kick != 0.0 ? 1 : 0) +
           leaps.steps *
               std::count_if(each.begin(), each.end(), [](const Leap& leap) { return leap.kick != 0.0; });
}

// A loop over the masses: what goes by one and the same acceleration.
struct Stage {
    Leap first;
    Leap second;
};

// Stage j of the steps: the opening of the first step, where there is one; then every leap, the last of each
// step with the opening of the next.
Stage stage(const Leaps& leaps, long j) {
    const long opening = moves(leaps.opening) ? 1 : 0;
    if (j < opening) return {leaps.opening, {}};
    const auto count = static_cast<long>(leaps.count);
    const long leap = j - opening;
    const bool step_ends = leap % count == count - 1;
    const bool all_end = leap == count * leaps.steps - 1;
    return {leaps.leaps[static_cast<std::size_t>(leap % count)],
            step_ends && !all_end ? leaps.opening : Leap{}};
}

long stages(const Leaps& leaps) {
    return (moves(leaps.opening) ? 1 : 0) + static_cast<long>(leaps.count) * leaps.steps;
}

template <bool damped, class L>
void kick(const Leap& leap, const L& a, L& v) {
    v = damped ? leap.after * (leap.before * v + leap.kick * a) : v + leap.kick * a;
}

template <bool damped, class L>
void drift(const Leap& leap, L& x, L& v) {
    x = x + leap.drift * v;
    if (damped) v = leap.kept * v;
}

template <bool damped, int width>
void move(const Leap& leap, const VectorLanes<width>& a, VectorLanes<width>& x, VectorLanes<width>& v) {
    if (leap.kick != 0.0) {
        kick<damped>(leap, a.x, v.x);
        kick<damped>(leap, a.y, v.y);
    }
    if (leap.drift != 0.0) {
        drift<damped>(leap, x.x, v.x);
        drift<damped>(leap, x.y, v.y);
    }
}

template <bool damped, int width>
void move(const Stage& stage, const VectorLanes<width>& a, VectorLanes<width>& x, VectorLanes<width>& v) {
    move<damped>(stage.first, a, x, v);
    move<damped>(stage.second, a, x, v);
}

template <int width, bool side_by_side, bool damped>
void leap_through_memory(const Leaps& leaps, Bundle& bundle) {
    double* const x = bundle[Bundle::x];
    double* const y = bundle[Bundle::y];
    double* const vx = bundle[Bundle::vx];
    double* const vy = bundle[Bundle::vy];
    in_blocks<width>(
        bundle, stages(leaps), [&](long j, Eigen::Index begin, Eigen::Index end, ForcesBefore& before) {
            const auto leap_at = [=, now = stage(leaps, j)](Eigen::Index i, const VectorLanes<width>& a) {
                VectorLanes<width> position = load<width>(x + i, y + i);
                VectorLanes<width> velocity = load<width>(vx + i, vy + i);
                move<damped>(now, a, position, velocity);
                store(x + i, y + i, position);
                store(vx + i, vy + i, velocity);
            };
            if (stage(leaps, j).first.kick != 0.0)
                accelerate<width, side_by_side>(bundle, Bundle::x, begin, end, before, leap_at);
            else
                for (Eigen::Index i = begin; i < end; i += width) leap_at(i, {});
        });
}

// A rope of that many vectors stays in registers through all leaps.
template <int width, int vectors, bool damped>
void leap_in_registers(const Leaps& leaps, Bundle& bundle) {
    const SpringLanes<width> spring(bundle);
    const auto links = static_cast<std::size_t>(bundle.masses() - 1);
    std::array<Lanes<width>, vectors> weight;
    std::array<VectorLanes<width>, vectors> fall, v;
    std::array<VectorLanes<width>, vectors + 1> x, force_before;
    for (std::size_t i = 0; i < vectors; ++i) {
        weight[i] = load<width>(bundle[Bundle::weight] + i * width);
        fall[i] = load<width>(bundle[Bundle::fall_x] + i * width, bundle[Bundle::fall_y] + i * width);
        x[i] = load<width>(bundle[Bundle::x] + i * width, bundle[Bundle::y] + i * width);
        v[i] = load<width>(bundle[Bundle::vx] + i * width, bundle[Bundle::vy] + i * width);
    }
    for (long j = 0; j < stages(leaps); ++j) {
        const Stage now = stage(leaps, j);
        for (std::size_t i = 0; i < vectors; ++i)
            force_before[i + 1] = force_lanes(spring, link_lanes(x[i], shifted_down(x[i], x[i + 1])),
                                              static_cast<Eigen::Index>(links - i * width));
        for (std::size_t i = 0; i < vectors; ++i) {
            const VectorLanes<width>& force = force_before[i + 1];
            move<damped>(
                now, acceleration_lanes<width>(weight[i], force, shifted_up(force_before[i], force), fall[i]),
                x[i], v[i]);
        }
    }
    for (std::size_t i = 0; i < vectors; ++i) {
        store(bundle[Bundle::x] + i * width, bundle[Bundle::y] + i * width, x[i]);
        store(bundle[Bundle::vx] + i * width, bundle[Bundle::vy] + i * width, v[i]);
    }
}

template <int width, bool damped>
void leap_in_lanes(const Leaps& leaps, Bundle& bundle) {
    if (bundle.ropes() > 1) return leap_through_memory<width, true, damped>(leaps, bundle);
    if (bundle.masses() <= width) return leap_in_registers<width, 1, damped>(leaps, bundle);
    if (bundle.masses() <= 2 * width) return leap_in_registers<width, 2, damped>(leaps, bundle);
    leap_through_memory<width, false, damped>(leaps, bundle);
}

}  // namespace

void leap(const Leaps& leaps, Bundle& bundle, InstructionSet instructions, Cost& cost) {
    cost.evaluations += evaluations(leaps);
    in_lanes(instructions, [&](auto width) {
        damps(leaps) ? leap_in_lanes<width, true>(leaps, bundle) : leap_in_lanes<width, false>(leaps, bundle);
    });
}

void leap(const Leaps& leaps, const Rope& rope, State& state, Scratch& scratch) {
    Bundle& bundle = scratch.bundle;
    bundle.resize(rope.start.rows(), 1);
    bundle.put(rope, 0);
    bundle.put(state, 0, leaps.velocity_unit);
    leap(leaps, bundle, scratch.instructions, scratch.cost);
    bundle.take(state, 0, leaps.velocity_unit);
}

}  // namespace ropesim
