#include "simulation/links.h"

#include "simulation/lanes.h"

#include <cmath>
#include <limits>

namespace ropesim {

// Hooke's law, force of link i on mass i: k (1 - l/|d|) d with d = x[i+1] - x[i]. Row i + 1 of link_force is
// link i; the rows of zeros before the first and after the last link spare the ends a case of their own.
void accelerations(const Rope& rope, const double* position, double* acceleration, Scratch& scratch) {
    ++scratch.cost.evaluations;
    Points& link_force = scratch.link_force;
    const Eigen::Index masses = rope.mass.size();
    const double k = rope.stiffness;
    const double l = rope.rest_length;
    link_force.resize(masses + 1, 2);
    link_force.row(0) = 0.0;
    link_force.row(masses) = 0.0;

    const double* x = position;
    const double* y = position + masses;
    double* force_x = link_force.col(0).data() + 1;
    double* force_y = link_force.col(1).data() + 1;
    in_lanes(scratch.instructions, [=](auto) {
        for (Eigen::Index i = 0; i < masses - 1; ++i) {
            const double dx = x[i + 1] - x[i];
            const double dy = y[i + 1] - y[i];
            const double length = std::sqrt(dx * dx + dy * dy + shortest_squared);
            const double pull = k * (1.0 - l / length);
            force_x[i] = pull * dx;
            force_y[i] = pull * dy;
        }
    });
    for (int axis = 0; axis < 2; ++axis)
        Eigen::Map<Eigen::ArrayXd>(acceleration + axis * masses, masses) =
            rope.inverse_mass * (link_force.col(axis).tail(masses) - link_force.col(axis).head(masses)) +
            rope.free_fall.col(axis);
}

void accelerations(const Rope& rope, const Points& position, Scratch& scratch) {
    scratch.acceleration.resize(position.rows(), 2);
    accelerations(rope, position.data(), scratch.acceleration.data(), scratch);
}

Eigen::Array2d link_after(const Points& position, const Points& moved, Eigen::Index link) {
    return {(position(link + 1, 0) - position(link, 0)) + (moved(link + 1, 0) - moved(link, 0)),
            (position(link + 1, 1) - position(link, 1)) + (moved(link + 1, 1) - moved(link, 1))};
}

void pull_to_rest_length(const Points& position, Points& moved, Eigen::Index link, double rest_length,
                         double first_share, double second_share) {
    const Eigen::Array2d d = link_after(position, moved, link);
    const double squared = d.x() * d.x() + d.y() * d.y();
    if (squared == 0.0) return;
    const double excess = 1.0 - rest_length / std::sqrt(squared);
    moved.row(link) += first_share * excess * d.transpose();
    moved.row(link + 1) -= second_share * excess * d.transpose();
}

double velocity_kept(const Rope& rope, const Stepping& stepping) {
    return (1.0 - stepping.damping_factor) * decay(rope.damping * stepping.step_size);
}

// -log(1 - c) = 2 artanh(c / (2 - c)), after square roots have brought 1 - c near 1: 9 terms leave 1e-20.
double damping_per_step(const Rope& rope, const Stepping& stepping) {
    double c = stepping.damping_factor;
    if (c >= 1.0) return std::numeric_limits<double>::infinity();
    double scale = 2.0;
    for (double kept = 1.0 - c; c > 0.1; scale *= 2.0) {
        kept = std::sqrt(kept);
        c = 1.0 - kept;
    }
    const double s = c / (2.0 - c);
    double series = 0.0;
    for (int term = 17; term >= 1; term -= 2) series = 1.0 / term + s * s * series;
    return rope.damping * stepping.step_size + scale * s * series;
}

namespace {

constexpr double smallest = 0.125;  // up to it the series below leave 1e-21
constexpr double largest = 800.0;   // exp(-largest) is 0 in double

// How often x has to be halved to come to `smallest`; x is that then.
int halve(double& x) {
    int halvings = 0;
    for (; std::abs(x) > smallest; x /= 2.0) ++halvings;
    return halvings;
}

// The n-th sum of Taylor's series 1 - x/n (1 - x/(n+1) (1 - ...)): exp(-x) for n = 1, its mean for n = 2.
double taylor(double x, int n) {
    double result = 1.0;
    for (int term = n + 11; term >= n; --term) result = 1.0 - x / term * result;
    return result;
}

}  // namespace

// exp(-x) = exp(-x/2^n)^(2^n)
double decay(double x) {
    if (x == 0.0) return 1.0;  // without damping, at no cost
    if (x > largest) return 0.0;
    if (x < -largest) return std::numeric_limits<double>::infinity();
    const int halvings = halve(x);
    double result = taylor(x, 1);
    for (int n = 0; n < halvings; ++n) result *= result;
    return result;
}

// φ(2x) = φ(x) (1 + exp(-x)) / 2
double mean_decay(double x) {
    if (std::abs(x) > largest) return (1.0 - decay(x)) / x;
    const int halvings = halve(x);
    double result = taylor(x, 2);
    double kept = taylor(x, 1);
    for (int n = 0; n < halvings; ++n) {
        result *= 0.5 * (1.0 + kept);
        kept *= kept;
    }
    return result;
}

}  // namespace ropesim
