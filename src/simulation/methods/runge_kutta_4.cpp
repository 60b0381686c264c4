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
    stage_velocity = stage_place + 2,
    mean_velocity = stage_place + 4,
    mean_acceleration = stage_place + 6,
    field_count = stage_place + 8
};

struct Step {
    double size;
    double damping;
};

// One coordinate of some masses.
struct Coordinate {
    double* x;
    double* v;
    double* stage_x;
    double* stage_v;
    double* mean_v;
    double* mean_a;
};

// Stage s of a step, from what it has for acceleration without damping.
template <int s, class L>
void take_stage(const Step& step, L a, const Coordinate& at, Eigen::Index i) {
    constexpr int width = sizeof(L) / sizeof(double);
    const L v = load<width>((s == 0 ? at.v : at.stage_v) + i);
    if (step.damping != 0.0) a = a - step.damping * v;
    const L sum_v = (s == 0 ? L{} : load<width>(at.mean_v + i)) + weights[s] * v;
    const L sum_a = (s == 0 ? L{} : load<width>(at.mean_a + i)) + weights[s] * a;
    if constexpr (s < 3) {
        store(at.mean_v + i, sum_v);
        store(at.mean_a + i, sum_a);
        store(at.stage_x + i, load<width>(at.x + i) + nodes[s] * step.size * v);
        store(at.stage_v + i, load<width>(at.v + i) + nodes[s] * step.size * a);
    } else {
        store(at.x + i, load<width>(at.x + i) + step.size * sum_v);
        store(at.v + i, load<width>(at.v + i) + step.size * sum_a);
    }
}

template <int width, int s>
void take_stages(const Step& step, Bundle& bundle, Eigen::Index begin, Eigen::Index end,
                 ForcesBefore& before) {
    const auto coordinate = [&](int axis) {
        return Coordinate{bundle[Bundle::x + axis],     bundle[Bundle::vx + axis],
                          bundle[stage_place + axis],   bundle[stage_velocity + axis],
                          bundle[mean_velocity + axis], bundle[mean_acceleration + axis]};
    };
    const auto take = [step, x = coordinate(0), y = coordinate(1)](Eigen::Index i,
                                                                   const VectorLanes<width>& a) {
        take_stage<s>(step, a.x, x, i);
        take_stage<s>(step, a.y, y, i);
    };
    accelerate<width, false>(bundle, s == 0 ? int(Bundle::x) : int(stage_place), begin, end, before, take);
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
        in_blocks<width>(bundle, 4 * stepping.steps,
                         [&](long j, Eigen::Index begin, Eigen::Index end, ForcesBefore& before) {
                             switch (j % 4) {
                                 case 0:
                                     return take_stages<width, 0>(step, bundle, begin, end, before);
                                 case 1:
                                     return take_stages<width, 1>(step, bundle, begin, end, before);
                                 case 2:
                                     return take_stages<width, 2>(step, bundle, begin, end, before);
                                 default:
                                     return take_stages<width, 3>(step, bundle, begin, end, before);
                             }
                         });
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
