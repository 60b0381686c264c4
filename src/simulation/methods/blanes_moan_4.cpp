#include "simulation/methods/blanes_moan_4.h"

#include "simulation/links.h"
#include "simulation/methods/methods.h"

#include <array>
#include <cmath>

namespace ropesim {
namespace {

struct Stage {
    double drift;  // units of time
    double kept;   // share of the velocity that is left after the drift
    double kick;   // units of time
};

std::array<Stage, 6> stages(double h, double damping) {
    std::array<Stage, 6> stages{};
    for (std::size_t i = 0; i < stages.size(); ++i) {
        const double share = BlanesMoan4::drifts[i];
        stages[i] = {share * h * mean_decay(share * damping), decay(share * damping),
                     BlanesMoan4::kicks[i + 1] * h};
    }
    return stages;
}

}  // namespace

// Blanes and Moan's splitting for separable second-order systems (Runge-Kutta-Nyström): seven kicks and six
// drifts, of which the last kick and the next step's first share their accelerations. Order 4, symplectic,
// symmetric, six evaluations a step.
//   v += b1 h a(x),   then six times   x += ai h v,   v += b(i+1) h a(x)
// Damping is exact in the drift, x' = v, v' = -damping v, which keeps the order: as in the undamped case
// the bracket of three kicks with a drift is zero.
Leaps blanes_moan_4(const Rope& rope, const Stepping& stepping) {
    const double h = stepping.step_size;
    const std::array<Stage, 6> six = stages(h, damping_per_step(rope, stepping));
    Leaps leaps{.opening = {.kick = BlanesMoan4::kicks[0] * h, .drift = six[0].drift},
                .steps = stepping.steps};
    for (std::size_t i = 0; i < six.size(); ++i)
        leaps.of_step.push_back({.before = six[i].kept,
                                 .kick = six[i].kick,
                                 .drift = i + 1 < six.size() ? six[i + 1].drift : 0.0});
    return leaps;
}

// Jury's criterion for the matrix that one step multiplies (ω x, v) by. Undamped it is |trace| < 2, which
// holds up to h ω = 5.0269 but for the band from 3.1634 to 3.1686: there the trace passes -2 by 6e-6 and an
// oscillator grows by 0.24 % a step at most. That band is counted as stable.
bool blanes_moan_4_stable(double h_omega, double kept) {
    if (h_omega > 6.0) return false;  // the islands of stability beyond are of no use
    const double damping = -std::log(kept);
    const std::array<Stage, 6> six = stages(1.0, damping);
    double trace = 0.0;
    for (int column = 0; column < 2; ++column) {
        double x = column == 0 ? 1.0 : 0.0;
        double v = column == 0 ? 0.0 : 1.0;
        v -= BlanesMoan4::kicks[0] * h_omega * x;
        for (const Stage& stage : six) {
            x += stage.drift * h_omega * v;
            v = stage.kept * v - stage.kick * h_omega * x;
        }
        trace += column == 0 ? x : v;
    }
    constexpr double band = 1.0 + 3e-6;
    return std::abs(trace) < (1.0 + kept) * band;
}

}  // namespace ropesim
