#pragma once

#include "simulation/bundle.h"
#include "simulation/lanes.h"
#include "simulation/links.h"

#include <algorithm>
#include <array>
#include <cmath>

// The loops over the masses of a bundle that the explicit methods go through: the acceleration of each mass,
// and what a method does with it. To be called from `in_lanes`.
namespace ropesim {

// A vector of the plane in each lane.
template <int width>
struct VectorLanes {
    Lanes<width> x{};
    Lanes<width> y{};
};

template <int width>
VectorLanes<width> load(const double* x, const double* y) {
    return {load<width>(x), load<width>(y)};
}

template <int width>
void store(double* x, double* y, const VectorLanes<width>& lanes) {
    store(x, lanes.x);
    store(y, lanes.y);
}

template <int width>
VectorLanes<width> shifted_up(const VectorLanes<width>& before, const VectorLanes<width>& lanes) {
    return {shifted_up<width>(before.x, lanes.x), shifted_up<width>(before.y, lanes.y)};
}

template <int width>
VectorLanes<width> shifted_down(const VectorLanes<width>& lanes, const VectorLanes<width>& after) {
    return {shifted_down<width>(lanes.x, after.x), shifted_down<width>(lanes.y, after.y)};
}

// A link in each lane: the vector from its mass to the next, and its length.
template <int width>
struct LinkLanes {
    VectorLanes<width> d;
    Lanes<width> squared{};
    Lanes<width> length{};
};

template <int width>
LinkLanes<width> link_lanes(const VectorLanes<width>& from, const VectorLanes<width>& to) {
    const Lanes<width> dx = to.x - from.x;
    const Lanes<width> dy = to.y - from.y;
    const Lanes<width> squared = dx * dx + dy * dy;
    return {{dx, dy}, squared, square_root(squared)};
}

// Of the springs of a bundle, in each lane.
template <int width>
struct SpringLanes {
    Lanes<width> stiffness;
    Lanes<width> rest_length;
    Lanes<width> shortest_pull;  // of a link that has no length

    explicit SpringLanes(const Bundle& bundle)
        : stiffness(bundle.ropes() == 1 ? Lanes<width>{} + bundle.stiffness[0]
                                        : load<width>(bundle.stiffness.data())),
          rest_length(bundle.ropes() == 1 ? Lanes<width>{} + bundle.rest_length[0]
                                          : load<width>(bundle.rest_length.data())),
          shortest_pull(stiffness * (1.0 - rest_length / std::sqrt(shortest_squared))) {}
};

// Hooke's law, the pull of a link for each unit of its length: k (1 - l/|d|). Which of them have no length is
// known before the square root is; that is asked last, so that nothing waits for it.
template <int width>
Lanes<width> pull_lanes(const SpringLanes<width>& spring, const LinkLanes<width>& link) {
    const Lanes<width> pull = spring.stiffness * (1.0 - spring.rest_length / link.length);
    return link.squared < shortest_squared ? spring.shortest_pull : pull;
}

// Force of a link on the mass that it starts from; zero from lane `count` on.
template <int width>
VectorLanes<width> force_lanes(const Lanes<width>& pull, const VectorLanes<width>& d, Eigen::Index count) {
    const VectorLanes<width> force{pull * d.x, pull * d.y};
    if (count >= width) return force;
    const auto exists = numbers<width>() < static_cast<double>(count);
    return {exists ? force.x : Lanes<width>{}, exists ? force.y : Lanes<width>{}};
}

// a = w (f - f of the link before) + fall.
template <int width>
VectorLanes<width> acceleration_lanes(const Lanes<width>& weight, const VectorLanes<width>& force,
                                      const VectorLanes<width>& force_before,
                                      const VectorLanes<width>& fall) {
    return {weight * (force.x - force_before.x) + fall.x, weight * (force.y - force_before.y) + fall.y};
}

// The last forces before a place in a bundle, lanes x and then y, for the loop that goes on from there.
using ForcesBefore = std::array<double, std::size_t{2} * Bundle::most_ropes>;

// Where the masses are that come after those of a vector. Of ropes side by side, one vector further. Of one
// rope, one element further; of one with `few` masses, which have just been moved, by shifting whole vectors,
// since a processor reads what it has not yet written out only as it was stored.
enum class Layout { side_by_side, one_rope, few_masses };

// The fields of a short bundle: a constant apart, so that one register says where all of them are.
class ShortFields {
  public:
    explicit ShortFields(Bundle& bundle) : first_(bundle[0]) {}
    double* operator[](int field) const { return first_ + field * Bundle::short_pitch; }

  private:
    double* first_;
};

// The accelerations of the masses of a bundle, one vector after the other. While a vector moves, the division
// for the next and the square root for the one after that are under way (software pipelining; Lam: Software
// Pipelining, PLDI 1988); one after the other, they take longer than a processor sees ahead.
template <int width, Layout layout>
class Pipeline {
  public:
    // From element `begin` on, of masses that are where fields `place` and `place` + 1 say.
    template <class Fields>
    Pipeline(const Bundle& bundle, const Fields& fields, int place, Eigen::Index begin)
        : spring_(bundle),
          links_((bundle.masses() - 1) * next),
          x_(fields[place]),
          y_(fields[place + 1]),
          weight_(fields[Bundle::weight]),
          fall_x_(fields[Bundle::fall_x]),
          fall_y_(fields[Bundle::fall_y]),
          link_(link_from(begin)),
          pull_(pull_lanes(spring_, link_)),
          link_after_(link_from(begin + width)) {}

    // Calls move(i, a) with the accelerations of the masses from element i, which is the next. `move` may
    // move them: the links after them have been measured by then. Begins with the link from element `third`.
    template <class Move>
    void advance(Eigen::Index i, Eigen::Index third, const Move& move) {
        const LinkLanes<width> third_link = link_from(third);
        const Lanes<width> pull_after = pull_lanes(spring_, link_after_);
        const VectorLanes<width> force = force_lanes<width>(pull_, link_.d, links_ - i);
        const VectorLanes<width> before = side_by_side ? force_before : shifted_up(force_before, force);
        move(i, acceleration_lanes<width>(load<width>(weight_ + i), force, before,
                                          load<width>(fall_x_ + i, fall_y_ + i)));
        force_before = force;
        link_ = link_after_;
        pull_ = pull_after;
        link_after_ = third_link;
    }

    VectorLanes<width> force_before;  // of the links before those of the next vector

  private:
    static constexpr bool side_by_side = layout == Layout::side_by_side;
    static constexpr Eigen::Index next = side_by_side ? width : 1;

    LinkLanes<width> link_from(Eigen::Index i) const {
        const auto from = load<width>(x_ + i, y_ + i);
        if constexpr (layout == Layout::few_masses)
            return link_lanes(from, shifted_down(from, load<width>(x_ + i + width, y_ + i + width)));
        else
            return link_lanes(from, load<width>(x_ + i + next, y_ + i + next));
    }

    SpringLanes<width> spring_;
    Eigen::Index links_;
    const double* x_;
    const double* y_;
    const double* weight_;
    const double* fall_x_;
    const double* fall_y_;
    LinkLanes<width> link_;
    Lanes<width> pull_;
    LinkLanes<width> link_after_;
};

// Calls move(i, a), as the pipeline does, for every vector from `begin` to `end`, multiples of the width.
template <int width, Layout layout, class Move>
void accelerate(const Bundle& bundle, int place, Eigen::Index begin, Eigen::Index end, ForcesBefore& before,
                const Move& move) {
    Pipeline<width, layout> pipeline(bundle, bundle, place, begin);
    if (begin > 0) pipeline.force_before = load<width>(before.data(), before.data() + width);
    for (Eigen::Index i = begin; i < end; i += width) pipeline.advance(i, i + 2L * width, move);
    store(before.data(), before.data() + width, pipeline.force_before);
}

// Elements of a bundle in whole vectors.
template <int width>
Eigen::Index whole_vectors(const Bundle& bundle) {
    return (bundle.masses() * bundle.ropes() + width - 1) / width * width;
}

// Whether a loop over a bundle may begin while the one before it ends. The masses that it begins with have
// moved by then where there are four vectors. Of fewer than six of one rope, a link would wait for what has
// just been stored otherwise than it is read.
template <int width, Layout layout>
bool goes_round(const Bundle& bundle) {
    constexpr Eigen::Index fewest = layout == Layout::side_by_side ? 4 : 6;
    return bundle.is_short() && whole_vectors<width>(bundle) >= fewest * width;
}

// A loop over all masses of a bundle that goes round: what is under way as it ends is for the next one. Links
// are measured `here` elements from the places of the pipeline, in the next loop `next` elements from them.
template <int width, Layout layout, class Move>
void go_round(Pipeline<width, layout>& pipeline, Eigen::Index end, const Move& move, Eigen::Index here = 0,
              Eigen::Index next = 0) {
    constexpr Eigen::Index ahead = 2L * width;
    pipeline.force_before = {};
    if constexpr (layout == Layout::side_by_side) {  // faster by up to a tenth; of one rope it is not
        for (Eigen::Index i = 0; i < end - ahead; i += width) pipeline.advance(i, i + ahead + here, move);
        pipeline.advance(end - ahead, next, move);
        pipeline.advance(end - width, width + next, move);
    } else {
        for (Eigen::Index i = 0; i < end; i += width) {
            const Eigen::Index third = i + ahead;
            pipeline.advance(i, third < end ? third + here : third - end + next, move);
        }
    }
}

// Goes through `stages` loops over a bundle, stage(j, begin, end, before) each a part of loop j, which may be
// done once loop j - 1 has got one vector further. A long rope goes through many loops in blocks that stay in
// the nearest cache, each loop one vector behind the one before it (parallelogram tiling; Wolf, Lam: A Data
// Locality Optimizing Algorithm, PLDI 1991).
template <int width, class Stage>
void in_blocks(const Bundle& bundle, long stages, const Stage& stage) {
    constexpr Eigen::Index cache = 3584;  // doubles, 28 KB; half or double of it is slower by a twentieth
    constexpr long most_at_once = 64;
    const Eigen::Index block = cache / bundle.field_count() / width * width;
    const Eigen::Index elements = whole_vectors<width>(bundle);
    std::array<ForcesBefore, most_at_once> before;
    for (long first = 0; first < stages; first += most_at_once) {
        const long count = std::min(most_at_once, stages - first);
        const Eigen::Index behind = (count - 1) * width;
        const Eigen::Index length = elements > 2 * block ? block : elements + behind;
        for (Eigen::Index begin = 0; begin < elements + behind; begin += length)
            for (long j = 0; j < count; ++j) {
                const Eigen::Index from = std::max<Eigen::Index>(0, begin - j * width);
                const Eigen::Index to = std::min(elements, begin + length - j * width);
                if (from < to) stage(first + j, from, to, before[static_cast<std::size_t>(j)]);
            }
    }
}

}  // namespace ropesim
