#include "image/image.h"

#include <algorithm>
#include <cassert>

namespace ropesim {

namespace {

std::size_t offset(const Image& image, int x, int y) {
    assert(0 <= x && x < image.width && 0 <= y && y < image.height);
    return 3 * (static_cast<std::size_t>(y) * static_cast<std::size_t>(image.width) +
                static_cast<std::size_t>(x));
}

}  // namespace

Image filled(int width, int height, Color color) {
    assert(width >= 0 && height >= 0);
    const std::size_t pixels = static_cast<std::size_t>(width) * static_cast<std::size_t>(height);
    Image image{width, height, std::vector<std::uint8_t>(3 * pixels)};
    for (std::size_t i = 0; i < pixels; ++i) {
        for (std::size_t channel = 0; channel < 3; ++channel) image.rgb[3 * i + channel] = color[channel];
    }
    return image;
}

Color pixel(const Image& image, int x, int y) {
    const std::size_t i = offset(image, x, y);
    return {image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]};
}

void set_pixel(Image& image, int x, int y, Color color) {
    const std::size_t i = offset(image, x, y);
    for (std::size_t channel = 0; channel < 3; ++channel) image.rgb[i + channel] = color[channel];
}

void paste(const Image& from, Image& onto, int left, int top) {
    for (int y = 0; y < from.height; ++y) {
        const auto source = from.rgb.begin() + std::ptrdiff_t{3} * y * from.width;
        const auto target = onto.rgb.begin() + std::ptrdiff_t{3} * ((top + y) * onto.width + left);
        std::copy_n(source, 3 * from.width, target);
    }
}

}  // namespace ropesim
