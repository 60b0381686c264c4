// Whether a row's criterion of stability is that of the matrix by which its steps multiply an oscillator.
#include "simulation/every_method.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ropesim {
namespace {

struct StabilityLimit : testing::TestWithParam<Method> {};
INSTANTIATE_TEST_SUITE_P(Table, StabilityLimit, every_method(), row_name);

struct Matrix {
    double trace;
    double determinant;
};

// Of one step on (place - rest, velocity) of one mass on a spring of frequency 1, which moves along it and so
// linearly. The state is in the units of the step, so that large steps are as exact as small ones.
Matrix step_matrix(const Method& method, double h_omega, double kept) {
    Rope rope = straight_rope(2, {1.0, 0.0}, {0.0, 0.0});
    rope.stiffness = 1.0;
    rope = finished(rope);
    const Stepping step{.steps = 1, .step_size = h_omega, .damping_factor = 1.0 - kept};
    std::array<Eigen::Array2d, 2> columns;
    constexpr double amplitude = 0.01;  // the link stays clear of zero length
    for (std::size_t column = 0; column < 2; ++column) {
        State state = at_rest(rope);
        Scratch scratch;
        (column == 0 ? state.position : state.velocity)(1, 0) += amplitude;
        method.advance(rope, step, state, scratch);
        columns[column] = {(state.position(1, 0) - 1.0) / amplitude, state.velocity(1, 0) / amplitude};
    }
    return {columns[0].x() + columns[1].y(),
            columns[0].x() * columns[1].y() - columns[0].y() * columns[1].x()};
}

// Jury's criterion; the share by which the trace may pass it is what the splittings of Blanes and Moan say of
// their narrow bands, and rounding elsewhere.
bool bounded(const Method& method, double h_omega, double kept) {
    const Matrix matrix = step_matrix(method, h_omega, kept);
    const double band = method.name == "blanes_moan_4" ? 3e-6 : method.name == "blanes_moan_6" ? 2e-7 : 1e-13;
    return matrix.determinant < 1.0 + 1e-13 &&
           std::abs(matrix.trace) < (1.0 + matrix.determinant) * (1.0 + band);
}

// Where it first ceases to be so.
template <class Holds>
double end_of(const Holds& holds) {
    double low = 0.0;
    double high = 1.0 / 256;
    for (; high < 9.0 && holds(high); high += 1.0 / 256) low = high;
    for (int halving = 0; halving < 50; ++halving) {
        const double middle = 0.5 * (low + high);
        (holds(middle) ? low : high) = middle;
    }
    return low;
}

TEST_P(StabilityLimit, IsThatOfTheStepsMatrix) {
    const Method& method = GetParam();
    if (!method.stable) return;
    for (const double kept : {1.0, 0.999, 0.9, 0.6, 0.2}) {
        const double stated = end_of([&](double h_omega) { return method.stable(h_omega, kept); });
        const double actual = end_of([&](double h_omega) { return bounded(method, h_omega, kept); });
        // What 1e-13 in a determinant that touches 1 leaves open is its root; the narrow bands' allowance
        // moves the end by 2e-6.
        EXPECT_NEAR(stated, actual, 1e-6) << kept;
        if (kept == 1.0) {
            EXPECT_NEAR(method.stability_limit, actual, 3e-6);
        }
    }
}

}  // namespace
}  // namespace ropesim
