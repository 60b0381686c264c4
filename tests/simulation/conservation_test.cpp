// What each row says it keeps, it keeps to rounding; what it does not say, it does not keep.
#include "simulation/diagnostics.h"
#include "simulation/every_method.h"

#include <gtest/gtest.h>

#include <cmath>
#include <vector>

namespace ropesim {
namespace {

struct Conservation : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Table, Conservation, every_method(), row_name);

// Six unequal masses, bent, unpinned, in no gravity.
Rope thrown_rope() {
    Rope rope = straight_rope(6, {1.0, 0.0}, {0.0, 0.0});
    for (Eigen::Index i = 0; i < 5; ++i) {
        const double angle = 0.7 * static_cast<double>(i);
        rope.start(i + 1, 0) = rope.start(i, 0) + std::cos(angle);
        rope.start(i + 1, 1) = rope.start(i, 1) + std::sin(angle);
    }
    rope.mass << 1.0, 2.0, 0.5, 1.5, 1.0, 3.0;
    rope.stiffness = 9.0;
    rope.pinned = {};
    return finished(rope);
}

// Turning about a point beside the rope and flying off: motion that changes no link's length at first.
State thrown(const Rope& rope) {
    State state = at_rest(rope);
    state.velocity.col(0) = 0.5 - 0.4 * (rope.start.col(1) - 0.3);
    state.velocity.col(1) = -0.25 + 0.4 * (rope.start.col(0) + 0.2);
    return state;
}

Eigen::Array2d momentum(const Rope& rope, const State& state) {
    return {(rope.mass * state.velocity.col(0)).sum(), (rope.mass * state.velocity.col(1)).sum()};
}

double angular_momentum(const Rope& rope, const State& state) {
    return (rope.mass *
            (state.position.col(0) * state.velocity.col(1) - state.position.col(1) * state.velocity.col(0)))
        .sum();
}

State after(const Rope& rope, const Method& method, State state, long frames) {
    Scratch scratch;
    for (long frame = 0; frame < frames; ++frame) method.advance(rope, stepping(1.0, 64), state, scratch);
    return state;
}

// 20 frames of 64 steps leave rounding of 1e-12 at most, in quantities of the size of 10; what a method of
// order 4 does not keep is off by 1e-9 and more.
constexpr double rounding = 1e-11;

TEST_P(Conservation, OfMomentum) {
    const Rope rope = thrown_rope();
    const State end = after(rope, GetParam(), thrown(rope), 20);
    const double change = (momentum(rope, end) - momentum(rope, thrown(rope))).abs().maxCoeff();
    EXPECT_EQ(change < rounding, GetParam().keeps.momentum) << change;
}

TEST_P(Conservation, OfAngularMomentum) {
    const Rope rope = thrown_rope();
    const State end = after(rope, GetParam(), thrown(rope), 20);
    const double change = std::abs(angular_momentum(rope, end) - angular_momentum(rope, thrown(rope)));
    EXPECT_EQ(change < rounding, GetParam().keeps.angular_momentum) << change;
}

TEST_P(Conservation, OfTheWayBack) {
    Rope rope = thrown_rope();
    rope.pinned = {0};
    rope.gravity = {0.25, -1.0};
    rope = finished(rope);
    State state = after(rope, GetParam(), at_rest(rope), 5);
    state.velocity *= -1.0;
    const double missed = greatest_distance(rope.start, after(rope, GetParam(), state, 5).position);
    EXPECT_EQ(missed < rounding, GetParam().keeps.reversible) << missed;
}

struct Line {
    double slope;
    double slope_error;  // standard, from what the points are off the line
};

Line fitted_line(const std::vector<double>& y) {
    const auto count = static_cast<double>(y.size());
    double mean = 0.0;
    for (const double value : y) mean += value / count;
    double xx = 0.0;
    double xy = 0.0;
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double x = static_cast<double>(i) - (count - 1.0) / 2.0;
        xx += x * x;
        xy += x * (y[i] - mean);
    }
    const double slope = xy / xx;
    double off = 0.0;
    for (std::size_t i = 0; i < y.size(); ++i) {
        const double x = static_cast<double>(i) - (count - 1.0) / 2.0;
        off += std::pow(y[i] - mean - slope * x, 2);
    }
    return {slope, std::sqrt(off / (count - 2.0) / xx)};
}

// Means of the energy over a hundred stretches of 1000 frames: no slope beyond four standard errors, or what
// rounding may add up to, 1e-9 of the energy; the band they lie in stays as narrow as it began, and the swing
// is not over: less than half of the energy is lost that the rope would have lost hanging at rest.
TEST_P(Conservation, OfEnergyOver100000Frames) {
#ifndef NDEBUG
    GTEST_SKIP() << "takes minutes with sanitizers, which have nothing to find in it";
#endif
    const Method& method = GetParam();
    Rope rope = straight_rope(3, {std::sin(1.0), -std::cos(1.0)}, {0.0, -1.0});
    rope.stiffness = 25.0;
    rope = finished(rope);
    State state = at_rest(rope);
    Scratch scratch;
    const double first = energy(rope, method.model, state).total();
    const double swing = 3.0 * (1.0 - std::cos(1.0));
    std::vector<double> means;
    std::vector<double> bands;
    constexpr int frames = 1000;
    for (int stretch = 0; stretch < 100; ++stretch) {
        means.push_back(0.0);
        bands.push_back(0.0);
        for (int frame = 0; frame < frames; ++frame) {
            method.advance(rope, stepping(1.0, 16), state, scratch);
            const double drift = energy(rope, method.model, state).total() - first;
            means.back() += drift / frames;
            bands.back() = std::max(bands.back(), std::abs(drift));
        }
    }
    const Line line = fitted_line(means);
    const bool level = std::abs(line.slope) < 4.0 * line.slope_error + 1e-11 * std::abs(first);
    const bool within = bands.back() < 1.5 * bands.front() + 1e-9 && bands.back() < 0.5 * swing;
    EXPECT_EQ(level && within, method.keeps.symplectic)
        << "slope " << line.slope << " +- " << line.slope_error << " per stretch, band " << bands.front()
        << " to " << bands.back();
}

}  // namespace
}  // namespace ropesim
