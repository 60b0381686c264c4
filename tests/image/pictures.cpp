#include "image/pictures.h"

#include <algorithm>
#include <cmath>
#include <random>

namespace ropesim {

namespace {

struct Line {
    double x0, y0, x1, y1;
    Color color;
};

double distance_to(const Line& line, double x, double y) {
    const double dx = line.x1 - line.x0;
    const double dy = line.y1 - line.y0;
    const double along = ((x - line.x0) * dx + (y - line.y0) * dy) / (dx * dx + dy * dy);
    const double t = std::clamp(along, 0.0, 1.0);
    return std::hypot(x - line.x0 - t * dx, y - line.y0 - t * dy);
}

void draw(Image& image, const Line& line) {
    constexpr double radius = 2.0;
    for (int y = 0; y < image.height; ++y) {
        for (int x = 0; x < image.width; ++x) {
            const double coverage = std::clamp(radius + 0.5 - distance_to(line, x + 0.5, y + 0.5), 0.0, 1.0);
            Color color = pixel(image, x, y);
            for (std::size_t i = 0; i < 3; ++i) {
                const double mixed = color[i] + coverage * (line.color[i] - color[i]);
                color[i] = static_cast<std::uint8_t>(std::lround(mixed));
            }
            set_pixel(image, x, y, color);
        }
    }
}

}  // namespace

Image noise(int width, int height, std::uint32_t seed) {
    Image image = filled(width, height, {0, 0, 0});
    std::mt19937 random(seed);
    for (std::uint8_t& byte : image.rgb) byte = static_cast<std::uint8_t>(random() >> 24);
    return image;
}

Image gradient(int width, int height) {
    Image image = filled(width, height, {0, 0, 0});
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            const auto red = static_cast<std::uint8_t>(255 * x / width);
            const auto green = static_cast<std::uint8_t>(255 * y / height);
            set_pixel(image, x, y, {red, green, static_cast<std::uint8_t>((red + green) / 2)});
        }
    }
    return image;
}

Image ropes(int width, int height, Color background) {
    Image image = filled(width, height, background);
    const double w = width;
    const double h = height;
    draw(image, {0.1 * w, 0.2 * h, 0.45 * w, 0.2 * h, {255, 0, 0}});
    draw(image, {0.1 * w, 0.3 * h, 0.6 * w, 0.9 * h, {0, 255, 0}});
    draw(image, {0.8 * w, 0.1 * h, 0.7 * w, 0.8 * h, {255, 255, 255}});
    return image;
}

}  // namespace ropesim
