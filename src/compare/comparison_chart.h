#pragma once

#include "compare/parting.h"

#include <string>

namespace ropesim {

// The gnuplot script that draws the distance of each run from the first over time from "comparison.csv", in
// the folder it is run in, into "comparison.png" and "comparison.svg".
std::string comparison_script(const Scene& scene, const Parting& parting);

}  // namespace ropesim
