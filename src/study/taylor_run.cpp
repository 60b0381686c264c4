#include "study/taylor_run.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ropesim {
namespace {

using Eigen::Index;

// Row n holds the coefficients of t^n; one column per mass or per link.
using Series = Eigen::Array<long double, Eigen::Dynamic, Eigen::Dynamic>;
using Values = Eigen::Array<long double, Eigen::Dynamic, 1>;

// The motion is singular where its series allow a smaller part of a frame than this. The stiffest springs of
// the scenes need 1e-3.
constexpr long double smallest_part = 1e-6L;

// Below this share of its first value, a pivot of the tensions' system is a zero: links that lie within
// 1e-6 radians of one line between two pins.
constexpr long double smallest_pivot = 1e-12L;

// Everything about the current step: the series of the motion about its start, and what they are made of.
struct Expansion {
    Expansion(const Rope& rope, Model model, int order);

    Model model;
    Index order;
    Index masses;
    Index links;
    Values inverse_mass;                                   // zero at pins
    Eigen::Array<long double, Eigen::Dynamic, 2> gravity;  // zero at pins
    long double rest_length;
    long double stiffness;
    long double damping;

    Series coordinate[2];   // masses
    Series difference[2];   // of its two masses, one per link
    Series squared;         // length of a link, squared
    Series inverse_length;  // elastic only
    Series pull;            // force of a link divided by its length
    Series force[2];        // of a link on its first mass
    Values pivot;           // of the tensions' matrix, its L D Lᵀ: D
    Values lower;           // and what stands below the ones of L
};

Expansion::Expansion(const Rope& rope, Model which, int terms)
    : model(which),
      order(terms),
      masses(rope.start.rows()),
      links(masses - 1),
      inverse_mass(rope.mass.cast<long double>().inverse()),
      gravity(rope.gravity.transpose().cast<long double>().replicate(masses, 1)),
      rest_length(rope.rest_length),
      stiffness(rope.stiffness),
      damping(rope.damping),
      squared(order + 1, links),
      inverse_length(order + 1, links),
      pull(order + 1, links),
      pivot(links),
      lower(links) {
    for (const Index pin : rope.pinned) {
        inverse_mass(pin) = 0.0L;
        gravity.row(pin) = 0.0L;
    }
    for (int axis = 0; axis < 2; ++axis) {
        coordinate[axis] = Series::Zero(order + 1, masses);
        coordinate[axis].row(0) = rope.start.col(axis).transpose().cast<long double>();
        difference[axis] = Series::Zero(order + 1, links);
        force[axis] = Series::Zero(order + 1, links);
    }
}

// The sum of a[j] b[first + last - j], j from first to last: of a product's series, the part of coefficient
// first + last whose factors are both at least `first`.
long double convolution(const long double* a, const long double* b, Index first, Index last) {
    long double sum = 0.0L;
    for (Index j = first; j <= last; ++j) sum += a[j] * b[first + last - j];
    return sum;
}

// As convolution(a, a, first, last), at half the cost.
long double square(const long double* a, Index first, Index last) {
    long double half = 0.0L;
    Index i = first;
    Index j = last;
    for (; i < j; ++i, --j) half += a[i] * a[j];
    return 2.0L * half + (i == j ? a[i] * a[i] : 0.0L);
}

void expand_differences(Expansion& e, Index n) {
    for (int axis = 0; axis < 2; ++axis)
        for (Index link = 0; link < e.links; ++link)
            e.difference[axis](n, link) = e.coordinate[axis](n, link + 1) - e.coordinate[axis](n, link);
}

// Newton's law: coefficient n + 2 of the masses from coefficient n of the links' forces.
void expand_coordinates(Expansion& e, Index n) {
    const long double share = 1.0L / static_cast<long double>((n + 1) * (n + 2));
    for (int axis = 0; axis < 2; ++axis) {
        const Series& force = e.force[axis];
        for (Index i = 0; i < e.masses; ++i) {
            const long double onward = i < e.links ? force(n, i) : 0.0L;
            const long double back = i > 0 ? force(n, i - 1) : 0.0L;
            const long double weight = n == 0 ? e.gravity(i, axis) : 0.0L;
            const long double velocity = static_cast<long double>(n + 1) * e.coordinate[axis](n + 1, i);
            e.coordinate[axis](n + 2, i) =
                share * (e.inverse_mass(i) * (onward - back) + weight - e.damping * velocity);
        }
    }
}

// Coefficient n of r^-1/2 where r is the squared length, from r (r^-1/2)' = -r'/2 r^-1/2.
long double inverse_root(const long double* squared, const long double* root, Index n) {
    if (n == 0) return 1.0L / std::sqrt(squared[0]);
    long double sum = 0.0L;
    for (Index j = 0; j < n; ++j) sum += static_cast<long double>(n + j) * squared[n - j] * root[j];
    return -sum / (2.0L * static_cast<long double>(n) * squared[0]);
}

// Hooke's law: force k (1 - l/r^1/2) d.
void expand_springs(Expansion& e, Index n) {
    for (Index link = 0; link < e.links; ++link) {
        const long double* dx = &e.difference[0](0, link);
        const long double* dy = &e.difference[1](0, link);
        e.squared(n, link) = square(dx, 0, n) + square(dy, 0, n);
        e.inverse_length(n, link) = inverse_root(&e.squared(0, link), &e.inverse_length(0, link), n);
        e.pull(n, link) = e.stiffness * ((n == 0 ? 1.0L : 0.0L) - e.rest_length * e.inverse_length(n, link));
        e.force[0](n, link) = convolution(&e.pull(0, link), dx, 0, n);
        e.force[1](n, link) = convolution(&e.pull(0, link), dy, 0, n);
    }
    expand_coordinates(e, n);
}

// The matrix whose row i is -w[i] d[i-1]·d[i], (w[i] + w[i+1]) d[i]·d[i], -w[i+1] d[i]·d[i+1], factored.
// A link between two pins has a row of zeros and gets no tension. False where the matrix is singular.
bool factor_tensions(Expansion& e) {
    const auto dot = [&](Index i, Index j) {
        return e.difference[0](0, i) * e.difference[0](0, j) + e.difference[1](0, i) * e.difference[1](0, j);
    };
    for (Index i = 0; i < e.links; ++i) {
        const long double diagonal = (e.inverse_mass(i) + e.inverse_mass(i + 1)) * dot(i, i);
        const long double beside = i > 0 ? -e.inverse_mass(i) * dot(i - 1, i) : 0.0L;
        e.lower(i) = i > 0 ? beside / e.pivot(i - 1) : 0.0L;
        e.pivot(i) = diagonal > 0.0L ? diagonal - e.lower(i) * beside : 1.0L;
        if (!(e.pivot(i) > smallest_pivot * diagonal)) return false;
    }
    return true;
}

void solve_tensions(const Expansion& e, Values& value) {
    for (Index i = 1; i < e.links; ++i) value(i) -= e.lower(i) * value(i - 1);
    value /= e.pivot;
    for (Index i = e.links - 1; i > 0; --i) value(i - 1) -= e.lower(i) * value(i);
}

// Tensions that leave d·d without a coefficient n + 2. They are found from what d·d would have there without
// the tensions' own coefficient n.
void expand_tensions(Expansion& e, Index n) {
    for (int axis = 0; axis < 2; ++axis)
        for (Index link = 0; link < e.links; ++link)
            e.force[axis](n, link) =
                convolution(&e.pull(0, link), &e.difference[axis](0, link) + 1, 0, n - 1);
    expand_coordinates(e, n);
    expand_differences(e, n + 2);

    Values excess(e.links);
    for (Index link = 0; link < e.links; ++link)
        excess(link) =
            (square(&e.difference[0](0, link), 0, n + 2) + square(&e.difference[1](0, link), 0, n + 2)) /
            2.0L * static_cast<long double>((n + 1) * (n + 2));
    solve_tensions(e, excess);
    for (Index link = 0; link < e.links; ++link) {
        const bool moves = e.inverse_mass(link) + e.inverse_mass(link + 1) > 0.0L;
        e.pull(n, link) = moves ? excess(link) : 0.0L;
        for (int axis = 0; axis < 2; ++axis)
            e.force[axis](n, link) += e.pull(n, link) * e.difference[axis](0, link);
    }
    expand_coordinates(e, n);
}

// From coefficients 0 (positions) and 1 (velocities), all others. False where there are none.
bool expand(Expansion& e) {
    expand_differences(e, 0);
    expand_differences(e, 1);
    if (e.model == Model::inextensible && !factor_tensions(e)) return false;
    for (Index n = 0; n + 2 <= e.order; ++n) {
        if (e.model == Model::elastic)
            expand_springs(e, n);
        else
            expand_tensions(e, n);
        expand_differences(e, n + 2);
    }
    return e.coordinate[0].isFinite().all() && e.coordinate[1].isFinite().all();
}

// The step in which the last two terms come to at most `allowed`.
long double longest_step(const Expansion& e, long double allowed) {
    long double step = std::numeric_limits<long double>::infinity();
    for (const Index n : {e.order - 1, e.order}) {
        const long double term =
            std::sqrt((e.coordinate[0].row(n).square() + e.coordinate[1].row(n).square()).maxCoeff());
        if (term > 0.0L) step = std::min(step, std::pow(allowed / term, 1.0L / static_cast<long double>(n)));
    }
    return step;
}

// Positions and velocities after the step become coefficients 0 and 1.
void move_on(Expansion& e, long double step) {
    for (Series& series : e.coordinate) {
        for (Index i = 0; i < e.masses; ++i) {
            long double position = 0.0L;
            long double velocity = 0.0L;
            for (Index n = e.order; n > 0; --n) {
                position = (position + series(n, i)) * step;
                velocity = velocity * step + static_cast<long double>(n) * series(n, i);
            }
            series(0, i) += position;
            series(1, i) = velocity;
        }
    }
}

// Equal parts of what is left of a frame, no longer than the series allow, so that frames fall on steps.
bool advance(Expansion& e, long double frame_time, long double allowed) {
    for (long double left = frame_time;;) {
        if (!expand(e)) return false;
        const long double longest = longest_step(e, allowed);
        if (!(longest > smallest_part * frame_time)) return false;
        const long double step = left / std::max(1.0L, std::ceil(left / longest));
        move_on(e, step);
        if (step == left) return true;
        left -= step;
    }
}

Points row_of(const Series (&coordinate)[2], Index n) {
    Points points(coordinate[0].cols(), 2);
    for (int axis = 0; axis < 2; ++axis)
        points.col(axis) = coordinate[axis].row(n).transpose().cast<double>();
    return points;
}

}  // namespace

Run taylor_run(const Rope& rope, Model model, double frame_time, long frames,
               const TaylorPrecision& precision) {
    Expansion e(rope, model, precision.order);
    expand_differences(e, 0);
    const long double length =
        (e.difference[0].row(0).square() + e.difference[1].row(0).square()).sqrt().sum();
    Run run;
    for (long frame = 0; frame < frames; ++frame) {
        if (frame > 0 && !advance(e, frame_time, precision.tolerance * length)) break;
        run.position.push_back(row_of(e.coordinate, 0));
        run.velocity.push_back(row_of(e.coordinate, 1));
    }
    return run;
}

}  // namespace ropesim
