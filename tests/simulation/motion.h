#pragma once

#include "simulation/method.h"

#include <string>

namespace ropesim {

// Every bit of how a bent rope of unequal masses, damped and pinned at both ends, moves in ten frames: the
// positions as hexadecimal floating point, a line for each mass in each frame.
std::string motion(const Method& method);

}  // namespace ropesim
