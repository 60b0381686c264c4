#include "simulation/chains.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>

namespace ropesim {
namespace {

// Algorithm 1 of Macklin, Müller, Chentanez: XPBD, Motion in Games 2016, on three masses joined by two
// distance constraints of compliance α = 1/k, as written there, in absolute places; with damping before the
// prediction.
struct PlainXpbd {
    std::array<Eigen::Array2d, 3> x, v;
    std::array<double, 3> w;

    void step(double h, double kept, double l, double compliance, const Eigen::Array2d& gravity, int sweeps) {
        std::array<Eigen::Array2d, 3> p = x;
        for (std::size_t i = 0; i < 3; ++i)
            if (w[i] > 0.0) p[i] = x[i] + h * (kept * v[i]) + h * h * gravity;
        std::array<double, 2> lambda{};
        const double scaled = compliance / (h * h);
        for (int sweep = 0; sweep < sweeps; ++sweep)
            for (std::size_t j = 0; j < 2; ++j) {
                const Eigen::Array2d d = p[j + 1] - p[j];
                const double length = std::hypot(d.x(), d.y());
                const double change = (-(length - l) - scaled * lambda[j]) / (w[j] + w[j + 1] + scaled);
                lambda[j] += change;
                p[j] -= w[j] * change * d / length;
                p[j + 1] += w[j + 1] * change * d / length;
            }
        for (std::size_t i = 0; i < 3; ++i) {
            v[i] = (p[i] - x[i]) / h;
            x[i] = p[i];
        }
    }
};

TEST(Xpbd, IsThePapersToTheLetter) {
    for (const std::vector<Eigen::Index>& pinned : {std::vector<Eigen::Index>{0}, {}}) {
        Rope rope = straight_rope(3, {1.0, 0.0}, {0.25, -1.0});
        rope.start << 0.0, 0.0, 0.8, -0.6, 1.4, 0.2;
        rope.mass << 1.0, 2.0, 0.5;
        rope.rest_length = 0.8;
        rope.stiffness = 20.0;
        rope.damping = 0.3;
        rope.pinned = pinned;
        rope = finished(rope);
        const double h = 1.0 / 16;
        for (const int sweeps : {1, 3}) {
            PlainXpbd plain;
            for (Eigen::Index i = 0; i < 3; ++i) {
                plain.x[static_cast<std::size_t>(i)] = rope.start.row(i).transpose();
                plain.v[static_cast<std::size_t>(i)] = Eigen::Array2d::Zero();
                plain.w[static_cast<std::size_t>(i)] = rope.inverse_mass(i);
            }
            for (int step = 0; step < 32; ++step)
                plain.step(h, std::exp(-rope.damping * h), rope.rest_length, 1.0 / rope.stiffness,
                           rope.gravity, sweeps);
            const Points actual =
                positions_at(rope, find_method("xpbd"), {.steps = 32, .step_size = h, .sweeps = sweeps}, 1);
            for (Eigen::Index i = 0; i < 3; ++i) {
                EXPECT_NEAR(actual(i, 0), plain.x[static_cast<std::size_t>(i)].x(), 1e-12);
                EXPECT_NEAR(actual(i, 1), plain.x[static_cast<std::size_t>(i)].y(), 1e-12);
            }
        }
    }
}

}  // namespace
}  // namespace ropesim
