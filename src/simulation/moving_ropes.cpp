#include "simulation/moving_ropes.h"

#include "simulation/leaps.h"

#include <algorithm>
#include <utility>

namespace ropesim {
namespace {

// Longer ropes are as fast alone. By AVX-512 on a Zen 5, a spring and step takes 0.6 ns side by side at any
// length, alone 1.8 at 16 masses, 1.2 at 32, 0.7 at 64 and 0.6 at 128.
constexpr Eigen::Index most_masses = 64;

std::size_t ropes_in_a_vector() {
    return static_cast<std::size_t>(lanes(widest_instruction_set()));
}

bool short_and_of_leaps(const MovingRope& rope) {
    return rope.method().leaps && rope.rope().start.rows() <= most_masses;
}

bool alike(const MovingRope& a, const MovingRope& b) {
    return &a.method() == &b.method() && a.stepping() == b.stepping() &&
           a.rope().start.rows() == b.rope().start.rows() && a.rope().damping == b.rope().damping;
}

}  // namespace

MovingRopes::MovingRopes(std::vector<MovingRope> ropes) : ropes_(std::move(ropes)) {
    for (std::size_t rope = 0; rope < ropes_.size(); ++rope)
        if (short_and_of_leaps(ropes_[rope]))
            put_side_by_side(rope);
        else
            alone_.push_back(rope);
    std::erase_if(side_by_side_, [&](const SideBySide& few) {
        if (few.ropes.size() > ropes_in_a_vector() / 2) return false;
        alone_.insert(alone_.end(), few.ropes.begin(), few.ropes.end());
        return true;
    });
    for (SideBySide& each : side_by_side_) {
        const MovingRope& first = ropes_[each.ropes.front()];
        each.leaps = first.method().leaps(first.rope(), first.stepping());
        each.bundle.resize(first.rope().start.rows(), lanes(widest_instruction_set()), fields(each.leaps));
        for (std::size_t lane = 0; lane < each.ropes.size(); ++lane)
            each.bundle.put(ropes_[each.ropes[lane]].rope(), static_cast<Eigen::Index>(lane));
        put_states(each);
    }
}

// Beside ropes like it, where there is room.
void MovingRopes::put_side_by_side(std::size_t rope) {
    const auto room = std::find_if(side_by_side_.begin(), side_by_side_.end(), [&](const SideBySide& each) {
        return each.ropes.size() < ropes_in_a_vector() && alike(ropes_[each.ropes.front()], ropes_[rope]);
    });
    if (room != side_by_side_.end())
        room->ropes.push_back(rope);
    else
        side_by_side_.push_back({{rope}, {}});
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
