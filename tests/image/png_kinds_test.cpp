#include "image/png.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <png.h>
#include <cmath>

// Every kind of PNG that there is (Portable Network Graphics, 2nd edition, 2003, section 11.2.2), written
// by libpng from samples of which the colours are known.

namespace ropesim {
namespace {

using Bytes = std::vector<std::uint8_t>;

constexpr int width = 13;
constexpr int height = 11;

struct Kind {
    int color_type;
    int depth;
    int interlace;
};

int channels(const Kind& kind) {
    switch (kind.color_type) {
        case PNG_COLOR_TYPE_GRAY_ALPHA:
            return 2;
        case PNG_COLOR_TYPE_RGB:
            return 3;
        case PNG_COLOR_TYPE_RGB_ALPHA:
            return 4;
        default:
            return 1;
    }
}

int largest_sample(const Kind& kind) {
    return (1 << kind.depth) - 1;
}

// Spread over all of 0 to the largest.
int sample(const Kind& kind, int x, int y, int channel) {
    const int n = (y * width + x) * channels(kind) + channel;
    return static_cast<int>(static_cast<std::uint32_t>(n) * 2654435769U >> (32 - kind.depth));
}

Bytes packed_row(const Kind& kind, int y) {
    const int bits = width * channels(kind) * kind.depth;
    Bytes row(static_cast<std::size_t>(bits + 7) / 8, 0);
    int at = 0;
    for (int i = 0; i < width * channels(kind); ++i) {
        const int value = sample(kind, i / channels(kind), y, i % channels(kind));
        for (int bit = kind.depth - 1; bit >= 0; --bit, ++at) {
            row[static_cast<std::size_t>(at) / 8] |=
                static_cast<std::uint8_t>((value >> bit & 1) << (7 - at % 8));
        }
    }
    return row;
}

png_color palette_color(int index) {
    return {static_cast<png_byte>(index), static_cast<png_byte>(255 - index),
            static_cast<png_byte>(7 * index % 256)};
}

png_byte palette_alpha(int index) {
    return static_cast<png_byte>(100 + index);
}

constexpr int palette_alphas = 2;  // of the first colours; the others are opaque

// What is transparent where a kind without an alpha channel has transparency: the colour of this pixel.
constexpr int clear_x = 4;
constexpr int clear_y = 3;

void set_transparency(png_structp png, png_infop info, const Kind& kind) {
    std::array<png_byte, palette_alphas> alphas{palette_alpha(0), palette_alpha(1)};
    png_color_16 clear{};
    const auto at = [&](int channel) {
        return static_cast<png_uint_16>(sample(kind, clear_x, clear_y, channel));
    };
    clear.gray = at(0);
    clear.red = at(0);
    clear.green = at(1);
    clear.blue = at(2);
    const bool palette = kind.color_type == PNG_COLOR_TYPE_PALETTE;
    png_set_tRNS(png, info, palette ? alphas.data() : nullptr, palette ? palette_alphas : 0, &clear);
}

void append(png_structp png, png_bytep data, std::size_t size) {
    auto* file = static_cast<Bytes*>(png_get_io_ptr(png));
    file->insert(file->end(), data, data + size);
}

Bytes written(const Kind& kind, bool transparency) {
    Bytes file;
    png_structp png = png_create_write_struct(PNG_LIBPNG_VER_STRING, nullptr, nullptr, nullptr);
    png_infop info = png_create_info_struct(png);
    png_set_write_fn(png, &file, append, nullptr);
    png_set_IHDR(png, info, width, height, kind.depth, kind.color_type, kind.interlace, 0, 0);
    if (kind.color_type == PNG_COLOR_TYPE_PALETTE) {
        std::vector<png_color> palette;
        for (int i = 0; i <= largest_sample(kind); ++i) palette.push_back(palette_color(i));
        png_set_PLTE(png, info, palette.data(), static_cast<int>(palette.size()));
    }
    if (transparency) set_transparency(png, info, kind);
    png_set_gAMA(png, info, 1.0);  // says how to show it; the samples stay what they are
    png_write_info(png, info);
    std::vector<Bytes> rows;
    for (int y = 0; y < height; ++y) rows.push_back(packed_row(kind, y));
    std::vector<png_bytep> pointers;
    for (Bytes& row : rows) pointers.push_back(row.data());
    png_write_image(png, pointers.data());
    png_write_end(png, info);
    png_destroy_write_struct(&png, &info);
    return file;
}

int eight_bits(const Kind& kind, int value) {
    return static_cast<int>(std::lround(255.0 * value / largest_sample(kind)));
}

Color over_black(Color color, int alpha) {
    for (std::uint8_t& channel : color) {
        channel = static_cast<std::uint8_t>(std::lround(channel * alpha / 255.0));
    }
    return color;
}

bool is_clear(const Kind& kind, int x, int y) {
    for (int channel = 0; channel < channels(kind); ++channel) {
        if (sample(kind, x, y, channel) != sample(kind, clear_x, clear_y, channel)) return false;
    }
    return true;
}

Color expected_color(const Kind& kind, bool transparency, int x, int y) {
    const auto at = [&](int channel) { return eight_bits(kind, sample(kind, x, y, channel)); };
    const auto color = [](int red, int green, int blue) {
        return Color{static_cast<std::uint8_t>(red), static_cast<std::uint8_t>(green),
                     static_cast<std::uint8_t>(blue)};
    };
    if (kind.color_type == PNG_COLOR_TYPE_PALETTE) {
        const int index = sample(kind, x, y, 0);
        const png_color entry = palette_color(index);
        const int alpha = transparency && index < palette_alphas ? palette_alpha(index) : 255;
        return over_black(color(entry.red, entry.green, entry.blue), alpha);
    }
    if (transparency && is_clear(kind, x, y)) return {0, 0, 0};
    switch (channels(kind)) {
        case 1:
            return color(at(0), at(0), at(0));
        case 2:
            return over_black(color(at(0), at(0), at(0)), at(1));
        case 3:
            return color(at(0), at(1), at(2));
        default:
            return over_black(color(at(0), at(1), at(2)), at(3));
    }
}

void expect_colors(const Kind& kind, bool transparency) {
    const Image image = decode_png(written(kind, transparency), "memory");
    ASSERT_EQ(image.width, width);
    ASSERT_EQ(image.height, height);
    for (int y = 0; y < height; ++y) {
        for (int x = 0; x < width; ++x) {
            EXPECT_EQ(pixel(image, x, y), expected_color(kind, transparency, x, y))
                << "color type " << kind.color_type << ", depth " << kind.depth << ", interlace "
                << kind.interlace << ", transparency " << transparency << " at " << x << ", " << y;
        }
    }
}

std::vector<Kind> all_kinds() {
    std::vector<Kind> kinds;
    for (const int interlace : {PNG_INTERLACE_NONE, PNG_INTERLACE_ADAM7}) {
        for (const int depth : {1, 2, 4, 8, 16}) {
            kinds.push_back({PNG_COLOR_TYPE_GRAY, depth, interlace});
            if (depth <= 8) kinds.push_back({PNG_COLOR_TYPE_PALETTE, depth, interlace});
            if (depth < 8) continue;
            kinds.push_back({PNG_COLOR_TYPE_GRAY_ALPHA, depth, interlace});
            kinds.push_back({PNG_COLOR_TYPE_RGB, depth, interlace});
            kinds.push_back({PNG_COLOR_TYPE_RGB_ALPHA, depth, interlace});
        }
    }
    return kinds;
}

TEST(PngKinds, EachIsReadAsEightBitsARedGreenBlue) {
    ASSERT_EQ(all_kinds().size(), 30U);  // the fifteen of the standard, interlaced and not
    for (const Kind& kind : all_kinds()) expect_colors(kind, false);
}

TEST(PngKinds, TransparentPixelsLieOverBlack) {
    for (const Kind& kind : all_kinds()) {
        if ((kind.color_type & PNG_COLOR_MASK_ALPHA) == 0) expect_colors(kind, true);
    }
}

}  // namespace
}  // namespace ropesim
