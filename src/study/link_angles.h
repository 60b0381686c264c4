#pragma once

#include "simulation/rope.h"

#include <vector>

namespace ropesim {

// The inextensible rope in generalised coordinates q: the angles of its links, so that their lengths cannot
// change, and, where nothing is pinned, the place of mass 0. The chain hangs from one pin, the first;
// a further pin is two equations on q, held by Lagrange multipliers on the level of accelerations.
class LinkAngles {
  public:
    explicit LinkAngles(const Rope& rope);

    // q at the start.
    Eigen::VectorXd start() const;

    // Where the masses are, and how fast they move, at q and q'.
    Points position(const Eigen::VectorXd& q) const;
    Points velocity(const Eigen::VectorXd& q, const Eigen::VectorXd& speed) const;

    // q'' from M q'' = Jᵀ m (g - J' q') - damping M q' + Cᵀ λ and C q'' = -C' q' - damping C q', where
    // J = dx/dq, M = Jᵀ m J, and C are the rows of J of the further pins.
    Eigen::VectorXd acceleration(const Eigen::VectorXd& q, const Eigen::VectorXd& speed) const;

  private:
    // Masses first to last move as one with a coordinate.
    struct Moved {
        Eigen::Index first;
        Eigen::Index last;
    };
    bool moves(Eigen::Index coordinate, Eigen::Index mass) const;
    double mass_moved_by_both(Eigen::Index coordinate, Eigen::Index other) const;
    Eigen::Matrix2Xd directions(const Eigen::VectorXd& q) const;
    Points sum_outward(const Eigen::Matrix2Xd& of_coordinates) const;
    Eigen::MatrixXd mass_matrix(const Eigen::Matrix2Xd& direction) const;
    Eigen::VectorXd generalised_force(const Eigen::Matrix2Xd& direction, const Points& centripetal) const;
    Eigen::MatrixXd closing_rows(const Eigen::Matrix2Xd& direction) const;

    const Rope& rope_;
    Eigen::Index links_;
    Eigen::Index base_ = 0;              // the mass that the others are counted from
    std::vector<Eigen::Index> closing_;  // pinned masses but the base
    Eigen::ArrayXd length_;              // of the links
    std::vector<Moved> moved_;           // by each coordinate
    Eigen::ArrayXd mass_before_;         // of all masses before mass i; one more than masses
};

}  // namespace ropesim
