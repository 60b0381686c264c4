#include "simulation/links.h"

#include <cmath>

namespace ropesim {
namespace {

// Stands for the square of a zero length, so that 0 * (rest length / length) is 0.
constexpr double shortest_squared = 1e-200;

}  // namespace

// Hooke's law, force of link i on mass i: k (1 - l/|d|) d with d = x[i+1] - x[i]. Row i + 1 of link_force is
// link i; the rows of zeros before the first and after the last link spare the ends a case of their own.
void accelerations(const Rope& rope, const Points& position, Points& link_force, Points& acceleration) {
    const Eigen::Index masses = position.rows();
    const double k = rope.stiffness;
    const double l = rope.rest_length;
    link_force.resize(masses + 1, 2);
    acceleration.resize(masses, 2);
    link_force.row(0) = 0.0;
    link_force.row(masses) = 0.0;

    const double* x = position.col(0).data();
    const double* y = position.col(1).data();
    double* force_x = link_force.col(0).data() + 1;
    double* force_y = link_force.col(1).data() + 1;
    for (Eigen::Index i = 0; i < masses - 1; ++i) {
        const double dx = x[i + 1] - x[i];
        const double dy = y[i + 1] - y[i];
        const double squared = dx * dx + dy * dy;
        const double length = std::sqrt(squared < shortest_squared ? shortest_squared : squared);
        const double pull = k * (1.0 - l / length);
        force_x[i] = pull * dx;
        force_y[i] = pull * dy;
    }
    for (int axis = 0; axis < 2; ++axis)
        acceleration.col(axis) =
            rope.inverse_mass * (link_force.col(axis).tail(masses) - link_force.col(axis).head(masses)) +
            rope.free_fall.col(axis);
}

void pull_to_rest_length(Points& position, Eigen::Index link, double rest_length, double first_share,
                         double second_share) {
    const double dx = position(link + 1, 0) - position(link, 0);
    const double dy = position(link + 1, 1) - position(link, 1);
    const double squared = dx * dx + dy * dy;
    if (squared == 0.0) return;
    const double excess = 1.0 - rest_length / std::sqrt(squared);
    position(link, 0) += first_share * excess * dx;
    position(link, 1) += first_share * excess * dy;
    position(link + 1, 0) -= second_share * excess * dx;
    position(link + 1, 1) -= second_share * excess * dy;
}

double velocity_kept(const Rope& rope, const Stepping& stepping) {
    return (1.0 - stepping.damping_factor) * decay(rope.damping * stepping.step_size);
}

// exp(-x) = exp(-x/2^n)^(2^n), the inner one by its Taylor series: 12 terms leave 1e-21 below 1/8.
double decay(double x) {
    int halvings = 0;
    for (; x > 0.125; x /= 2.0) ++halvings;
    double result = 1.0;
    for (int term = 12; term >= 1; --term) result = 1.0 - x / term * result;
    for (; halvings > 0; --halvings) result *= result;
    return result;
}

}  // namespace ropesim
