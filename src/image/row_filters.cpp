#include "image/row_filters.h"

#include <algorithm>
#include <array>
#include <cstdlib>
#include <span>

namespace ropesim {

namespace {

constexpr std::size_t pixel_bytes = 3;
constexpr std::array filters{Filter::none, Filter::sub, Filter::up, Filter::average, Filter::paeth};

int paeth(int left, int above, int corner) {
    const int estimate = left + above - corner;
    const int to_left = std::abs(estimate - left);
    const int to_above = std::abs(estimate - above);
    const int to_corner = std::abs(estimate - corner);
    if (to_left <= to_above && to_left <= to_corner) return left;
    return to_above <= to_corner ? above : corner;
}

int predicted(Filter filter, int left, int above, int corner) {
    switch (filter) {
        case Filter::none:
            return 0;
        case Filter::sub:
            return left;
        case Filter::up:
            return above;
        case Filter::average:
            return (left + above) / 2;
        case Filter::paeth:
            return paeth(left, above, corner);
    }
    return 0;
}

// A row behind the byte that names its filter.
void filter_row(Filter filter, std::span<const std::uint8_t> row, std::span<const std::uint8_t> above,
                std::span<std::uint8_t> filtered) {
    filtered[0] = static_cast<std::uint8_t>(filter);
    for (std::size_t i = 0; i < row.size(); ++i) {
        const int left = i < pixel_bytes ? 0 : row[i - pixel_bytes];
        const int corner = i < pixel_bytes ? 0 : above[i - pixel_bytes];
        filtered[i + 1] = static_cast<std::uint8_t>(row[i] - predicted(filter, left, above[i], corner));
    }
}

// The sum of the bytes as numbers from -128 to 127 without their signs: the measure by which section 12.8
// advises to choose a filter.
long weight(std::span<const std::uint8_t> filtered) {
    long sum = 0;
    for (const std::uint8_t byte : filtered.subspan(1)) sum += byte < 128 ? byte : 256 - byte;
    return sum;
}

}  // namespace

std::vector<std::uint8_t> filtered_rows(const Image& image, int begin, int end,
                                        std::optional<Filter> filter) {
    const std::size_t stride = pixel_bytes * static_cast<std::size_t>(image.width);
    const auto row_of_picture = [&](int y) {
        return std::span(image.rgb).subspan(static_cast<std::size_t>(y) * stride, stride);
    };
    const std::vector<std::uint8_t> nothing(stride, 0);
    std::vector<std::uint8_t> tried(1 + stride);
    std::vector<std::uint8_t> rows((1 + stride) * static_cast<std::size_t>(end - begin));
    std::span<const std::uint8_t> above = begin > 0 ? row_of_picture(begin - 1) : nothing;
    for (int y = begin; y < end; ++y) {
        const auto row = row_of_picture(y);
        const auto kept =
            std::span(rows).subspan(static_cast<std::size_t>(y - begin) * (1 + stride), 1 + stride);
        filter_row(filter.value_or(Filter::none), row, above, kept);
        for (const Filter other : filters) {
            if (filter) break;
            filter_row(other, row, above, tried);
            if (weight(tried) < weight(kept)) std::ranges::copy(tried, kept.begin());
        }
        above = row;
    }
    return rows;
}

}  // namespace ropesim
