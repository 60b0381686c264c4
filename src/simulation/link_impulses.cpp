#include "simulation/link_impulses.h"

#include <cmath>

namespace ropesim {
namespace {

// A pivot so much smaller than its diagonal is rounding: the link's constraint depends on those before it.
constexpr double dependent = 1e-13;

double dot(const Points& a, Eigen::Index i, const Points& b, Eigen::Index j) {
    return a(i, 0) * b(j, 0) + a(i, 1) * b(j, 1);
}

}  // namespace

void solve_impulses(const Eigen::ArrayXd& weight, const Points& before, const Points& after,
                    Eigen::ArrayXd& upper, Eigen::ArrayXd& r) {
    const Eigen::Index links = r.size();
    upper.resize(links);
    double upper_before = 0.0;
    double r_before = 0.0;
    for (Eigen::Index i = 0; i < links; ++i) {
        const double diagonal = (weight(i) + weight(i + 1)) * dot(after, i, before, i);
        double pivot = diagonal;
        double right = r(i);
        if (i > 0) {
            const double lower = -weight(i) * dot(after, i, before, i - 1);
            pivot -= lower * upper_before;
            right -= lower * r_before;
        }
        const bool determined = std::abs(pivot) > dependent * std::abs(diagonal);
        r_before = determined ? right / pivot : 0.0;
        upper_before =
            determined && i + 1 < links ? -weight(i + 1) * dot(after, i, before, i + 1) / pivot : 0.0;
        r(i) = r_before;
        upper(i) = upper_before;
    }
    for (Eigen::Index i = links - 2; i >= 0; --i) {
        r_before = r(i) - upper(i) * r_before;
        r(i) = r_before;
    }
}

}  // namespace ropesim
