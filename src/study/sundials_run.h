#pragma once

#include "simulation/method.h"
#include "study/run.h"

namespace ropesim {

// The motion by SUNDIALS' ARKODE (Fehlberg's explicit Runge-Kutta pair of orders 7 and 8) in double, close to
// its rounding. Elastic: masses' coordinates. Inextensible: angles of the links.
Run sundials_run(const Rope& rope, Model model, double frame_time, long frames);

}  // namespace ropesim
