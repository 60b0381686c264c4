#include "simulation/methods/blanes_moan_6.h"

#include "simulation/chains.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ropesim {
namespace {

using Real = long double;

// The conditions of order 6 for x'' = f(x) on the kicks b at the times c that a splitting meets only by its
// coefficients (Hairer, Nørsett, Wanner: Solving ODEs I, 1993, II.14): sums over kicks of b c^p, and of
// b c^p times the inner sum of b (c - c) c^q, which the exact solution has as an integral.
TEST(BlanesMoan6, MeetsTheOrderConditions) {
    std::array<Real, 14> c{};
    Real end = 0;
    for (std::size_t i = 0; i < 14; ++i) c[i] = end += BlanesMoan6::drifts[i];
    EXPECT_NEAR(double(end + BlanesMoan6::drifts[14] - 1), 0.0, 1e-15);
    for (int p = 0; p <= 5; ++p) {
        Real sum = 0;
        for (std::size_t i = 0; i < 14; ++i) sum += BlanesMoan6::kicks[i] * std::pow(c[i], Real(p));
        EXPECT_NEAR(double(sum - Real(1) / (p + 1)), 0.0, 1e-14) << p;
    }
    for (int q = 0; q <= 3; ++q) {
        for (int p = 0; p + q <= 3; ++p) {
            Real sum = 0;
            for (std::size_t i = 0; i < 14; ++i) {
                Real inner = 0;
                for (std::size_t j = 0; j < i; ++j)
                    inner += BlanesMoan6::kicks[j] * (c[i] - c[j]) * std::pow(c[j], Real(q));
                sum += BlanesMoan6::kicks[i] * std::pow(c[i], Real(p)) * inner;
            }
            const Real expected = Real(1) / ((q + 1) * (q + 2) * (p + q + 3));
            EXPECT_NEAR(double(sum - expected), 0.0, 1e-14) << p << ' ' << q;
        }
    }
}

// Symmetry makes the odd orders vanish, so that order 5 is order 6.
TEST(BlanesMoan6, ReadsTheSameBackwards) {
    for (int i = 0; i < 15; ++i) EXPECT_EQ(BlanesMoan6::drifts[i], BlanesMoan6::drifts[14 - i]);
    for (int i = 0; i < 14; ++i) EXPECT_EQ(BlanesMoan6::kicks[i], BlanesMoan6::kicks[13 - i]);
}

// One mass on a spring, moving along it: linear, of frequency sqrt(k/m).
double growth(double h_omega, long steps) {
    Rope rope = straight_rope(2, {1.0, 0.0}, {0.0, 0.0});
    rope.stiffness = 1.0;
    rope.start(1, 0) += 1e-9;
    const Points end =
        positions_at(rope, find_method("blanes_moan_6"), {.steps = steps, .step_size = h_omega}, 1);
    return std::abs(end(1, 0) - 1.0) / 1e-9;
}

// The trace's minimum in the narrow band: sqrt(3.5e-7) = 0.06 % a step.
TEST(BlanesMoan6, GrowsSlowlyInANarrowBand) {
    EXPECT_NEAR(std::log(growth(3.1415, 16000) / growth(3.1415, 8000)) / 8000.0, 0.0006, 0.00005);
    EXPECT_LT(growth(3.14, 8000), 20.0);
    EXPECT_LT(growth(3.143, 8000), 20.0);
}

// Beyond the limit a single frequency may be bounded again; a rope has slower modes that are not.
TEST(BlanesMoan6, IsNotCalledStableBeyondItsGap) {
    const Method& method = find_method("blanes_moan_6");
    EXPECT_LT(growth(7.0, 200), 20.0);
    EXPECT_GT(growth(6.28, 200), 1e6);
    EXPECT_FALSE(method.stable(7.0, 1.0));
    EXPECT_TRUE(method.stable(6.149, 1.0));
    EXPECT_FALSE(method.stable(6.151, 1.0));
}

}  // namespace
}  // namespace ropesim
