#include "simulation/link_impulses.h"

#include "simulation/lanes.h"

#include <cmath>
#include <limits>

namespace ropesim {
namespace {

using Eigen::Index;

// A pivot so much smaller than its diagonal is rounding: the link's constraint depends on those before it.
constexpr double dependent = 1e-13;

void fill(const Eigen::ArrayXd& weight, const Points& before, const Points& after, LinkSystem& system) {
    const Index links = before.rows();
    system.lower.resize(links);
    system.diagonal.resize(links);
    system.upper.resize(links);
    const double* const w = weight.data();
    const double* const dx = before.col(0).data();
    const double* const dy = before.col(1).data();
    const double* const ex = after.col(0).data();
    const double* const ey = after.col(1).data();
    double* const lower = system.lower.data();
    double* const diagonal = system.diagonal.data();
    double* const upper = system.upper.data();
    for (Index i = 0; i < links; ++i) diagonal[i] = (w[i] + w[i + 1]) * (ex[i] * dx[i] + ey[i] * dy[i]);
    for (Index i = 1; i < links; ++i) lower[i] = -w[i] * (ex[i] * dx[i - 1] + ey[i] * dy[i - 1]);
    for (Index i = 1; i < links; ++i) upper[i - 1] = -w[i] * (ex[i - 1] * dx[i] + ey[i - 1] * dy[i]);
    lower[0] = upper[links - 1] = 0.0;
}

// What divides the row of a link whose constraint is not determined: it comes to nothing. A call, since a
// choice would lengthen the chain of divisions.
[[gnu::cold, gnu::noinline]] double of_no_impulse() {
    return std::numeric_limits<double>::infinity();
}

double settled(double pivot, double diagonal) {
    if (!(std::abs(pivot) > dependent * std::abs(diagonal))) [[unlikely]]
        return of_no_impulse();
    return pivot;
}

// The link that was eliminated last, coming from one end.
struct Eliminated {
    double pivot = 1.0;
    double inner = 0.0;  // what couples it to the next one, towards the middle
    double right = 0.0;  // of its row, divided by the pivot
};

// Eliminates the next link, which `outer` couples to the last one and `inner` to the one after it, and makes
// its pivot one: all of it while the pivot of the link after it waits for a division.
void eliminate(double diagonal, double outer, double& inner, double& right, Eliminated& last) {
    last.pivot = settled(diagonal - outer * last.inner / last.pivot, diagonal);
    last.inner = inner;
    const double inverse = 1.0 / last.pivot;
    inner *= inverse;
    last.right = right = right * inverse - outer * inverse * last.right;
}

// From both ends to the middle link and back.
void eliminate_and_substitute(LinkSystem& system, Eigen::ArrayXd& r) {
    const Index end = r.size() - 1;
    const Index middle = r.size() / 2;
    double* const lower = system.lower.data();
    double* const upper = system.upper.data();
    double* const right = r.data();
    const double* const diagonal = system.diagonal.data();
    Eliminated before;
    Eliminated after;
    for (Index i = 0, j = end; i < middle; ++i, --j) {
        eliminate(diagonal[i], lower[i], upper[i], right[i], before);
        if (j > middle) eliminate(diagonal[j], upper[j], lower[j], right[j], after);
    }
    const double inverse = 1.0 / settled(diagonal[middle] - lower[middle] * before.inner / before.pivot -
                                             upper[middle] * after.inner / after.pivot,
                                         diagonal[middle]);
    right[middle] = right[middle] * inverse -
                    (lower[middle] * inverse * before.right + upper[middle] * inverse * after.right);
    double to_begin = right[middle];
    double to_end = right[middle];
    for (Index i = middle - 1, j = middle + 1; i >= 0; --i, ++j) {
        to_begin = right[i] -= upper[i] * to_begin;
        if (j <= end) to_end = right[j] -= lower[j] * to_end;
    }
}

}  // namespace

void solve_impulses(const Eigen::ArrayXd& weight, const Points& before, const Points& after,
                    InstructionSet instructions, LinkSystem& system, Eigen::ArrayXd& r) {
    in_lanes(instructions, [&](auto) {
        fill(weight, before, after, system);
        eliminate_and_substitute(system, r);
    });
}

}  // namespace ropesim
