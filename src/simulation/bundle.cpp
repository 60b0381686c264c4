#include "simulation/bundle.h"

#include <algorithm>

namespace ropesim {

// From one field to the next it is an odd number of times four cache lines, so that what is done with one
// element of up to sixteen fields meets neither in the same lines of the cache (64 sets) nor in the twelve
// bits by which a processor tells whether it reads what it has just written.
void Bundle::resize(Eigen::Index masses, Eigen::Index ropes, int field_count) {
    constexpr Eigen::Index line = 8;
    const Eigen::Index needed = (masses * ropes + line - 1) / line + 3;
    const Eigen::Index lines = (needed + 3) / 8 * 8 + 4;
    masses_ = masses;
    ropes_ = ropes;
    field_count_ = field_count;
    pitch_ = lines * line;
    storage_.resize(static_cast<std::size_t>(lines * field_count));
}

void Bundle::clear(int field) {
    std::fill_n((*this)[field], pitch_, 0.0);
}

// A rope alone is copied as a whole, by the widest instructions; what is stored in narrower ones cannot be
// read in whole vectors before it has reached the cache.
void Bundle::put(const double* column, int field, Eigen::Index r, double unit) {
    double* const to = (*this)[field];
    if (ropes_ == 1 && unit == 1.0)
        std::copy_n(column, masses_, to);
    else
        for (Eigen::Index i = 0; i < masses_; ++i) to[i * ropes_ + r] = unit * column[i];
}

void Bundle::take(double* column, int field, Eigen::Index r) const {
    const double* const from = (*this)[field];
    if (ropes_ == 1)
        std::copy_n(from, masses_, column);
    else
        for (Eigen::Index i = 0; i < masses_; ++i) column[i] = from[i * ropes_ + r];
}

void Bundle::put(const Rope& rope, Eigen::Index r) {
    put(rope.inverse_mass.data(), weight, r);
    put(rope.free_fall.col(0).data(), fall_x, r);
    put(rope.free_fall.col(1).data(), fall_y, r);
    stiffness[static_cast<std::size_t>(r)] = rope.stiffness;
    rest_length[static_cast<std::size_t>(r)] = rope.rest_length;
}

void Bundle::put(const State& state, Eigen::Index r, double unit) {
    put(state.position.col(0).data(), x, r);
    put(state.position.col(1).data(), y, r);
    put(state.velocity.col(0).data(), vx, r, unit);
    put(state.velocity.col(1).data(), vy, r, unit);
}

void Bundle::take(State& state, Eigen::Index r, double unit) const {
    take(state.position.col(0).data(), x, r);
    take(state.position.col(1).data(), y, r);
    take(state.velocity.col(0).data(), vx, r);
    take(state.velocity.col(1).data(), vy, r);
    if (unit != 1.0) state.velocity /= unit;  // the usual unit costs no divisions
}

}  // namespace ropesim
