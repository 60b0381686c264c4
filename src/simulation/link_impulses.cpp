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
    system.pivot.resize(links);
    system.upper.resize(links);
    const double* const w = weight.data();
    const double* const dx = before.col(0).data();
    const double* const dy = before.col(1).data();
    const double* const ex = after.col(0).data();
    const double* const ey = after.col(1).data();
    double* const lower = system.lower.data();
    double* const pivot = system.pivot.data();
    double* const upper = system.upper.data();
    for (Index i = 0; i < links; ++i) pivot[i] = (w[i] + w[i + 1]) * (ex[i] * dx[i] + ey[i] * dy[i]);
    for (Index i = 1; i < links; ++i) lower[i] = -w[i] * (ex[i] * dx[i - 1] + ey[i] * dy[i - 1]);
    for (Index i = 1; i < links; ++i) upper[i - 1] = -w[i] * (ex[i - 1] * dx[i] + ey[i - 1] * dy[i]);
    lower[0] = upper[links - 1] = 0.0;
}

// Infinite where the link's constraint is not determined: then its row comes to nothing.
double settled(double pivot, double diagonal) {
    if (!(std::abs(pivot) > dependent * std::abs(diagonal))) [[unlikely]]
        return std::numeric_limits<double>::infinity();
    return pivot;
}

void make_pivots_one(LinkSystem& system, Eigen::ArrayXd& r) {
    double* const lower = system.lower.data();
    double* const upper = system.upper.data();
    double* const right = r.data();
    const double* const pivot = system.pivot.data();
    for (Index i = 0; i < r.size(); ++i) {
        const double inverse = 1.0 / pivot[i];
        lower[i] *= inverse;
        upper[i] *= inverse;
        right[i] *= inverse;
    }
}

// Eliminates from both ends to the middle link and makes all pivots one.
void eliminate(LinkSystem& system, Eigen::ArrayXd& r) {
    const Index links = r.size();
    const Index middle = links / 2;
    const double* const lower = system.lower.data();
    const double* const upper = system.upper.data();
    double* const pivot = system.pivot.data();
    double before = 1.0;  // pivots of the links that were eliminated last
    double after = 1.0;
    for (Index i = 0, j = links - 1; i < middle; ++i, --j) {
        const double from_before = i > 0 ? lower[i] * upper[i - 1] / before : 0.0;
        before = pivot[i] = settled(pivot[i] - from_before, pivot[i]);
        if (j == middle) break;
        const double from_after = j < links - 1 ? upper[j] * lower[j + 1] / after : 0.0;
        after = pivot[j] = settled(pivot[j] - from_after, pivot[j]);
    }
    const double from_before = middle > 0 ? lower[middle] * upper[middle - 1] / before : 0.0;
    const double from_after = middle < links - 1 ? upper[middle] * lower[middle + 1] / after : 0.0;
    pivot[middle] = settled(pivot[middle] - from_before - from_after, pivot[middle]);
    make_pivots_one(system, r);
}

// From the ends to the middle and back.
void substitute(const LinkSystem& system, Eigen::ArrayXd& r) {
    const Index links = r.size();
    const Index middle = links / 2;
    const double* const lower = system.lower.data();
    const double* const upper = system.upper.data();
    double* const right = r.data();
    double before = 0.0;
    double after = 0.0;
    for (Index i = 0, j = links - 1; i < middle; ++i, --j) {
        before = right[i] -= lower[i] * before;
        if (j > middle) after = right[j] -= upper[j] * after;
    }
    before = after = right[middle] -= lower[middle] * before + upper[middle] * after;
    for (Index i = middle - 1, j = middle + 1; i >= 0; --i, ++j) {
        before = right[i] -= upper[i] * before;
        if (j < links) after = right[j] -= lower[j] * after;
    }
}

}  // namespace

void solve_impulses(const Eigen::ArrayXd& weight, const Points& before, const Points& after,
                    InstructionSet instructions, LinkSystem& system, Eigen::ArrayXd& r) {
    in_lanes(instructions, [&](auto) {
        fill(weight, before, after, system);
        eliminate(system, r);
        substitute(system, r);
    });
}

}  // namespace ropesim
