#pragma once

#include "scene/scene.h"

#include <string>
#include <string_view>
#include <vector>

namespace ropesim {

// A key of a scene, as set_key takes it, and the values that it is to have, as TOML has them.
struct Variation {
    std::string key;
    std::vector<std::string> values;
};

// Reads "KEY=A:B:N", N values from A to B at equal distances, "KEY=A:B:N:log", at equal ratios, or
// "KEY=V1,V2,...". A key that takes whole numbers gets the nearest ones. Each value is tried on the scene.
// Throws std::runtime_error for what cannot be read, a value that is given twice, and as set_key does.
Variation parse_variation(std::string_view text, const Scene& scene);

}  // namespace ropesim
