#include "simulation/bundle_steps.h"
#include "simulation/links.h"
#include "simulation/methods/methods.h"

#include <cmath>
#include <complex>

namespace ropesim {

namespace {

constexpr double weights[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
constexpr double nodes[3] = {0.5, 0.5, 1.0};  // of stages 1, 2, 3

// Fields beside those of the bundle, which are those at the start of a step; each of x and then of y.
enum Field {
    stage_place = Bundle::fields,
    stage_acceleration = stage_place + 2,
    field_count = stage_acceleration + 6
};

struct Step {
    double size;
    double damping;
};

// One coordinate of the masses.
struct Coordinate {
    double* x;
    double* v;
    double* stage_x;
    std::array<double*, 3> stage_a;  // of stages 0, 1, 2
};

// Stage s of a step for some masses, once their accelerations without damping are known. The velocities of
// the stages follow from their accelerations: to compute them again costs less than to keep them.
template <std::size_t s, class L>
void finish_stage(const Step& step, const L& undamped_a, const Coordinate& at, Eigen::Index i) {
    constexpr int width = sizeof(L) / sizeof(double);
    const L x = load<width>(at.x + i);
    std::array<L, s + 1> stage_v;
    std::array<L, s + 1> stage_a;
    stage_v[0] = load<width>(at.v + i);
    constexpr std::size_t first = s == 1 || s == 2 ? s - 1 : 0;  // of those that it needs
    for (std::size_t before = first; before < s; ++before) {
        stage_a[before] = load<width>(at.stage_a[before] + i);
        stage_v[before + 1] = stage_v[0] + nodes[before] * step.size * stage_a[before];
    }
    stage_a[s] = undamped_a;
    if (step.damping != 0.0) stage_a[s] = stage_a[s] - step.damping * stage_v[s];
    if constexpr (s < 3) {
        store(at.stage_a[s] + i, stage_a[s]);
        store(at.stage_x + i, x + nodes[s] * step.size * stage_v[s]);
    } else {
        L mean_v{};
        L mean_a{};
        for (std::size_t stage = 0; stage <= s; ++stage) {
            mean_v = mean_v + weights[stage] * stage_v[stage];
            mean_a = mean_a + weights[stage] * stage_a[stage];
        }
        store(at.x + i, x + step.size * mean_v);
        store(at.v + i, stage_v[0] + step.size * mean_a);
    }
}

// What takes stage s of a step for the masses from element i.
template <std::size_t s, int width, class Fields>
auto taker(const Step& step, Fields& fields) {
    const auto coordinate = [&](int axis) {
        const auto stage_a = [&](int stage) { return fields[stage_acceleration + 2 * stage + axis]; };
        return Coordinate{fields[Bundle::x + axis],
                          fields[Bundle::vx + axis],
                          fields[stage_place + axis],
                          {stage_a(0), stage_a(1), stage_a(2)}};
    };
    return [step, x = coordinate(0), y = coordinate(1)](Eigen::Index i, const VectorLanes<width>& a) {
        finish_stage<s>(step, a.x, x, i);
        finish_stage<s>(step, a.y, y, i);
    };
}

// Where the masses are at stage s.
constexpr int place(std::size_t s) {
    return s == 0 ? int(Bundle::x) : int(stage_place);
}

template <int width, Layout layout, std::size_t s>
void take_stage(const Step& step, Bundle& bundle, Eigen::Index begin, Eigen::Index end,
                ForcesBefore& before) {
    accelerate<width, layout>(bundle, place(s), begin, end, before, taker<s, width>(step, bundle));
}

template <int width, Layout layout>
void take_steps_in_blocks(const Step& step, long steps, Bundle& bundle) {
    in_blocks<width>(bundle, 4 * steps,
                     [&](long j, Eigen::Index begin, Eigen::Index end, ForcesBefore& before) {
                         switch (j % 4) {
                             case 0:
                                 return take_stage<width, layout, 0>(step, bundle, begin, end, before);
                             case 1:
                                 return take_stage<width, layout, 1>(step, bundle, begin, end, before);
                             case 2:
                                 return take_stage<width, layout, 2>(step, bundle, begin, end, before);
                             default:
                                 return take_stage<width, layout, 3>(step, bundle, begin, end, before);
                         }
                     });
}

template <int width>
void take_steps_round(const Step& step, long steps, Bundle& bundle) {
    constexpr Eigen::Index stages_apart = (place(1) - place(0)) * Bundle::short_pitch;
    const ShortFields fields(bundle);
    const Eigen::Index end = whole_vectors<width>(bundle);
    Pipeline<width, Layout::one_rope> pipeline(bundle, fields, place(0), 0);
    for (long j = 0; j < steps; ++j) {
        go_round(pipeline, end, taker<0, width>(step, fields), 0, stages_apart);
        go_round(pipeline, end, taker<1, width>(step, fields), stages_apart, stages_apart);
        go_round(pipeline, end, taker<2, width>(step, fields), stages_apart, stages_apart);
        go_round(pipeline, end, taker<3, width>(step, fields), stages_apart, 0);
    }
}

}  // namespace

// The classical Runge-Kutta method, on x' = v, v' = a(x) - damping v. Order 4, four evaluations a step; not
// symplectic: below its limit it loses energy, (h ω)^6/72 of a mode's in each step.
// Stable for h ω <= 2 sqrt(2) (undamped). Hairer, Nørsett, Wanner: Solving ODEs I, 1993, II.1.
void runge_kutta_4(const Rope& rope, const Stepping& stepping, State& state, Scratch& scratch) {
    const Step step{stepping.step_size, damping_per_step(rope, stepping) / stepping.step_size};
    Bundle& bundle = scratch.bundle;
    bundle.resize(rope.start.rows(), 1, field_count);
    bundle.put(rope, 0);
    bundle.put(state, 0);
    scratch.cost.evaluations += 4 * stepping.steps;
    in_lanes(scratch.instructions, [&](auto width) {
        if (bundle.masses() <= 2 * width)
            take_steps_in_blocks<width, Layout::few_masses>(step, stepping.steps, bundle);
        else if (goes_round<width, Layout::one_rope>(bundle))
            take_steps_round<width>(step, stepping.steps, bundle);
        else
            take_steps_in_blocks<width, Layout::one_rope>(step, stepping.steps, bundle);
    });
    bundle.take(state, 0);
}

// |1 + z + z²/2 + z³/6 + z⁴/24| <= 1 at both roots of z² + damping z + (h ω)² = 0.
bool runge_kutta_4_stable(double h_omega, double kept) {
    using Complex = std::complex<double>;
    const double damping = -std::log(kept);
    const Complex root = std::sqrt(Complex(damping * damping / 4.0 - h_omega * h_omega));
    for (const Complex z : {-damping / 2.0 + root, -damping / 2.0 - root})
        if (std::norm(1.0 + z * (1.0 + z / 2.0 * (1.0 + z / 3.0 * (1.0 + z / 4.0)))) > 1.0 + 1e-12)
            return false;
    return true;
}

}  // namespace ropesim
