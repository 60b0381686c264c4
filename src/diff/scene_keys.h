#pragma once

#include "scene/scene.h"

#include <string>
#include <vector>

namespace ropesim {

// A key that two scenes give different values.
struct KeyDifference {
    std::string key;       // "gravity", "clip: frames", "rope 'Euler': mass"
    std::string expected;  // as TOML; "" where only the other has it
    std::string actual;
};

// In the order of the scene file; ropes are matched by their names. Empty where the scenes are equal.
std::vector<KeyDifference> key_differences(const Scene& expected, const Scene& actual);

// "rope 'Euler': mass 1.0 -> 2.0"
std::string to_string(const KeyDifference& difference);

}  // namespace ropesim
