#pragma once

#include "image/image.h"

#include <cstdint>

namespace ropesim {

// Independent bytes of 0 to 255; the same for the same seed.
Image noise(int width, int height, std::uint32_t seed);

// Red grows to the right, green downwards, blue along both.
Image gradient(int width, int height);

// Anti-aliased lines, one red, one green, one white, across a picture of one colour.
Image ropes(int width, int height, Color background);

}  // namespace ropesim
