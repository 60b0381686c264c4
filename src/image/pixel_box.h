#pragma once

namespace ropesim {

// The pixels of columns left to right - 1 and rows top to bottom - 1; none where that is no pixel.
struct PixelBox {
    int left = 0;
    int top = 0;
    int right = 0;
    int bottom = 0;

    bool empty() const { return left >= right || top >= bottom; }
};

// What both hold.
PixelBox intersection(const PixelBox& a, const PixelBox& b);

}  // namespace ropesim
