#pragma once

#include "scene/scene.h"

#include <optional>

namespace ropesim {

// The first frame in which the scene cannot be predicted: a rounding of one mass at the start has grown
// beyond a millionth of a pixel there. None where the scene ends before.
std::optional<long> first_unpredictable_frame(const Scene& scene);

}  // namespace ropesim
