#pragma once

#include <Eigen/Core>

#include <vector>

namespace ropesim {

// One row per mass; column 0 is x, column 1 is y, each contiguous.
using Points = Eigen::ArrayX2d;

// What never changes while a rope moves. Link i joins mass i and mass i + 1.
struct Rope {
    Points start;                          // where the masses are at time 0, at rest; world units, masses×2
    Eigen::ArrayXd mass;                   // > 0, one per mass
    std::vector<Eigen::Index> pinned;      // masses that are held still; any order, no mass twice
    Eigen::Array2d gravity = {0.0, -1.0};  // acceleration
    double rest_length = 1.0;              // of every link; > 0, world units
    double stiffness = 100.0;              // of every link's spring: force per world unit of extension
    double damping = 0.0;                  // rate, per unit of time: every velocity decays as exp(-damping t)

    // Derived by `finished`: inverse masses and the acceleration of gravity, both zero at pinned masses.
    Eigen::ArrayXd inverse_mass;
    Points free_fall;
};

// What changes. Velocities are zero at pinned masses.
struct State {
    double time = 0.0;  // units of time
    Points position;    // world units, masses×2
    Points velocity;    // world units per unit of time, masses×2
};

// The rope with its derived members filled in. Throws std::runtime_error where a member is out of range:
// fewer than two masses, a mass or rest length that is not positive, a pin that does not exist.
Rope finished(Rope rope);

// The rope at time 0: at its start, at rest.
State at_rest(const Rope& rope);

}  // namespace ropesim
