#include "simulation/diagnostics.h"

#include "simulation/link_impulses.h"
#include "simulation/links.h"

#include <algorithm>
#include <cmath>
#include <numeric>

namespace ropesim {
namespace {

// An expression, not an array; `position` must outlive it.
auto squared_link_lengths(const Points& position) {
    const Eigen::Index links = position.rows() - 1;
    const auto square = [&](Eigen::Index axis) {
        return (position.col(axis).tail(links) - position.col(axis).head(links)).square();
    };
    return square(0) + square(1);
}

Eigen::ArrayXd link_lengths(const Points& position) {
    return squared_link_lengths(position).sqrt();
}

double sum(const Eigen::ArrayXd& lengths) {
    double sum = 0.0;
    for (const double length : lengths) sum += length;
    return sum;
}

// Whether all squared frequencies are below `bound`: D M⁻¹ Dᵀ k - bound is negative definite, where D is
// the incidence of links and masses. Its tridiagonal has k (w[i] + w[i+1]) on and -k w[i+1] off the
// diagonal (w = 1/m); negative definite means that every pivot of its LDLᵀ is negative.
bool all_below(const Rope& rope, double bound) {
    const Eigen::ArrayXd weight = rope.stiffness * rope.inverse_mass;
    double pivot = weight(0) + weight(1) - bound;
    for (Eigen::Index link = 1; link + 1 < weight.size() && pivot < 0.0; ++link)
        pivot = weight(link) + weight(link + 1) - bound - weight(link) * weight(link) / pivot;
    return pivot < 0.0;
}

Energy energy(const Rope& rope, Model model, const State& state, const Eigen::ArrayXd& lengths) {
    Energy energy;
    for (Eigen::Index mass = 0; mass < state.position.rows(); ++mass) {
        const double m = rope.mass(mass);
        const double vx = state.velocity(mass, 0);
        const double vy = state.velocity(mass, 1);
        energy.kinetic += 0.5 * m * (vx * vx + vy * vy);
        energy.gravity -=
            m * (rope.gravity.x() * state.position(mass, 0) + rope.gravity.y() * state.position(mass, 1));
    }
    if (model == Model::inextensible) return energy;
    for (const double length : lengths) {
        const double extension = length - rope.rest_length;
        energy.spring += 0.5 * rope.stiffness * extension * extension;
    }
    return energy;
}

}  // namespace

Energy energy(const Rope& rope, Model model, const State& state) {
    return energy(rope, model, state, link_lengths(state.position));
}

double greatest_distance(const Points& expected, const Points& actual) {
    return (expected - actual).square().rowwise().sum().sqrt().maxCoeff();
}

double longest_link(const Points& position) {
    return std::sqrt(squared_link_lengths(position).maxCoeff());
}

bool is_rest_length(double rest_length, double length) {
    constexpr double tolerance = 1e-9;
    return std::abs(length - rest_length) <= tolerance * rest_length;
}

bool links_at_rest_length(const Rope& rope, const Points& position) {
    const Eigen::ArrayXd lengths = link_lengths(position);
    return std::all_of(lengths.begin(), lengths.end(),
                       [&](double length) { return is_rest_length(rope.rest_length, length); });
}

double rope_length(const Points& position) {
    return sum(link_lengths(position));
}

namespace {

// Of rods, by the lengths that they keep.
Eigen::ArrayXd tensions_of_rods(const Rope& rope, const State& state) {
    const Eigen::Index links = state.position.rows() - 1;
    const Points link = state.position.bottomRows(links) - state.position.topRows(links);
    const Points fall = rope.free_fall.bottomRows(links) - rope.free_fall.topRows(links);
    const Points turn = state.velocity.bottomRows(links) - state.velocity.topRows(links);
    Eigen::ArrayXd tension =
        link.col(0) * fall.col(0) + link.col(1) * fall.col(1) + turn.col(0).square() + turn.col(1).square();
    for (Eigen::Index i = 0; i < links; ++i)
        if (rope.inverse_mass(i) + rope.inverse_mass(i + 1) == 0.0) tension(i) = 0.0;
    LinkSystem system;
    solve_impulses(rope.inverse_mass, link, link, widest_instruction_set(), system, tension);
    return tension * rope.rest_length;
}

Eigen::ArrayXd tensions(const Rope& rope, Model model, const State& state, const Eigen::ArrayXd& lengths) {
    return model == Model::elastic ? rope.stiffness * (lengths - rope.rest_length)
                                   : tensions_of_rods(rope, state);
}

}  // namespace

Eigen::ArrayXd tensions(const Rope& rope, Model model, const State& state) {
    return tensions(rope, model, state, link_lengths(state.position));
}

Diagnostics diagnostics(const Rope& rope, Model model, const State& state) {
    const Eigen::ArrayXd lengths = link_lengths(state.position);
    return {energy(rope, model, state, lengths), lengths.maxCoeff() / rope.rest_length - 1.0,
            tensions(rope, model, state, lengths).maxCoeff(), sum(lengths)};
}

double greatest_frequency(const Rope& rope) {
    double low = 0.0;
    double high = 4.0 * rope.stiffness * rope.inverse_mass.maxCoeff() * (1.0 + 1e-12);
    if (high == 0.0) return 0.0;
    for (int halving = 0; halving < 60; ++halving) {
        const double middle = 0.5 * (low + high);
        (all_below(rope, middle) ? high : low) = middle;
    }
    return std::sqrt(high);
}

bool stable(const Rope& rope, const Method& method, const Stepping& stepping) {
    return !method.stable ||
           method.stable(stepping.step_size * greatest_frequency(rope), velocity_kept(rope, stepping));
}

std::optional<long> fewest_stable_steps(const Rope& rope, const Method& method, double frame_time,
                                        double damping_factor) {
    const double frequency = greatest_frequency(rope);
    const auto stable_at = [&](long steps) {
        Stepping each = stepping(frame_time, steps);
        each.damping_factor = damping_factor;
        return !method.stable || method.stable(each.step_size * frequency, velocity_kept(rope, each));
    };
    long high = 1;
    while (high < most_steps && !stable_at(high)) high = std::min(2 * high, most_steps);
    if (!stable_at(high)) return std::nullopt;
    long low = high / 2;  // not stable, or zero
    while (high - low > 1) {
        const long middle = std::midpoint(low, high);
        (stable_at(middle) ? high : low) = middle;
    }
    return high;
}

}  // namespace ropesim
