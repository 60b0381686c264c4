#pragma once

#include "sweep/point_result.h"

#include <string>
#include <vector>

namespace ropesim {

// Whether sweep_script can draw it: one or two keys are varied, at least one of them.
bool has_chart(const Sweep& sweep);

// The gnuplot script that draws error and work from "sweep.csv" in the folder it is run in into "sweep.png"
// and "sweep.svg": as curves over one varied key, as heat maps over two. One result per point.
std::string sweep_script(const Sweep& sweep, const std::vector<PointResult>& results);

}  // namespace ropesim
