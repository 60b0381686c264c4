#include "simulation/methods/blanes_moan_6.h"

#include "simulation/links.h"
#include "simulation/methods/methods.h"

#include <array>
#include <cmath>

namespace ropesim {
namespace {

struct Stage {
    double drift;  // units of time
    double kept;   // share of the velocity that is left after the drift
    double kick;   // units of time; 0 after the last drift
};

std::array<Stage, 15> stages(double h, double damping) {
    std::array<Stage, 15> stages{};
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const double share = BlanesMoan6::drifts[i];
        stages[i] = {share * h * mean_decay(share * damping), decay(share * damping),
                     i < 14 ? BlanesMoan6::kicks[i] * h : 0.0};
    }
    return stages;
}

}  // namespace

// Blanes and Moan's splitting of order 6 for separable second-order systems (Runge-Kutta-Nyström): fifteen
// drifts and fourteen kicks. Symplectic, symmetric, fourteen evaluations a step.
//   fourteen times   x += ai h v,   v += bi h a(x),   and   x += a1 h v
// Damping is exact in the drift, as in blanes_moan_4. Sums are compensated where there is none: over 120
// frames of the seed's rope rounding would come to 1e-6 pixels, as the motion magnifies it, and comes to
// 4e-9.
Leaps blanes_moan_6(const Rope& rope, const Stepping& stepping) {
    const std::array<Stage, 15> all = stages(stepping.step_size, damping_per_step(rope, stepping));
    Leaps leaps{.opening = {.drift = all[0].drift}, .steps = stepping.steps, .compensated = true};
    for (std::size_t i = 0; i + 1 < all.size(); ++i)
        leaps.of_step.push_back({.before = all[i].kept, .kick = all[i].kick, .drift = all[i + 1].drift});
    leaps.of_step.back().kept = all.back().kept;
    return leaps;
}

namespace {

// Jury's criterion for the matrix that one step multiplies (ω x, v) by.
bool bounded(double h_omega, double kept) {
    double trace = 0.0;
    const std::array<Stage, 15> all = stages(1.0, -std::log(kept));
    for (int column = 0; column < 2; ++column) {
        double x = column == 0 ? 1.0 : 0.0;
        double v = column == 0 ? 0.0 : 1.0;
        for (const Stage& stage : all) {
            x += stage.drift * h_omega * v;
            v = stage.kept * v - stage.kick * h_omega * x;
        }
        trace += column == 0 ? x : v;
    }
    constexpr double band = 1.0 + 2e-7;
    return std::abs(trace) < (1.0 + kept) * band;
}

}  // namespace

// Undamped |trace| < 2 holds up to h ω = 6.1500 but for the band from 3.1409 to 3.1422: there the trace
// passes -2 by 4e-7 and an oscillator grows by 0.06 % a step at most. That band is counted as stable. From
// 6.1500 to 6.4145 the trace passes 2 by up to 0.018 and then holds again up to 8.69: of use only where
// damping closes that gap, since a rope has slower modes too.
bool blanes_moan_6_stable(double h_omega, double kept) {
    constexpr double middle_of_gap = 6.282;
    constexpr double beyond_all = 9.0;
    if (h_omega > beyond_all) return false;
    return bounded(h_omega, kept) && (h_omega < middle_of_gap || bounded(middle_of_gap, kept));
}

}  // namespace ropesim
