#include "simulation/bundle_steps.h"
#include "simulation/links.h"
#include "simulation/methods/methods.h"

#include <cmath>
#include <complex>
#include <type_traits>

namespace ropesim {

namespace {

constexpr double weights[4] = {1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0};
constexpr double nodes[3] = {0.5, 0.5, 1.0};  // of stages 1, 2, 3

// Fields beside those of the bundle, which are those at the start of a step; each of x and then of y: the
// acceleration of the last stage, and the weighted sums of velocities and accelerations up to it.
enum Field {
    acceleration = Bundle::fields,
    sum_v = acceleration + 2,
    sum_a = sum_v + 2,
    field_count = sum_a + 2
};

struct Step {
    double size;
    double damping;
};

// One coordinate of the masses of a bundle.
class Coordinate {
  public:
    // That of axis 0 or 1.
    Coordinate(Bundle& bundle, int axis)
        : x_(bundle[Bundle::x + axis]),
          v_(bundle[Bundle::vx + axis]),
          a_(bundle[acceleration + axis]),
          sum_v_(bundle[sum_v + axis]),
          sum_a_(bundle[sum_a + axis]) {}

    // Finishes stage s of a step for some masses, once their accelerations without damping are known; returns
    // where they are. Its velocities follow from the accelerations of the stage before: to compute them costs
    // less than to keep them.
    template <std::size_t s, bool damps, class L>
    L finish(const Step& step, const L& undamped_a, Eigen::Index i) const {
        constexpr int width = sizeof(L) / sizeof(double);
        const L x = load<width>(x_ + i);
        const L v = load<width>(v_ + i);
        L stage_v = v;
        L a_before;
        if constexpr (s > 0) {
            a_before = load<width>(a_ + i);
            stage_v = v + nodes[s - 1] * step.size * a_before;
        }
        L a = undamped_a;
        if constexpr (damps) a = a - step.damping * stage_v;
        L v_sum;
        L a_sum;
        if constexpr (s == 1) {
            v_sum = L{} + weights[0] * v + weights[1] * stage_v;
            a_sum = L{} + weights[0] * a_before + weights[1] * a;
        } else if constexpr (s > 1) {
            v_sum = load<width>(sum_v_ + i) + weights[s] * stage_v;
            a_sum = load<width>(sum_a_ + i) + weights[s] * a;
        }
        if constexpr (s == 3) {
            const L place = x + step.size * v_sum;
            store(x_ + i, place);
            store(v_ + i, v + step.size * a_sum);
            return place;
        } else {
            store(a_ + i, a);
            if constexpr (s > 0) {
                store(sum_v_ + i, v_sum);
                store(sum_a_ + i, a_sum);
            }
            return x + nodes[s] * step.size * stage_v;
        }
    }

  private:
    double* x_;
    double* v_;
    double* a_;
    double* sum_v_;
    double* sum_a_;
};

template <int width, bool damps>
void take_steps(const Step& step, long steps, Bundle& bundle) {
    const Loops<width, Layout::one_rope> loops(bundle);
    const Coordinate x(bundle, 0);
    const Coordinate y(bundle, 1);
    const auto part = [&](long j, Eigen::Index begin, Eigen::Index end, Edge<width>& edge) {
        const auto take_stage = [&](auto stage) {
            constexpr std::size_t s = stage;
            loops.accelerate(begin, end, edge, [=](Eigen::Index i, const VectorLanes<width>& a) {
                return VectorLanes<width>{x.finish<s, damps>(step, a.x, i), y.finish<s, damps>(step, a.y, i)};
            });
        };
        switch (j % 4) {
            case 0:
                return take_stage(std::integral_constant<std::size_t, 0>());
            case 1:
                return take_stage(std::integral_constant<std::size_t, 1>());
            case 2:
                return take_stage(std::integral_constant<std::size_t, 2>());
            default:
                return take_stage(std::integral_constant<std::size_t, 3>());
        }
    };
    in_blocks<width>(bundle, 4 * steps, part);
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
        if (step.damping != 0.0)
            take_steps<width, true>(step, stepping.steps, bundle);
        else
            take_steps<width, false>(step, stepping.steps, bundle);
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
