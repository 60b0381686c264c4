#include "simulation/truth.h"

#include <Eigen/LU>

#include <cmath>
#include <functional>

namespace ropesim {
namespace {

using Real = long double;
using Vector = Eigen::Matrix<Real, Eigen::Dynamic, 1>;
using Matrix = Eigen::Matrix<Real, Eigen::Dynamic, Eigen::Dynamic>;
using Force = std::function<Vector(const Vector& q, const Vector& rate)>;

// x0, y0, x1, y1, ...
Vector spring_accelerations(const Rope& rope, const Vector& q) {
    const Eigen::Index masses = rope.start.rows();
    Vector force = Vector::Zero(q.size());
    for (Eigen::Index i = 0; i < masses; ++i) {
        force(2 * i) = rope.mass(i) * Real(rope.gravity.x());
        force(2 * i + 1) = rope.mass(i) * Real(rope.gravity.y());
    }
    for (Eigen::Index i = 0; i + 1 < masses; ++i) {
        const Real dx = q(2 * i + 2) - q(2 * i);
        const Real dy = q(2 * i + 3) - q(2 * i + 1);
        const Real length = std::hypot(dx, dy);
        const Real tension = rope.stiffness * (length - rope.rest_length);
        force(2 * i) += tension * dx / length;
        force(2 * i + 1) += tension * dy / length;
        force(2 * i + 2) -= tension * dx / length;
        force(2 * i + 3) -= tension * dy / length;
    }
    for (Eigen::Index i = 0; i < masses; ++i) force.segment(2 * i, 2) /= rope.mass(i);
    for (const Eigen::Index pin : rope.pinned) force.segment(2 * pin, 2).setZero();
    return force;
}

// Coordinates x0, y0, θ0, θ1, ...: mass j is at (x0, y0) + l Σ (cos θk, sin θk), k < j, and accelerates by
// B q'' + b. With the pins' reactions p: Σ m Bᵀ(B q'' + b - g) = Σ Bᵀp, and B q'' + b = 0 at pins.
Vector angle_accelerations(const Rope& rope, const Vector& q, const Vector& rate) {
    const Eigen::Index masses = rope.start.rows();
    const Eigen::Index size = q.size();
    const auto pins = static_cast<Eigen::Index>(rope.pinned.size());
    Matrix system = Matrix::Zero(size + 2 * pins, size + 2 * pins);
    Vector right = Vector::Zero(size + 2 * pins);
    Matrix B = Matrix::Zero(2, size);
    B(0, 0) = B(1, 1) = 1;
    Vector b = Vector::Zero(2);
    const Vector g = rope.gravity.matrix().cast<Real>();
    for (Eigen::Index j = 0; j < masses; ++j) {
        if (j > 0) {
            const Real l = rope.rest_length;
            const Real c = l * std::cos(q(j + 1));
            const Real s = l * std::sin(q(j + 1));
            B.col(j + 1) << -s, c;
            b(0) -= c * rate(j + 1) * rate(j + 1);
            b(1) -= s * rate(j + 1) * rate(j + 1);
        }
        system.topLeftCorner(size, size) += Real(rope.mass(j)) * B.transpose() * B;
        right.head(size) += Real(rope.mass(j)) * B.transpose() * (g - b);
        for (Eigen::Index p = 0; p < pins; ++p) {
            if (rope.pinned[static_cast<std::size_t>(p)] != j) continue;
            system.block(size + 2 * p, 0, 2, size) = B;
            system.block(0, size + 2 * p, size, 2) = B.transpose();
            right.segment(size + 2 * p, 2) = -b;
        }
    }
    return system.partialPivLu().solve(right).head(size);
}

void runge_kutta(const Force& force, Vector& q, Vector& rate, Real time, long steps) {
    const Real h = time / static_cast<Real>(steps);
    for (long step = 0; step < steps; ++step) {
        const Vector a1 = force(q, rate);
        const Vector v2 = rate + h / 2 * a1;
        const Vector a2 = force(q + h / 2 * rate, v2);
        const Vector v3 = rate + h / 2 * a2;
        const Vector a3 = force(q + h / 2 * v2, v3);
        const Vector v4 = rate + h * a3;
        const Vector a4 = force(q + h * v3, v4);
        q += h / 6 * (rate + 2 * v2 + 2 * v3 + v4);
        rate += h / 6 * (a1 + 2 * a2 + 2 * a3 + a4);
    }
}

Points from_angles(const Rope& rope, const Vector& q) {
    Points position(rope.start.rows(), 2);
    Real x = q(0);
    Real y = q(1);
    for (Eigen::Index j = 0; j < position.rows(); ++j) {
        if (j > 0) {
            x += rope.rest_length * std::cos(q(j + 1));
            y += rope.rest_length * std::sin(q(j + 1));
        }
        position.row(j) << static_cast<double>(x), static_cast<double>(y);
    }
    return position;
}

Points elastic_truth(const Rope& rope, double time, long steps) {
    const Eigen::Index masses = rope.start.rows();
    Vector q(2 * masses);
    for (Eigen::Index i = 0; i < masses; ++i) q.segment(2 * i, 2) << rope.start(i, 0), rope.start(i, 1);
    Vector rate = Vector::Zero(2 * masses);
    const auto force = [&](const Vector& at, const Vector& moving) -> Vector {
        return spring_accelerations(rope, at) - rope.damping * moving;
    };
    runge_kutta(force, q, rate, time, steps);
    Points position(masses, 2);
    for (Eigen::Index i = 0; i < masses; ++i)
        position.row(i) << static_cast<double>(q(2 * i)), static_cast<double>(q(2 * i + 1));
    return position;
}

// Damping, a force -damping m v on every mass, is -damping q' in whatever coordinates.
Points inextensible_truth(const Rope& rope, double time, long steps) {
    const Eigen::Index masses = rope.start.rows();
    Vector q(masses + 1);
    q(0) = rope.start(0, 0);
    q(1) = rope.start(0, 1);
    for (Eigen::Index i = 0; i + 1 < masses; ++i)
        q(i + 2) = std::atan2(Real(rope.start(i + 1, 1)) - rope.start(i, 1),
                              Real(rope.start(i + 1, 0)) - rope.start(i, 0));
    Vector rate = Vector::Zero(masses + 1);
    const auto force = [&](const Vector& at, const Vector& moving) -> Vector {
        return angle_accelerations(rope, at, moving) - rope.damping * moving;
    };
    runge_kutta(force, q, rate, time, steps);
    return from_angles(rope, q);
}

}  // namespace

Points truth(const Rope& rope, Model model, double time, long steps) {
    const long all = std::lround(time * static_cast<double>(steps));
    return model == Model::elastic ? elastic_truth(rope, time, all) : inextensible_truth(rope, time, all);
}

}  // namespace ropesim
