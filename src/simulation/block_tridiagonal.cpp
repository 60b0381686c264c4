#include "simulation/block_tridiagonal.h"

namespace ropesim {
namespace {

// A symmetric 2×2 matrix as (1, 0; ratio, 1) diag(1/inverse_xx, 1/inverse_yy) (1, ratio; 0, 1).
struct Pivot {
    double inverse_xx;
    double ratio;
    double inverse_yy;
};

Pivot pivot(const BlockTridiagonal& factored, Eigen::Index i) {
    return {factored.diagonal(i, 0), factored.diagonal(i, 1), factored.diagonal(i, 2)};
}

// Replaces block i by its own factors.
bool factor_block(BlockTridiagonal& matrix, Eigen::Index i) {
    const double xx = matrix.diagonal(i, 0);
    const double xy = matrix.diagonal(i, 1);
    if (!(xx > 0.0)) return false;
    const double ratio = xy / xx;
    const double yy = matrix.diagonal(i, 2) - ratio * xy;
    if (!(yy > 0.0)) return false;
    matrix.diagonal.row(i) << 1.0 / xx, ratio, 1.0 / yy;
    return true;
}

}  // namespace

// P[i] = A[i] - C[i-1] P[i-1]⁻¹ C[i-1], the last term as a sum of squares of the columns of C.
bool factor(BlockTridiagonal& matrix) {
    const Eigen::Index blocks = matrix.diagonal.rows();
    for (Eigen::Index i = 0; i < blocks; ++i) {
        if (i > 0) {
            const Pivot before = pivot(matrix, i - 1);
            const double xx = matrix.coupling(i - 1, 0);
            const double xy = matrix.coupling(i - 1, 1);
            const double yx = xy - before.ratio * xx;
            const double yy = matrix.coupling(i - 1, 2) - before.ratio * xy;
            matrix.diagonal(i, 0) -= xx * xx * before.inverse_xx + yx * yx * before.inverse_yy;
            matrix.diagonal(i, 1) -= xx * xy * before.inverse_xx + yx * yy * before.inverse_yy;
            matrix.diagonal(i, 2) -= xy * xy * before.inverse_xx + yy * yy * before.inverse_yy;
        }
        if (!factor_block(matrix, i)) return false;
    }
    return true;
}

// Down the chain z[i] = P[i]⁻¹ (b[i] - C[i-1] z[i-1]), then up it x[i] = z[i] - P[i]⁻¹ C[i] x[i+1].
void solve(const BlockTridiagonal& factored, Eigen::ArrayX2d& b) {
    const auto divided = [&](Eigen::Index i, double x, double y) {
        const Pivot by = pivot(factored, i);
        const double second = (y - by.ratio * x) * by.inverse_yy;
        return Eigen::Array2d(x * by.inverse_xx - by.ratio * second, second);
    };
    const auto coupled = [&](Eigen::Index i, const Eigen::Array2d& to) {
        return Eigen::Array2d(factored.coupling(i, 0) * to.x() + factored.coupling(i, 1) * to.y(),
                              factored.coupling(i, 1) * to.x() + factored.coupling(i, 2) * to.y());
    };
    const Eigen::Index blocks = b.rows();
    Eigen::Array2d beside = divided(0, b(0, 0), b(0, 1));
    b.row(0) = beside.transpose();
    for (Eigen::Index i = 1; i < blocks; ++i) {
        const Eigen::Array2d taken = coupled(i - 1, beside);
        beside = divided(i, b(i, 0) - taken.x(), b(i, 1) - taken.y());
        b.row(i) = beside.transpose();
    }
    for (Eigen::Index i = blocks - 2; i >= 0; --i) {
        const Eigen::Array2d taken = coupled(i, beside);
        beside = Eigen::Array2d(b(i, 0), b(i, 1)) - divided(i, taken.x(), taken.y());
        b.row(i) = beside.transpose();
    }
}

}  // namespace ropesim
