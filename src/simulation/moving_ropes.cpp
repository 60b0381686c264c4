#include "simulation/moving_ropes.h"

#include <algorithm>
#include <cstddef>
#include <tuple>
#include <utility>

namespace ropesim {
namespace {

// Longer ropes are as fast alone. By AVX-512 on a Zen 5, a spring and step takes 0.6 ns side by side at any
// length, alone 1.8 at 16 masses, 1.2 at 32, 0.7 at 64 and 0.6 at 128.
constexpr Eigen::Index most_masses = 64;

int ropes_in_a_vector() {
    return lanes(widest_instruction_set());
}

bool short_and_of_leaps(const MovingRope& rope) {
    return rope.method().leaps && rope.rope().start.rows() <= most_masses;
}

// Fewer are faster one after the other: a vector of ropes takes as long however many it holds (by the same
// figures, as long as 3 ropes of 16 masses, 4 of 32, 7 of 64).
Eigen::Index fewest_ropes(Eigen::Index masses) {
    return std::min<Eigen::Index>(ropes_in_a_vector(), 2 + masses / 12);
}

// What ropes side by side have in common.
auto kind(const MovingRope& rope) {
    return std::tuple(&rope.method(), rope.stepping(), rope.rope().start.rows(), rope.rope().damping);
}

}  // namespace

MovingRopes::MovingRopes(std::vector<MovingRope> ropes) : ropes_(std::move(ropes)) {
    std::vector<std::size_t> by_kind;
    for (std::size_t rope = 0; rope < ropes_.size(); ++rope)
        (short_and_of_leaps(ropes_[rope]) ? by_kind : alone_).push_back(rope);
    std::ranges::stable_sort(by_kind, {}, [&](std::size_t rope) { return kind(ropes_[rope]); });
    for (auto first = by_kind.begin(); first != by_kind.end();) {
        const auto most = std::min<std::ptrdiff_t>(ropes_in_a_vector(), by_kind.end() - first);
        const auto next = std::find_if(first, first + most, [&](std::size_t rope) {
            return kind(ropes_[rope]) != kind(ropes_[*first]);
        });
        if (next - first < fewest_ropes(ropes_[*first].rope().start.rows()))
            alone_.insert(alone_.end(), first, next);
        else
            side_by_side_.push_back({{first, next}, {}});
        first = next;
    }
    for (SideBySide& each : side_by_side_) {
        const MovingRope& first = ropes_[each.ropes.front()];
        each.leaps = first.method().leaps(first.rope(), first.stepping());
        each.bundle.resize(first.rope().start.rows(), ropes_in_a_vector(), fields(each.leaps));
        for (std::size_t lane = 0; lane < each.ropes.size(); ++lane)
            each.bundle.put(ropes_[each.ropes[lane]].rope(), static_cast<Eigen::Index>(lane));
        put_states(each);
    }
}

void MovingRopes::advance() {
    for (SideBySide& each : side_by_side_) advance(each);
    for (const std::size_t rope : alone_) ropes_[rope].advance();
}

void MovingRopes::put_states(SideBySide& side_by_side) const {
    for (std::size_t lane = 0; lane < side_by_side.ropes.size(); ++lane)
        side_by_side.bundle.put(ropes_[side_by_side.ropes[lane]].state(), static_cast<Eigen::Index>(lane),
                                side_by_side.leaps.velocity_unit);
}

void MovingRopes::advance(SideBySide& side_by_side) {
    Bundle& bundle = side_by_side.bundle;
    const Leaps& leaps = side_by_side.leaps;
    // The bundle has the states still, but for what the unit rounds off in a rope alone.
    if (leaps.velocity_unit != 1.0) put_states(side_by_side);
    Cost cost;
    leap(leaps, bundle, widest_instruction_set(), cost);
    for (std::size_t lane = 0; lane < side_by_side.ropes.size(); ++lane)
        ropes_[side_by_side.ropes[lane]].advance(bundle, static_cast<Eigen::Index>(lane), leaps, cost);
}

}  // namespace ropesim
