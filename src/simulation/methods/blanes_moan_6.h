#pragma once

namespace ropesim {

// Coefficients of SRKN14a of order 6: the shares of a step for which the fifteen stages drift and the
// fourteen kicks between them kick; both read the same backwards. Blanes, Moan: Practical symplectic
// partitioned Runge-Kutta and Runge-Kutta-Nyström methods, J. Comput. Appl. Math. 142, 2002, table 3.
struct BlanesMoan6 {
    static constexpr double a1 = 0.0378593198406116;
    static constexpr double a2 = 0.102635633102435;
    static constexpr double a3 = -0.0258678882665587;
    static constexpr double a4 = 0.314241403071447;
    static constexpr double a5 = -0.130144459517415;
    static constexpr double a6 = 0.106417700369543;
    static constexpr double a7 = -0.00879424312851058;
    static constexpr double a8 = 1.0 - 2.0 * (a1 + a2 + a3 + a4 + a5 + a6 + a7);
    static constexpr double b1 = 0.09171915262446165;
    static constexpr double b2 = 0.183983170005006;
    static constexpr double b3 = -0.05653436583288827;
    static constexpr double b4 = 0.004914688774712854;
    static constexpr double b5 = 0.143761127168358;
    static constexpr double b6 = 0.328567693746804;
    static constexpr double b7 = 0.5 - (b1 + b2 + b3 + b4 + b5 + b6);

    static constexpr double drifts[15] = {a1, a2, a3, a4, a5, a6, a7, a8, a7, a6, a5, a4, a3, a2, a1};
    static constexpr double kicks[14] = {b1, b2, b3, b4, b5, b6, b7, b7, b6, b5, b4, b3, b2, b1};
};

}  // namespace ropesim
