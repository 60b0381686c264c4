#include "simulation/chains.h"

#include <Eigen/Eigenvalues>

#include <cmath>
#include <numbers>
#include <vector>

namespace ropesim {

Rope straight_rope(int masses, const Eigen::Array2d& direction, const Eigen::Array2d& gravity) {
    Rope rope;
    rope.start.resize(masses, 2);
    for (int i = 0; i < masses; ++i) rope.start.row(i) = i * direction.transpose();
    rope.mass = Eigen::ArrayXd::Ones(masses);
    rope.pinned = {0};
    rope.gravity = gravity;
    return finished(rope);
}

Rope seed_rope(int masses) {
    Rope rope = straight_rope(masses, {-400.0 / (masses - 1), 0.0}, {0.0, -1.0});
    rope.start.col(1) = 200.0;
    rope.rest_length = 400.0 / (masses - 1);
    return finished(rope);
}

Eigen::ArrayXd hanging_chain(const Rope& rope, double time) {
    const Eigen::Index free = rope.start.rows() - 1;
    Eigen::MatrixXd stiffness = Eigen::MatrixXd::Zero(free, free);
    for (Eigen::Index i = 0; i < free; ++i) {
        stiffness(i, i) = rope.stiffness * (i + 1 < free ? 2.0 : 1.0);
        if (i > 0) stiffness(i, i - 1) = stiffness(i - 1, i) = -rope.stiffness;
    }
    const Eigen::VectorXd mass = rope.mass.tail(free);
    const Eigen::VectorXd natural = -rope.rest_length * Eigen::VectorXd::LinSpaced(free, 1.0, double(free));
    const Eigen::VectorXd equilibrium = natural + stiffness.llt().solve(mass * rope.gravity.y());
    const Eigen::GeneralizedSelfAdjointEigenSolver<Eigen::MatrixXd> modes(stiffness,
                                                                          mass.asDiagonal().toDenseMatrix());
    const Eigen::VectorXd displaced = rope.start.col(1).tail(free).matrix() - equilibrium;
    Eigen::VectorXd amplitude = modes.eigenvectors().transpose() * mass.asDiagonal() * displaced;
    for (Eigen::Index j = 0; j < free; ++j) {
        const double rate = rope.damping / 2.0;
        const double omega = std::sqrt(modes.eigenvalues()(j) - rate * rate);
        amplitude(j) *=
            std::exp(-rate * time) * (std::cos(omega * time) + rate / omega * std::sin(omega * time));
    }
    Eigen::ArrayXd y(rope.start.rows());
    y << 0.0, (equilibrium + modes.eigenvectors() * amplitude).array();
    return y;
}

namespace {

// sn(u, κ) by the descending Landen transformation (Abramowitz, Stegun 1964, 16.4).
double jacobi_sn(double u, double kappa) {
    std::vector<double> a{1.0};
    std::vector<double> c{kappa};
    for (double b = std::sqrt(1.0 - kappa * kappa); std::abs(c.back()) > 1e-16 * a.back();) {
        c.push_back((a.back() - b) / 2.0);
        const double mean = (a.back() + b) / 2.0;
        b = std::sqrt(a.back() * b);
        a.push_back(mean);
    }
    double phi = std::ldexp(a.back() * u, static_cast<int>(a.size()) - 1);
    for (std::size_t n = a.size() - 1; n > 0; --n) phi = (phi + std::asin(c[n] / a[n] * std::sin(phi))) / 2.0;
    return std::sin(phi);
}

}  // namespace

double pendulum_angle(double start, double omega, double time) {
    const double kappa = std::sin(start / 2.0);
    return 2.0 * std::asin(kappa * jacobi_sn(std::comp_ellint_1(kappa) - omega * time, kappa));
}

Points positions_at(const Rope& rope, const Method& method, const Stepping& stepping, long frames) {
    State state = at_rest(rope);
    Scratch scratch;
    for (long frame = 0; frame < frames; ++frame) method.advance(rope, stepping, state, scratch);
    return state.position;
}

}  // namespace ropesim
