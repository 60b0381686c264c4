#pragma once

#include "image/image.h"

namespace ropesim {

// How two pictures of the same size differ.
struct Difference {
    long pixels = 0;  // how many differ in any channel
    int largest = 0;  // greatest difference of a channel, 0 to 255
    int x = 0;        // a pixel where it is reached: the first in reading order
    int y = 0;
};

// Throws std::runtime_error where the sizes differ.
Difference difference(const Image& expected, const Image& actual);

// A picture of it: what agrees is dimmed, what differs is bright: red where only `expected` is drawn
// (brighter than `actual`), green where only `actual` is, scaled so that a difference of 1 can be seen.
Image difference_picture(const Image& expected, const Image& actual);

}  // namespace ropesim
