#pragma once

#include "study/work_precision.h"

#include <string>

namespace ropesim {

// What a work-precision diagram shows as work.
enum class Work {
    time,   // per frame
    count,  // evaluations of all accelerations, solves and sweeps, per frame: the same on every machine
};

// The gnuplot script that draws the diagram (Hairer, Nørsett, Wanner: Solving ODEs I, 1993, II.10) from the
// study's CSV, "work_precision.csv" in the folder it is run in, into "<name>.png" and "<name>.svg". Errors
// across, smaller to the right; what is better is lower and further right.
std::string work_precision_script(const WorkPrecision& study, Work work, const std::string& name,
                                  const std::string& title);

}  // namespace ropesim
