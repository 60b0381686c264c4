#pragma once

#include "scene/scene.h"

namespace ropesim {

// Length of the way from start over the corners to end, world units.
double path_length(const SceneRope& rope);

// Where the masses are at the start: spaced evenly along the path, the first at `start` and the last at
// `end`, to the bit. Without corners, mass i of n is at start + (end - start) i / (n - 1), reckoned from the
// nearer end, so that a rope that lies symmetrically about an axis does so to the bit. World units, masses×2.
Points points_along(const SceneRope& rope);

}  // namespace ropesim
