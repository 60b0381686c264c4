#pragma once

#include "image/image.h"
#include "simulation/rope.h"
#include "sweep/point_result.h"

#include <cstddef>
#include <vector>

namespace ropesim {

// On a contact sheet of a sweep: how many points stand side by side (those of the last variation), and how
// large each is, in the shape of the scene's picture.
std::size_t sheet_columns(const Sweep& sweep);

// More points than these would not be told apart.
inline constexpr long most_cells = 2500;

// A point's picture on that sheet: the scene's ropes at these positions (none where there is no motion), the
// values that are varied and what came of them.
Image point_cell(const Sweep& sweep, long point, const Scene& scene, const std::vector<Points>& positions,
                 const PointResult& result);

}  // namespace ropesim
