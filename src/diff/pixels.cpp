#include "diff/pixels.h"

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <map>
#include <stdexcept>
#include <string>

namespace ropesim {
namespace {

std::string size(const Image& image) {
    return std::to_string(image.width) + "x" + std::to_string(image.height);
}

void include(Region& region, int x, int y) {
    if (region.right < region.left) region = {x, y, x, y};
    region.left = std::min(region.left, x);
    region.right = std::max(region.right, x);
    region.top = std::min(region.top, y);
    region.bottom = std::max(region.bottom, y);
}

const std::uint8_t* row(const Image& image, int y) {
    return image.rgb.data() + 3 * static_cast<std::size_t>(image.width) * static_cast<std::size_t>(y);
}

int change(const std::uint8_t* a, const std::uint8_t* b) {
    return std::max({std::abs(a[0] - b[0]), std::abs(a[1] - b[1]), std::abs(a[2] - b[2])});
}

// What one row adds: of most pictures, most rows are equal and all background.
class Counter {
  public:
    Counter(const Image& expected, int threshold)
        : background_(background(expected)), width_(expected.width), threshold_(threshold) {
        for (int x = 0; x < width_; ++x) plain_.insert(plain_.end(), background_.begin(), background_.end());
    }

    void add_row(const std::uint8_t* expected, const std::uint8_t* actual, int y) {
        if (std::memcmp(expected, actual, plain_.size()) == 0) {
            if (std::memcmp(expected, plain_.data(), plain_.size()) == 0) return;
            for (int x = 0; x < width_; ++x) found_.drawn += is_drawn(expected + 3L * x);
            return;
        }
        for (int x = 0; x < width_; ++x) add_pixel(expected + 3L * x, actual + 3L * x, x, y);
    }

    PixelDifference found() const {
        PixelDifference found = found_;
        if (found.over == 0) found.region = of_changed_;
        return found;
    }

  private:
    bool is_drawn(const std::uint8_t* pixel) const {
        return std::memcmp(pixel, background_.data(), background_.size()) != 0;
    }

    void add_pixel(const std::uint8_t* expected, const std::uint8_t* actual, int x, int y) {
        const bool in_expected = is_drawn(expected);
        const bool in_actual = is_drawn(actual);
        found_.drawn += in_expected || in_actual;
        const int by = change(expected, actual);
        if (by == 0) return;
        ++found_.changed;
        found_.largest = std::max(found_.largest, by);
        include(of_changed_, x, y);
        if (by <= threshold_) return;
        ++found_.over;
        found_.gone += in_expected && !in_actual;
        found_.added += in_actual && !in_expected;
        include(found_.region, x, y);
    }

    Color background_;
    int width_;
    int threshold_;
    std::vector<std::uint8_t> plain_;  // a row of background
    PixelDifference found_;
    Region of_changed_;
};

}  // namespace

Color background(const Image& image) {
    std::map<Color, long> pixels;
    const std::size_t size = image.rgb.size();
    for (std::size_t i = 0; i < size;) {
        std::size_t end = i + 3;
        while (end < size && std::memcmp(&image.rgb[i], &image.rgb[end], 3) == 0) end += 3;
        pixels[{image.rgb[i], image.rgb[i + 1], image.rgb[i + 2]}] += static_cast<long>(end - i);
        i = end;
    }
    const auto most = std::ranges::max_element(pixels, {}, [](const auto& each) { return each.second; });
    return most->first;
}

PixelDifference pixel_difference(const Image& expected, const Image& actual, int threshold) {
    if (expected.width != actual.width || expected.height != actual.height)
        throw std::runtime_error("pictures to compare: found " + size(actual) + " pixels, expected " +
                                 size(expected));
    if (expected.rgb == actual.rgb) return {};
    Counter counter(expected, threshold);
    for (int y = 0; y < expected.height; ++y) counter.add_row(row(expected, y), row(actual, y), y);
    return counter.found();
}

}  // namespace ropesim
