#include "simulation/bundle.h"

#include <algorithm>

namespace ropesim {
namespace {

// The elements of one rope in a field.
template <class Double>
auto column(Double* field, Eigen::Index r, Eigen::Index masses, Eigen::Index ropes) {
    using Array = std::conditional_t<std::is_const_v<Double>, const Eigen::ArrayXd, Eigen::ArrayXd>;
    return Eigen::Map<Array, 0, Eigen::InnerStride<>>(field + r, masses, Eigen::InnerStride<>(ropes));
}

}  // namespace

// From one field to the next it is some pages and four cache lines, so that what is done with one element of
// all fields meets neither in the same lines of the cache nor in the twelve bits by which a processor tells
// whether it reads what it has just written.
void Bundle::resize(Eigen::Index masses, Eigen::Index ropes, int field_count) {
    constexpr Eigen::Index line = 8;
    constexpr Eigen::Index page = 64;
    const Eigen::Index needed = (masses * ropes + line - 1) / line + 3;
    const Eigen::Index lines = (needed - 4 + page - 1) / page * page + 4;
    masses_ = masses;
    ropes_ = ropes;
    field_count_ = field_count;
    pitch_ = lines * line;
    static_assert(short_pitch == (page + 4) * line);
    storage_.resize(static_cast<std::size_t>(lines * field_count));
}

void Bundle::clear(int field) {
    std::fill_n((*this)[field], pitch_, 0.0);
}

void Bundle::put(const Rope& rope, Eigen::Index r) {
    Bundle& bundle = *this;
    column(bundle[weight], r, masses_, ropes_) = rope.inverse_mass;
    column(bundle[fall_x], r, masses_, ropes_) = rope.free_fall.col(0);
    column(bundle[fall_y], r, masses_, ropes_) = rope.free_fall.col(1);
    stiffness[static_cast<std::size_t>(r)] = rope.stiffness;
    rest_length[static_cast<std::size_t>(r)] = rope.rest_length;
}

void Bundle::put(const State& state, Eigen::Index r, double unit) {
    Bundle& bundle = *this;
    column(bundle[x], r, masses_, ropes_) = state.position.col(0);
    column(bundle[y], r, masses_, ropes_) = state.position.col(1);
    column(bundle[vx], r, masses_, ropes_) = unit * state.velocity.col(0);
    column(bundle[vy], r, masses_, ropes_) = unit * state.velocity.col(1);
}

void Bundle::take(State& state, Eigen::Index r, double unit) const {
    const Bundle& bundle = *this;
    state.position.col(0) = column(bundle[x], r, masses_, ropes_);
    state.position.col(1) = column(bundle[y], r, masses_, ropes_);
    state.velocity.col(0) = column(bundle[vx], r, masses_, ropes_);
    state.velocity.col(1) = column(bundle[vy], r, masses_, ropes_);
    if (unit != 1.0) state.velocity /= unit;  // the usual unit costs no divisions
}

}  // namespace ropesim
