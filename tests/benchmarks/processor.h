#pragma once

#include <string>

namespace ropesim {

// What the processor calls itself.
std::string processor();

}  // namespace ropesim
