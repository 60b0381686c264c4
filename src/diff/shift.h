#pragma once

#include "diff/compare.h"

namespace ropesim {

// How many frames late ACTUAL is: k where every frame that differs shows what EXPECTED's k-th frame before it
// shows, pixel for pixel; negative where early, 0 where neither. Up to three frames.
long shift(const Comparison& comparison);

}  // namespace ropesim
