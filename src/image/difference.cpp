#include "image/difference.h"

#include <algorithm>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace ropesim {

namespace {

std::string size(const Image& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height);
}

void check_sizes(const Image& expected, const Image& actual) {
    if (expected.width == actual.width && expected.height == actual.height) return;
    throw std::runtime_error("pictures to compare: found " + size(actual) + " pixels, expected " +
                             size(expected));
}

int brightest(Color color) {
    return *std::ranges::max_element(color);
}

// How far `a` is brighter than `b` in the channel where it is so most; 0 where it is in none.
int excess(Color a, Color b) {
    return std::max({0, a[0] - b[0], a[1] - b[1], a[2] - b[2]});
}

// A difference of 1 is as bright as half of the largest, of 255: neither is overlooked.
std::uint8_t bright(int excess) {
    return static_cast<std::uint8_t>(excess == 0 ? 0 : 128 + excess / 2);
}

Color difference_color(Color expected, Color actual) {
    if (expected == actual) {
        const auto dimmed = static_cast<std::uint8_t>(brightest(expected) / 4);
        return {dimmed, dimmed, dimmed};
    }
    return {bright(excess(expected, actual)), bright(excess(actual, expected)), 0};
}

}  // namespace

Difference difference(const Image& expected, const Image& actual) {
    check_sizes(expected, actual);
    Difference result;
    if (expected.rgb == actual.rgb) return result;
    for (int y = 0; y < expected.height; ++y) {
        for (int x = 0; x < expected.width; ++x) {
            const Color a = pixel(expected, x, y);
            const Color b = pixel(actual, x, y);
            if (a == b) continue;
            ++result.pixels;
            const int largest = std::max(excess(a, b), excess(b, a));
            if (largest > result.largest) {
                result.largest = largest;
                result.x = x;
                result.y = y;
            }
        }
    }
    return result;
}

Image difference_picture(const Image& expected, const Image& actual) {
    check_sizes(expected, actual);
    Image picture = filled(expected.width, expected.height, {0, 0, 0});
    for (int y = 0; y < expected.height; ++y) {
        for (int x = 0; x < expected.width; ++x) {
            set_pixel(picture, x, y, difference_color(pixel(expected, x, y), pixel(actual, x, y)));
        }
    }
    return picture;
}

}  // namespace ropesim
