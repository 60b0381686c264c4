#include "simulation/rope.h"

#include <cmath>
#include <stdexcept>
#include <string>

namespace ropesim {
namespace {

void require(bool holds, const std::string& message) {
    if (!holds) throw std::runtime_error(message);
}

void check(const Rope& rope) {
    const Eigen::Index masses = rope.start.rows();
    require(masses >= 2, "a rope needs at least 2 masses, found " + std::to_string(masses));
    require(rope.start.isFinite().all(), "a rope starts at finite coordinates");
    require(rope.mass.size() == masses, "a rope of " + std::to_string(masses) +
                                            " needs one mass for each, found " +
                                            std::to_string(rope.mass.size()));
    require(rope.mass.isFinite().all() && (rope.mass > 0.0).all(), "every mass is positive and finite");
    require(std::isfinite(rope.rest_length) && rope.rest_length > 0.0,
            "the rest length is positive and finite");
    for (const Eigen::Index pin : rope.pinned)
        require(0 <= pin && pin < masses, "no mass " + std::to_string(pin) + " to pin; a rope of " +
                                              std::to_string(masses) + " has 0 to " +
                                              std::to_string(masses - 1));
}

}  // namespace

Rope finished(Rope rope) {
    check(rope);
    rope.inverse_mass = rope.mass.inverse();
    rope.free_fall = rope.gravity.transpose().replicate(rope.mass.size(), 1);
    for (const Eigen::Index pin : rope.pinned) {
        rope.inverse_mass(pin) = 0.0;
        rope.free_fall.row(pin) = 0.0;
    }
    return rope;
}

State at_rest(const Rope& rope) {
    return {0.0, rope.start, Points::Zero(rope.start.rows(), 2)};
}

}  // namespace ropesim
