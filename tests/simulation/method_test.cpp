#include "simulation/method.h"

#include "simulation/chains.h"
#include "simulation/diagnostics.h"
#include "simulation/simulate.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <cmath>
#include <numbers>
#include <stdexcept>
#include <string>

namespace ropesim {
namespace {

using testing::HasSubstr;

TEST(FindMethod, ListsTheKnownOnesWhereAskedForAnother) {
    EXPECT_EQ(find_method("stormer_verlet").order, 2);
    try {
        find_method("verlet");
        FAIL() << "accepted 'verlet'";
    } catch (const std::runtime_error& error) {
        for (const Method& method : methods()) EXPECT_THAT(error.what(), HasSubstr(std::string(method.name)));
    }
}

// Every row of the table goes through these.
class EveryMethod : public testing::TestWithParam<Method> {};

INSTANTIATE_TEST_SUITE_P(Table, EveryMethod, testing::ValuesIn(methods().begin(), methods().end()),
                         [](const auto& row) { return std::string(row.param.name); });

// Largest error at time 4 against an exact solution of the method's own model: a hanging chain of four
// let go at its natural length, whose longitudinal modes are harmonic, or a pendulum let go at 2 radians.
double error(const Method& method, double damping, long steps_per_frame) {
    const long frames = 4;
    if (method.model == Model::elastic) {
        Rope rope = straight_rope(4, {0.0, -1.0}, {0.0, -1.0});
        rope.stiffness = 9.0;
        rope.damping = damping;
        rope.mass << 1.0, 1.0, 2.0, 0.5;
        rope = finished(rope);
        const Points actual = positions_at(rope, method, stepping(1.0, steps_per_frame), frames);
        return (actual.col(1) - hanging_chain(rope, frames)).abs().maxCoeff();
    }
    const double angle = 2.0;
    Rope rope = straight_rope(2, {std::sin(angle), -std::cos(angle)}, {0.0, -1.0});
    const Points actual = positions_at(rope, method, stepping(1.0, steps_per_frame), frames);
    const double there = pendulum_angle(angle, 1.0, frames);
    return std::hypot(actual(1, 0) - std::sin(there), actual(1, 1) + std::cos(there));
}

// The order that halving the step shows, over a factor of four so that single crossings of zero do not
// count; at steps where errors are small enough to shrink evenly and large enough to stand above rounding.
double observed_order(const Method& method, double damping) {
    const long steps = method.order == 6 ? 4 : method.order == 4 ? 24 : 256;
    return std::log2(error(method, damping, steps) / error(method, damping, 4 * steps)) / 2.0;
}

TEST_P(EveryMethod, ConvergesAtItsOrder) {
    EXPECT_NEAR(observed_order(GetParam(), 0.0), GetParam().order, 0.15);
}

TEST_P(EveryMethod, ConvergesAtItsOrderWhenDamped) {
    if (GetParam().model == Model::inextensible) return;  // a damped pendulum has no closed form
    EXPECT_NEAR(observed_order(GetParam(), 0.3), GetParam().order, 0.15);
}

// A chain along its own line is linear, so the limit is sharp. Starts in its fastest mode.
double growth_along_the_chain(const Method& method, double share_of_limit, long steps) {
    const int masses = 8;
    Rope rope = straight_rope(masses, {1.0, 0.0}, {0.0, 0.0});
    const double fastest = greatest_frequency(rope);
    const double amplitude = 1e-9;
    for (int i = 1; i < masses; ++i)  // sin((2j-1) i π / (2n+1)), n = 7 free masses, j = 7
        rope.start(i, 0) += amplitude * std::sin(13.0 * i * std::numbers::pi / 15.0);
    const Stepping stepping{.steps = steps, .step_size = share_of_limit * method.stability_limit / fastest};
    const Points end = positions_at(rope, method, stepping, 1);
    return greatest_distance(straight_rope(masses, {1.0, 0.0}, {0.0, 0.0}).start, end) / amplitude;
}

TEST_P(EveryMethod, IsStableUpToItsLimitAndNoFurther) {
    const Method& method = GetParam();
    if (!std::isfinite(method.stability_limit) || method.stability_limit == 0.0) return;
    // The conserved ellipse is 1/sqrt(1 - 0.98²) = 5 long; beyond the limit, each step grows by 1.15 or more.
    EXPECT_LT(growth_along_the_chain(method, 0.98, 2000), 10.0);
    EXPECT_GT(growth_along_the_chain(method, 1.02, 200), 1e6);
}

// One mass on a spring along its line, started at amplitude 1e-9, damped: the greatest step that `stable`
// calls so, found by halving, is where the motion turns from shrinking to growing.
TEST_P(EveryMethod, IsStableUpToItsLimitAndNoFurtherWhenDamped) {
    const Method& method = GetParam();
    if (!method.stable) return;
    Rope rope = straight_rope(2, {1.0, 0.0}, {0.0, 0.0});
    rope.stiffness = 1.0;
    rope.damping = 0.05;
    rope.start(1, 0) += 1e-9;
    rope = finished(rope);
    double low = 1e-6;
    double high = 10.0;
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (low + high);
        (stable(rope, method, {.step_size = middle}) ? low : high) = middle;
    }
    const auto growth = [&](double share, long steps) {
        const Points end = positions_at(rope, method, {.steps = steps, .step_size = share * low}, 1);
        return std::abs(end(1, 0) - 1.0) / 1e-9;
    };
    // Explicit Euler grows slowest, by 0.01 (h ω)² a step.
    const long steps = std::lround(400.0 / (low * low)) + 200;
    EXPECT_LT(growth(0.98, steps), 10.0) << "limit " << low;
    EXPECT_FALSE(growth(1.02, steps) <= 10.0) << "limit " << low;  // nor where it overflows
}

// The stiff rope, 64 masses of 0.25 at k = 40000, at a thousand times the limit of the explicit methods: in
// such a step it falls a link's length. Nothing grows exponentially: the stretch of implicit midpoint, whose
// energy takes a random walk at such steps, grows as the square root of time (to 400 in 20,000 steps), that
// of the others not at all. Direct projection, which would have to find where all links have their length,
// says that it cannot.
TEST_P(EveryMethod, TakesAnyStepIfItSaysSo) {
    const Method& method = GetParam();
    if (method.stable) return;
    Rope rope = seed_rope(64);
    rope.mass = 0.25;
    rope.stiffness = 40000.0;
    rope = finished(rope);
    const double step = 1000.0 * 2.0 / greatest_frequency(rope);
    const Trajectory early = simulate(rope, method, stepping(step, 1), 200);
    const Trajectory late = simulate(rope, method, stepping(step, 1), 600);
    EXPECT_EQ(late.diverged.has_value(), method.name == "direct_projection");
    EXPECT_LT(late.summary.largest_stretch, 3.0 * early.summary.largest_stretch + 1e-9);
}

TEST_P(EveryMethod, HoldsAPinnedRopeStill) {
    Rope rope = seed_rope(5);
    rope.pinned = {4, 0, 1, 3, 2};
    rope = finished(rope);
    const Points end = positions_at(rope, GetParam(), stepping(1.0, 64), 3);
    EXPECT_TRUE((end == rope.start).all());
}

TEST_P(EveryMethod, KeepsEveryPinInItsPlace) {
    Rope rope = seed_rope(9);
    rope.pinned = {2, 8};
    rope = finished(rope);
    const Points end = positions_at(rope, GetParam(), stepping(1.0, 256), 5);
    for (const Eigen::Index pin : rope.pinned) EXPECT_TRUE((end.row(pin) == rope.start.row(pin)).all());
    EXPECT_GT(greatest_distance(rope.start, end), 1.0);
}

// Nothing pulls in a rope that falls as a whole: each mass takes the way of a single one. The three sums of
// h g over n steps are h² g n(n-1)/2, n(n+1)/2 and n²/2.
TEST_P(EveryMethod, FallsFreely) {
    const Method& method = GetParam();
    Rope rope = seed_rope(6);
    rope.pinned = {};
    rope.gravity = {0.5, -1.0};
    rope = finished(rope);
    const double steps = 10 * 64;
    const double h = 1.0 / 64;
    const double lag = method.order >= 2 ? 0.0 : method.name == "explicit_euler" ? -1.0 : 1.0;
    const double fallen = h * h * steps * (steps + lag) / 2.0;
    const Points end = positions_at(rope, method, stepping(1.0, 64), 10);
    for (Eigen::Index i = 0; i < 6; ++i) {
        EXPECT_NEAR(end(i, 0), rope.start(i, 0) + 0.5 * fallen, 1e-10);
        EXPECT_NEAR(end(i, 1), rope.start(i, 1) - fallen, 1e-10);
    }
}

// Damped to rest, each link carries the weight below it.
TEST_P(EveryMethod, HangsInEquilibriumInTheEnd) {
    const Method& method = GetParam();
    Rope rope = straight_rope(6, {0.6, -0.8}, {0.0, -1.0});
    rope.mass << 1.0, 1.0, 2.0, 1.0, 3.0, 0.5;
    rope.damping = 1.0;
    rope = finished(rope);
    const Points end = positions_at(rope, method, stepping(1.0, 1024), 300);
    double y = 0.0;
    for (Eigen::Index i = 1; i < 6; ++i) {
        const double stretch =
            method.model == Model::elastic ? rope.mass.tail(6 - i).sum() / rope.stiffness : 0.0;
        y -= 1.0 + stretch;
        // Sweeps leave each link longer by about what a step's fall, h² g = 1e-6, adds per sweep.
        const bool sweeps = method.model == Model::inextensible || method.name == "xpbd";
        EXPECT_NEAR(end(i, 1), y, sweeps ? 2e-3 : 1e-9) << i;
        EXPECT_NEAR(end(i, 0), 0.0, 1e-9) << i;
    }
}

// Symplectic methods keep the energy within a band; its width is of the method's order in the step.
TEST_P(EveryMethod, KeepsItsEnergyBoundedIfSymplectic) {
    const Method& method = GetParam();
    if (method.model != Model::elastic || !method.keeps.symplectic) return;
    const Rope rope = straight_rope(4, {0.0, -1.0}, {0.0, -1.0});
    State state = at_rest(rope);
    Scratch scratch;
    const double first = energy(rope, method.model, state).total();
    const auto worst_deviation = [&](long frames) {
        double worst = 0.0;
        for (long frame = 0; frame < frames; ++frame) {
            method.advance(rope, stepping(1.0, 64), state, scratch);
            worst = std::max(worst, std::abs(energy(rope, method.model, state).total() - first));
        }
        return worst;
    };
    const double early = worst_deviation(2000);
    const double late = worst_deviation(2000);
    // 1e-12 is rounding: implicit midpoint keeps all of a quadratic energy, as this one is.
    EXPECT_LT(late, 1.1 * early + 1e-12);
}

TEST(ExplicitEuler, GainsEnergyAtEveryStep) {
    const Rope rope = seed_rope(4);
    const Method& method = find_method("explicit_euler");
    for (const long steps : {256, 1024, 4096})
        EXPECT_GT(simulate(rope, method, stepping(1.0, steps), 20).summary.energy_drift(), 0.0) << steps;
}

TEST(ExplicitEuler, IsStableWhenDampedEnough) {
    const Rope rope = seed_rope(4);
    const Method& method = find_method("explicit_euler");
    EXPECT_FALSE(fewest_stable_steps(rope, method, 1.0, 0.0));
    // h² ω² < c with ω = 2 sqrt(k/m) cos(π/7), c = 0.00005 (three free masses)
    const double omega = 20.0 * std::cos(std::numbers::pi / 7.0);
    EXPECT_EQ(fewest_stable_steps(rope, method, 1.0, 0.00005), std::floor(omega / std::sqrt(0.00005)) + 1);
}

// T = 4 K(sin(θ/2)) / ω. A rope of two masses let go at 2 radians is back after a period.
TEST(Pendulum, SwingsInItsEllipticPeriod) {
    const double angle = 2.0;
    const double period = 4.0 * std::comp_ellint_1(std::sin(angle / 2.0));
    Rope rope = straight_rope(2, {std::sin(angle), -std::cos(angle)}, {0.0, -1.0});
    const Points inextensible =
        positions_at(rope, find_method("constraint_projection"), stepping(period, 1 << 19), 1);
    EXPECT_LT(greatest_distance(rope.start, inextensible), 1e-3);  // order 1, h = 1.6e-5
    // A spring of k = 1e6 in place of the rod stretches by m g / k.
    rope.stiffness = 1e6;
    const Points elastic = positions_at(rope, find_method("stormer_verlet"), stepping(period, 1 << 16), 1);
    EXPECT_LT(greatest_distance(rope.start, elastic), 1e-5);
}

// A taut chain plucked in its j-th transverse mode, of an amplitude so small that it is linear, is where it
// began after a period: ω = 2 sqrt(T / (m L)) sin(j π / (2 links)), T = k (L - l).
TEST(TautChain, VibratesInItsNormalModes) {
    const int links = 12;
    for (const int j : {1, 2, 5}) {
        Rope rope = straight_rope(links + 1, {1.0, 0.0}, {0.0, 0.0});
        rope.rest_length = 0.5;
        rope.pinned = {0, links};
        const double amplitude = 1e-6;
        for (int i = 1; i < links; ++i)
            rope.start(i, 1) = amplitude * std::sin(j * i * std::numbers::pi / links);
        rope = finished(rope);
        const double tension = rope.stiffness * 0.5;
        const double omega = 2.0 * std::sqrt(tension) * std::sin(j * std::numbers::pi / (2.0 * links));
        const double period = 2.0 * std::numbers::pi / omega;
        const Method& method = find_method("stormer_verlet");
        const Points half = positions_at(rope, method, stepping(period / 2.0, 4096), 1);
        const Points whole = positions_at(rope, method, stepping(period / 2.0, 4096), 2);
        EXPECT_LT((half.col(1) + rope.start.col(1)).abs().maxCoeff(), 1e-6 * amplitude) << j;
        EXPECT_LT((whole.col(1) - rope.start.col(1)).abs().maxCoeff(), 1e-6 * amplitude) << j;
    }
}

}  // namespace
}  // namespace ropesim
