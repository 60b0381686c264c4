#include "study/link_angles.h"

#include <Eigen/Cholesky>
#include <Eigen/QR>

#include <algorithm>
#include <cmath>

namespace ropesim {

using Eigen::Index;

LinkAngles::LinkAngles(const Rope& rope) : rope_(rope), links_(rope.start.rows() - 1) {
    const Index masses = rope.start.rows();
    closing_ = rope.pinned;
    std::sort(closing_.begin(), closing_.end());
    if (!closing_.empty()) {
        base_ = closing_.front();
        closing_.erase(closing_.begin());
    }
    length_ = (rope.start.bottomRows(links_) - rope.start.topRows(links_)).square().rowwise().sum().sqrt();
    for (Index link = 0; link < links_; ++link)
        moved_.push_back(link < base_ ? Moved{0, link} : Moved{link + 1, masses - 1});
    if (rope.pinned.empty()) moved_.insert(moved_.end(), 2, Moved{0, masses - 1});
    mass_before_ = Eigen::ArrayXd::Zero(masses + 1);
    for (Index i = 0; i < masses; ++i) mass_before_(i + 1) = mass_before_(i) + rope.mass(i);
}

bool LinkAngles::moves(Index coordinate, Index mass) const {
    const Moved& moved = moved_[static_cast<std::size_t>(coordinate)];
    return moved.first <= mass && mass <= moved.last;
}

double LinkAngles::mass_moved_by_both(Index coordinate, Index other) const {
    const Moved& a = moved_[static_cast<std::size_t>(coordinate)];
    const Moved& b = moved_[static_cast<std::size_t>(other)];
    const Index first = std::max(a.first, b.first);
    const Index last = std::min(a.last, b.last);
    return first <= last ? mass_before_(last + 1) - mass_before_(first) : 0.0;
}

Eigen::VectorXd LinkAngles::start() const {
    Eigen::VectorXd q(static_cast<Index>(moved_.size()));
    for (Index link = 0; link < links_; ++link)
        q(link) = std::atan2(rope_.start(link + 1, 1) - rope_.start(link, 1),
                             rope_.start(link + 1, 0) - rope_.start(link, 0));
    if (rope_.pinned.empty()) q.tail(2) = rope_.start.row(0).transpose();
    return q;
}

// Column c: how each mass that coordinate c moves does so, dx/dq. Masses before the base are reached against
// the direction of the links.
Eigen::Matrix2Xd LinkAngles::directions(const Eigen::VectorXd& q) const {
    Eigen::Matrix2Xd result(2, q.size());
    for (Index link = 0; link < links_; ++link) {
        const double length = link < base_ ? -length_(link) : length_(link);
        result.col(link) << -length * std::sin(q(link)), length * std::cos(q(link));
    }
    if (rope_.pinned.empty()) result.rightCols<2>().setIdentity();
    return result;
}

// For each mass, the sum over the coordinates that move it.
Points LinkAngles::sum_outward(const Eigen::Matrix2Xd& of_coordinates) const {
    Points sum = Points::Zero(links_ + 1, 2);
    if (rope_.pinned.empty()) sum.row(0) = of_coordinates.rightCols<2>().rowwise().sum().transpose();
    for (Index i = base_ + 1; i <= links_; ++i)
        sum.row(i) = sum.row(i - 1) + of_coordinates.col(i - 1).transpose().array();
    for (Index i = base_; i > 0; --i)
        sum.row(i - 1) = sum.row(i) + of_coordinates.col(i - 1).transpose().array();
    return sum;
}

Points LinkAngles::position(const Eigen::VectorXd& q) const {
    const Eigen::Matrix2Xd direction = directions(q);
    Eigen::Matrix2Xd along(2, q.size());
    for (Index link = 0; link < links_; ++link) along.col(link) << direction(1, link), -direction(0, link);
    if (rope_.pinned.empty()) along.rightCols<2>() = q.tail<2>().asDiagonal();
    Points result = sum_outward(along);
    if (!rope_.pinned.empty()) result.rowwise() += rope_.start.row(base_);
    return result;
}

Points LinkAngles::velocity(const Eigen::VectorXd& q, const Eigen::VectorXd& speed) const {
    return sum_outward(directions(q) * speed.asDiagonal());
}

Eigen::MatrixXd LinkAngles::mass_matrix(const Eigen::Matrix2Xd& direction) const {
    const Index unknowns = direction.cols();
    Eigen::MatrixXd lower(unknowns, unknowns);
    for (Index c = 0; c < unknowns; ++c)
        for (Index other = c; other < unknowns; ++other)
            lower(other, c) = mass_moved_by_both(c, other) * direction.col(c).dot(direction.col(other));
    return lower;
}

// Jᵀ m (g - J' q'), by sums of the forces on all masses before mass i.
Eigen::VectorXd LinkAngles::generalised_force(const Eigen::Matrix2Xd& direction,
                                              const Points& centripetal) const {
    Points force_before = Points::Zero(links_ + 2, 2);
    for (Index i = 0; i <= links_; ++i)
        force_before.row(i + 1) =
            force_before.row(i) + rope_.mass(i) * (rope_.gravity.transpose() - centripetal.row(i));
    Eigen::VectorXd force(direction.cols());
    for (Index c = 0; c < direction.cols(); ++c) {
        const Moved& moved = moved_[static_cast<std::size_t>(c)];
        const Points on_moved = force_before.row(moved.last + 1) - force_before.row(moved.first);
        force(c) = direction.col(c).dot(on_moved.matrix().transpose().col(0));
    }
    return force;
}

Eigen::MatrixXd LinkAngles::closing_rows(const Eigen::Matrix2Xd& direction) const {
    Eigen::MatrixXd rows = Eigen::MatrixXd::Zero(2 * static_cast<Index>(closing_.size()), direction.cols());
    for (std::size_t pin = 0; pin < closing_.size(); ++pin)
        for (Index c = 0; c < direction.cols(); ++c)
            if (moves(c, closing_[pin])) rows.block<2, 1>(2 * static_cast<Index>(pin), c) = direction.col(c);
    return rows;
}

// A link between two pins makes one of its two closing rows idle, hence the decomposition that reveals ranks.
Eigen::VectorXd LinkAngles::acceleration(const Eigen::VectorXd& q, const Eigen::VectorXd& speed) const {
    const Eigen::Matrix2Xd direction = directions(q);
    // J' q': towards the inner mass of every link, its length times its angular velocity squared.
    Eigen::Matrix2Xd inward = Eigen::Matrix2Xd::Zero(2, q.size());
    for (Index link = 0; link < links_; ++link)
        inward.col(link) =
            speed(link) * speed(link) * Eigen::Vector2d(-direction(1, link), direction(0, link));
    const Points centripetal = sum_outward(inward);

    const Eigen::LLT<Eigen::MatrixXd> mass(mass_matrix(direction));
    Eigen::VectorXd result = mass.solve(generalised_force(direction, centripetal));
    if (!closing_.empty()) {
        constexpr double idle = 1e-12;  // share of the greatest pivot
        const Eigen::MatrixXd closing = closing_rows(direction);
        const Eigen::MatrixXd response = mass.solve(closing.transpose());
        Eigen::VectorXd missing = -closing * result;
        for (std::size_t pin = 0; pin < closing_.size(); ++pin)
            missing.segment<2>(2 * static_cast<Index>(pin)) -=
                centripetal.row(closing_[pin]).matrix().transpose();
        Eigen::CompleteOrthogonalDecomposition<Eigen::MatrixXd> multipliers;
        multipliers.setThreshold(idle);
        result += response * multipliers.compute(closing * response).solve(missing);
    }
    return result - rope_.damping * speed;
}

}  // namespace ropesim
