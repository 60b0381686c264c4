#pragma once

#include "simulation/bundle.h"
#include "simulation/lanes.h"
#include "simulation/links.h"

#include <algorithm>
#include <array>

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
    Lanes<width> length;
};

template <int width>
LinkLanes<width> link_lanes(const VectorLanes<width>& from, const VectorLanes<width>& to) {
    const Lanes<width> dx = to.x - from.x;
    const Lanes<width> dy = to.y - from.y;
    return {{dx, dy}, square_root(dx * dx + dy * dy + shortest_squared)};
}

// Of the springs of a bundle, in each lane.
template <int width>
struct SpringLanes {
    Lanes<width> stiffness;
    Lanes<width> rest_length;

    explicit SpringLanes(const Bundle& bundle)
        : stiffness(bundle.ropes() == 1 ? Lanes<width>{} + bundle.stiffness[0]
                                        : load<width>(bundle.stiffness.data())),
          rest_length(bundle.ropes() == 1 ? Lanes<width>{} + bundle.rest_length[0]
                                          : load<width>(bundle.rest_length.data())) {}
};

// Hooke's law, the pull of a link for each unit of its length: k (1 - l/|d|).
template <int width>
Lanes<width> pull_lanes(const SpringLanes<width>& spring, const Lanes<width>& length) {
    return spring.stiffness * (1.0 - spring.rest_length / length);
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

// Whether the mass after that of a lane is in the next lane or in the same one of the next vector.
enum class Layout { one_rope, side_by_side };

// Elements of a bundle in whole vectors.
template <int width>
Eigen::Index whole_vectors(const Bundle& bundle) {
    return (bundle.masses() * bundle.ropes() + width - 1) / width * width;
}

// The vector before a place in a bundle, for the loop that goes on from there: the forces of its links,
// and where its masses are.
template <int width>
struct Edge {
    VectorLanes<width> force;
    VectorLanes<width> place;
};

// The loops over the masses of a bundle. Each measures the links for the next one, as soon as the masses at
// both ends have moved: a square root has nearly a loop of time until it is needed, and a division begins two
// vectors ahead (software pipelining; Lam: Software Pipelining, PLDI 1988). One after the other, they take
// longer than a processor sees ahead. All that is read is whole vectors as they were stored.
template <int width, Layout layout>
class Loops {
  public:
    // Over the masses where they are in the bundle, whose links it measures for the first loop.
    explicit Loops(Bundle& bundle)
        : spring_(bundle),
          links_((bundle.masses() - 1) * (side_by_side ? width : 1)),
          elements_(whole_vectors<width>(bundle)),
          weight_(bundle[Bundle::weight]),
          fall_x_(bundle[Bundle::fall_x]),
          fall_y_(bundle[Bundle::fall_y]),
          link_x_(bundle[Bundle::link_x]),
          link_y_(bundle[Bundle::link_y]),
          length_(bundle[Bundle::length]) {
        Edge<width> none;
        each(0, elements_, none, [x = bundle[Bundle::x], y = bundle[Bundle::y]](Eigen::Index i) {
            return load<width>(x + i, y + i);
        });
    }

    // For every vector from `begin` to `end`, multiples of the width, calls move(i, a) with the accelerations
    // of its masses, which are those from element i; it returns where they are then.
    template <class Move>
    void accelerate(Eigen::Index begin, Eigen::Index end, Edge<width>& edge, const Move& move) const {
        VectorLanes<width> force_before;
        if (begin > 0) force_before = edge.force;
        Lanes<width> pull = pull_at(begin);
        Lanes<width> pull_after = pull_at(begin + width);
        each(begin, end, edge, [&](Eigen::Index i) {
            const Lanes<width> third = pull_at(i + 2L * width);
            const VectorLanes<width> force =
                force_lanes<width>(pull, load<width>(link_x_ + i, link_y_ + i), links_ - i);
            const auto a =
                acceleration_lanes<width>(load<width>(weight_ + i), force,
                                          side_by_side ? force_before : shifted_up(force_before, force),
                                          load<width>(fall_x_ + i, fall_y_ + i));
            force_before = force;
            pull = pull_after;
            pull_after = third;
            return move(i, a);
        });
        if (end < elements_) edge.force = force_before;
    }

    // The same where the move needs no accelerations: it is called with i alone. Measures the links of the
    // masses that have moved.
    template <class Move>
    void each(Eigen::Index begin, Eigen::Index end, Edge<width>& edge, const Move& move) const {
        VectorLanes<width> before;
        if (begin > 0) before = edge.place;
        Eigen::Index i = begin;
        if constexpr (side_by_side) {  // faster by up to a tenth; of one rope it is not
            if (begin == 0) {
                before = move(i);
                i += width;
            }
        }
        for (; i < end; i += width) {
            const VectorLanes<width> place = move(i);
            if (side_by_side || i > 0) measure(i - width, before, place);
            before = place;
        }
        if (end < elements_)
            edge.place = before;
        else
            measure(end - width, before, {});
    }

  private:
    static constexpr bool side_by_side = layout == Layout::side_by_side;

    Lanes<width> pull_at(Eigen::Index i) const {
        return pull_lanes<width>(spring_, load<width>(length_ + i));
    }

    // The links of the masses from element i, which are at `from`, the vector after them at `to`.
    void measure(Eigen::Index i, const VectorLanes<width>& from, const VectorLanes<width>& to) const {
        const LinkLanes<width> link = link_lanes(from, side_by_side ? to : shifted_down(from, to));
        store(link_x_ + i, link_y_ + i, link.d);
        store(length_ + i, link.length);
    }

    SpringLanes<width> spring_;
    Eigen::Index links_;
    Eigen::Index elements_;
    const double* weight_;
    const double* fall_x_;
    const double* fall_y_;
    double* link_x_;
    double* link_y_;
    double* length_;
};

// Goes through `stages` loops over a bundle, stage(j, begin, end, edge) each a part of loop j, which may be
// done once loop j - 1 has got one vector further. A long rope goes through many loops in blocks that stay in
// the nearest cache, each loop one vector behind the one before it (parallelogram tiling; Wolf, Lam: A Data
// Locality Optimizing Algorithm, PLDI 1991).
template <int width, class Stage>
void in_blocks(const Bundle& bundle, long stages, const Stage& stage) {
    constexpr Eigen::Index cache = 3584;  // doubles, 28 KB; twice that is slower by a tenth
    constexpr long most_at_once = 64;
    const Eigen::Index block = cache / bundle.field_count() / width * width;
    const Eigen::Index elements = whole_vectors<width>(bundle);
    if (elements <= 2 * block) {
        Edge<width> none;
        for (long j = 0; j < stages; ++j) stage(j, 0, elements, none);
        return;
    }
    std::array<Edge<width>, most_at_once> edges;
    for (long first = 0; first < stages; first += most_at_once) {
        const long count = std::min(most_at_once, stages - first);
        const Eigen::Index behind = (count - 1) * width;
        for (Eigen::Index begin = 0; begin < elements + behind; begin += block)
            for (long j = 0; j < count; ++j) {
                const Eigen::Index from = std::max<Eigen::Index>(0, begin - j * width);
                const Eigen::Index to = std::min(elements, begin + block - j * width);
                if (from < to) stage(first + j, from, to, edges[static_cast<std::size_t>(j)]);
            }
    }
}

}  // namespace ropesim
