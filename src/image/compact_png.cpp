#include "image/compact_png.h"

#include "image/png_chunks.h"
#include "image/png_texts.h"

#include <libdeflate.h>

#include <algorithm>
#include <array>
#include <cstdlib>
#include <memory>
#include <new>
#include <optional>
#include <span>
#include <utility>

namespace ropesim {

namespace {

constexpr std::size_t pixel_bytes = 3;
constexpr int strongest_level = 12;  // of libdeflate

// The filters of Portable Network Graphics, 2nd edition, 2003, section 9.2: a byte less one that is predicted
// from those to its left, above it, and above to its left.
enum class Filter : std::uint8_t { none, sub, up, average, paeth };
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

// All rows, by one filter; or each by the one that makes it lightest.
std::vector<std::uint8_t> filtered(const Image& image, std::optional<Filter> filter) {
    const std::size_t stride = pixel_bytes * static_cast<std::size_t>(image.width);
    const std::vector<std::uint8_t> nothing(stride, 0);
    std::vector<std::uint8_t> tried(1 + stride);
    std::vector<std::uint8_t> rows((1 + stride) * static_cast<std::size_t>(image.height));
    std::span<const std::uint8_t> above = nothing;
    for (std::size_t y = 0; y < static_cast<std::size_t>(image.height); ++y) {
        const auto row = std::span(image.rgb).subspan(y * stride, stride);
        const auto kept = std::span(rows).subspan(y * (1 + stride), 1 + stride);
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

std::vector<std::uint8_t> zlib_stream(std::span<const std::uint8_t> bytes) {
    const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
        libdeflate_alloc_compressor(strongest_level), libdeflate_free_compressor);
    if (!compressor) throw std::bad_alloc();
    const std::size_t most = libdeflate_zlib_compress_bound(compressor.get(), bytes.size());
    // Not a vector, whose zeros would be memory taken: most of it is never written.
    const auto stream = std::make_unique_for_overwrite<std::uint8_t[]>(most);
    const std::size_t size =
        libdeflate_zlib_compress(compressor.get(), bytes.data(), bytes.size(), stream.get(), most);
    return {stream.get(), stream.get() + size};
}

}  // namespace

std::vector<std::uint8_t> encode_compact_png(const Image& image, const Texts& texts) {
    constexpr std::array<std::optional<Filter>, 4> ways{std::nullopt, Filter::none, Filter::sub, Filter::up};
    std::vector<std::uint8_t> shortest;
    for (const std::optional<Filter>& way : ways) {
        std::vector<std::uint8_t> stream = zlib_stream(filtered(image, way));
        if (shortest.empty() || stream.size() < shortest.size()) shortest = std::move(stream);
    }
    std::vector<std::uint8_t> file = begin_of_png(image.width, image.height);
    check_texts(texts);
    for (const auto& [keyword, text] : texts) {
        const std::vector<std::uint8_t> chunk = text_chunk(keyword, text);
        file.insert(file.end(), chunk.begin(), chunk.end());
    }
    append_chunk(file, "IDAT", shortest);
    append_chunk(file, "IEND", {});
    return file;
}

std::string compact_library() {
    return std::string("libdeflate ") + LIBDEFLATE_VERSION_STRING;
}

}  // namespace ropesim
