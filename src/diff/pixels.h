#pragma once

#include "image/image.h"

namespace ropesim {

// A rectangle of pixels, all four sides included; empty where right < left.
struct Region {
    int left = 0;
    int top = 0;
    int right = -1;
    int bottom = -1;

    bool operator==(const Region&) const = default;
};

// How two pictures of the same size differ. A pixel differs by the greatest difference of its channels.
struct PixelDifference {
    long changed = 0;  // pixels that differ at all
    long over = 0;     // pixels that differ by more than the threshold
    long drawn = 0;    // pixels that differ from the background in either picture
    long gone = 0;     // pixels over the threshold that are background in `actual` only
    long added = 0;    // pixels over the threshold that are background in `expected` only
    int largest = 0;   // greatest difference of a pixel, 0 to 255
    Region region;     // the smallest that holds every pixel over the threshold; of those changed if none is

    bool operator==(const PixelDifference&) const = default;
};

// The background is that of `expected`. Throws std::runtime_error where the sizes differ.
PixelDifference pixel_difference(const Image& expected, const Image& actual, int threshold);

// The colour that most pixels have; of several, the smallest in red, green, blue.
Color background(const Image& image);

}  // namespace ropesim
