#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace ropesim {

// Red, green, blue; sRGB bytes.
using Color = std::array<std::uint8_t, 3>;

// An 8-bit RGB picture: rows from top to bottom, three bytes a pixel, no padding.
struct Image {
    int width = 0;
    int height = 0;
    std::vector<std::uint8_t> rgb;  // width * height * 3 bytes

    bool operator==(const Image&) const = default;
};

// A picture of one colour.
Image filled(int width, int height, Color color);

// The pixel in column x of row y (from the top).
Color pixel(const Image& image, int x, int y);
void set_pixel(Image& image, int x, int y, Color color);

// Copies a picture into another, its top left pixel to column `left` of row `top`. It must fit in.
void paste(const Image& from, Image& onto, int left, int top);

}  // namespace ropesim
