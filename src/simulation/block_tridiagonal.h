#pragma once

#include <Eigen/Core>

namespace ropesim {

// A symmetric matrix of 2×2 blocks along a chain: block i on the diagonal, and block i that couples i and
// i + 1, itself symmetric. Every row holds a block's xx, xy and yy.
struct BlockTridiagonal {
    Eigen::ArrayX3d diagonal;  // n rows
    Eigen::ArrayX3d coupling;  // n - 1 rows
};

// Factors the matrix in place, A = L P Lᵀ by blocks (Golub, Van Loan: Matrix Computations, 2013, 4.5.1).
// False, and the matrix is spent, where a pivot is not positive: A is not positive definite.
bool factor(BlockTridiagonal& matrix);

// Solves A x = b in place of b, n×2, for a matrix that has been factored.
void solve(const BlockTridiagonal& factored, Eigen::ArrayX2d& b);

}  // namespace ropesim
