#include "simulation/methods/blanes_moan_4.h"

#include "simulation/chains.h"
#include "simulation/diagnostics.h"

#include <gtest/gtest.h>

#include <cmath>

namespace ropesim {
namespace {

// The conditions of order 4 for x'' = f(x), in the kicks b at the times c (Hairer, Nørsett, Wanner: Solving
// ODEs I, 1993, II.14, with the Nyström coefficients b[i] (c[j] - c[i]) that a splitting has).
TEST(BlanesMoan4, MeetsTheOrderConditions) {
    using Real = long double;
    const auto& b = BlanesMoan4::kicks;
    Real c[7] = {0};
    for (int i = 0; i < 6; ++i) c[i + 1] = c[i] + BlanesMoan4::drifts[i];
    Real sum = 0, sum_c = 0, sum_cc = 0, sum_ccc = 0, sum_a = 0, sum_ca = 0, sum_ac = 0;
    for (int i = 0; i < 7; ++i) {
        Real a = 0, ac = 0;
        for (int j = 0; j < i; ++j) {
            a += b[j] * (c[i] - c[j]);
            ac += b[j] * (c[i] - c[j]) * c[j];
        }
        sum += b[i];
        sum_c += b[i] * c[i];
        sum_cc += b[i] * c[i] * c[i];
        sum_ccc += b[i] * c[i] * c[i] * c[i];
        sum_a += b[i] * a;
        sum_ca += b[i] * c[i] * a;
        sum_ac += b[i] * ac;
    }
    constexpr double tolerance = 1e-15;
    EXPECT_NEAR(double(c[6] - 1), 0.0, tolerance);
    EXPECT_NEAR(double(sum - 1), 0.0, tolerance);
    EXPECT_NEAR(double(sum_c - Real(1) / 2), 0.0, tolerance);
    EXPECT_NEAR(double(sum_cc - Real(1) / 3), 0.0, tolerance);
    EXPECT_NEAR(double(sum_a - Real(1) / 6), 0.0, tolerance);
    EXPECT_NEAR(double(sum_ccc - Real(1) / 4), 0.0, tolerance);
    EXPECT_NEAR(double(sum_ca - Real(1) / 8), 0.0, tolerance);
    EXPECT_NEAR(double(sum_ac - Real(1) / 24), 0.0, tolerance);
}

// Symmetry makes the odd orders vanish, so that order 3 is order 4.
TEST(BlanesMoan4, ReadsTheSameBackwards) {
    for (int i = 0; i < 6; ++i) EXPECT_EQ(BlanesMoan4::drifts[i], BlanesMoan4::drifts[5 - i]);
    for (int i = 0; i < 7; ++i) EXPECT_EQ(BlanesMoan4::kicks[i], BlanesMoan4::kicks[6 - i]);
}

// Three of the five free coefficients are not set by the order but by the least error: their published
// digits.
TEST(BlanesMoan4, HasThePublishedCoefficients) {
    EXPECT_NEAR(BlanesMoan4::a1, 0.245298957184271, 5.1e-16);
    EXPECT_NEAR(BlanesMoan4::a2, 0.604872665711080, 5.1e-16);
    EXPECT_NEAR(BlanesMoan4::b1, 0.0829844064174052, 5.1e-16);
    EXPECT_NEAR(BlanesMoan4::b2, 0.396309801498368, 5.1e-16);
    EXPECT_NEAR(BlanesMoan4::b3, -0.0390563049223486, 5.1e-16);
}

// One mass on a spring, moving along it: linear, of frequency sqrt(k/m).
double growth(double h_omega, long steps) {
    Rope rope = straight_rope(2, {1.0, 0.0}, {0.0, 0.0});
    rope.stiffness = 1.0;
    rope.start(1, 0) += 1e-9;
    const Points end =
        positions_at(rope, find_method("blanes_moan_4"), {.steps = steps, .step_size = h_omega}, 1);
    return std::abs(end(1, 0) - 1.0) / 1e-9;
}

// The trace's minimum in the narrow band is at h ω = 3.166: sqrt(2 · 2.85e-6) = 0.24 % a step.
TEST(BlanesMoan4, GrowsSlowlyInANarrowBand) {
    EXPECT_NEAR(std::log(growth(3.166, 4000) / growth(3.166, 2000)) / 2000.0, 0.0024, 0.0001);
    EXPECT_LT(growth(3.16, 4000), 20.0);
    EXPECT_LT(growth(3.172, 4000), 20.0);
}

}  // namespace
}  // namespace ropesim
