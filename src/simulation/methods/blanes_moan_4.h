#pragma once

namespace ropesim {

// Coefficients of SRKN6b of order 4: the shares of a step for which the six stages drift and the seven kick;
// both read the same backwards. Blanes, Moan: Practical symplectic partitioned Runge-Kutta and
// Runge-Kutta-Nyström methods, J. Comput. Appl. Math. 142, 2002, table 3, whose 15 digits satisfy the order
// conditions to 2e-16; the digits after them are Newton's nearest point at which the conditions hold.
struct BlanesMoan4 {
    static constexpr double a1 = 0.24529895718427116;
    static constexpr double a2 = 0.60487266571107997;
    static constexpr double a3 = 0.5 - (a1 + a2);
    static constexpr double b1 = 0.08298440641740501;
    static constexpr double b2 = 0.39630980149836808;
    static constexpr double b3 = -0.039056304922348435;
    static constexpr double b4 = 1.0 - 2.0 * (b1 + b2 + b3);

    static constexpr double drifts[6] = {a1, a2, a3, a3, a2, a1};
    static constexpr double kicks[7] = {b1, b2, b3, b4, b3, b2, b1};
};

}  // namespace ropesim
