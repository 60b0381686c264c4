#pragma once

#include "simulation/method.h"
#include "study/run.h"

namespace ropesim {

// How far the Taylor series go and what may be left out in a step.
struct TaylorPrecision {
    int order = 24;
    long double tolerance = 0.0L;  // greatest size of the last two terms, as a share of the rope's length
};

// The motion by Taylor series in long double, each step as long as the series' last terms allow.
// Masses' coordinates in both models. Elastic: the series of Hooke's law follow from those of the links.
// Inextensible: links keep the length they start with; each order of the series of the tensions follows
// from a tridiagonal system, the same in all orders, which says that the links' squared lengths have no
// coefficient of that order. Nothing is projected.
// Jorba, Zou: A software package for the numerical integration of ODEs by means of high-order Taylor
// methods, Experimental Mathematics 14, 2005; Pryce: Solving high-index DAEs by Taylor series, Numerical
// Algorithms 19, 1998.
Run taylor_run(const Rope& rope, Model model, double frame_time, long frames,
               const TaylorPrecision& precision);

}  // namespace ropesim
