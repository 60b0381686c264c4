#pragma once

#include "image/image.h"

#include <cstdint>

namespace ropesim {

// x y / 255 in whole numbers, for x and y from 0 to 255; x where y is 255.
constexpr int product(int x, int y) {
    const int xy = x * y;
    return (xy + (xy >> 8) + 128) >> 8;
}

// Lays a colour over a pixel, of which it covers coverage / 255. The same bytes as OpenGL's blending by
// llvmpipe.
inline void mix(Color above, std::uint8_t coverage, std::uint8_t* pixel) {
    for (std::size_t i = 0; i < above.size(); ++i)
        pixel[i] = static_cast<std::uint8_t>(product(above[i], coverage) + product(pixel[i], 255 - coverage));
}

}  // namespace ropesim
