#include "image/png.h"

#include "image/compact_png.h"
#include "image/pictures.h"

#include <gtest/gtest.h>
#include <png.h>

namespace ropesim {
namespace {

using Bytes = std::vector<std::uint8_t>;

// The picture by libpng's own simplified reader; empty where it has anything to complain about.
Image read_by_libpng(const Bytes& file) {
    png_image reader{};
    reader.version = PNG_IMAGE_VERSION;
    png_image_begin_read_from_memory(&reader, file.data(), file.size());
    reader.format = PNG_FORMAT_RGB;
    Image image{static_cast<int>(reader.width), static_cast<int>(reader.height),
                Bytes(std::size_t{3} * reader.width * reader.height)};
    png_image_finish_read(&reader, nullptr, image.rgb.data(), 0, nullptr);
    return reader.warning_or_error == 0 ? image : Image{};
}

std::size_t size_by_libpng(const Image& image) {
    png_image writer{};
    writer.version = PNG_IMAGE_VERSION;
    writer.width = static_cast<png_uint_32>(image.width);
    writer.height = static_cast<png_uint_32>(image.height);
    writer.format = PNG_FORMAT_RGB;
    png_alloc_size_t size = 0;
    png_image_write_to_memory(&writer, nullptr, &size, 0, image.rgb.data(), 0, nullptr);
    return size;
}

void expect_round_trip(const Image& image) {
    const Bytes file = encode_png(image, {});
    EXPECT_TRUE(decode_png(file, "memory") == image) << image.width << "x" << image.height;
    EXPECT_TRUE(read_by_libpng(file) == image) << image.width << "x" << image.height;
}

// Stretches of a few colours, some as in the row above.
Image stretches(int width, int height, std::uint32_t seed) {
    const Image random = noise(width, height, seed);
    Image image = random;
    for (std::size_t i = 3; i < image.rgb.size(); i += 3) {
        const std::size_t stride = 3 * static_cast<std::size_t>(width);
        const int choice = random.rgb[i];
        const std::size_t back = choice < 200 ? 3 : choice < 240 ? stride : 0;
        for (std::size_t channel = 0; channel < 3 && back <= i; ++channel) {
            image.rgb[i + channel] = image.rgb[i + channel - back];
        }
    }
    return image;
}

TEST(Png, GivesBackEveryPicture) {
    for (const int width : {1, 2, 3, 5, 64, 85, 86, 87, 88, 171, 173, 258, 1000}) {
        for (const int height : {1, 2, 7, 40}) {
            expect_round_trip(noise(width, height, 1));
            expect_round_trip(gradient(width, height));
            expect_round_trip(stretches(width, height, 2));
            expect_round_trip(ropes(width, height, {0, 0, 0}));
            expect_round_trip(ropes(width, height, {250, 251, 252}));
            expect_round_trip(filled(width, height, {9, 9, 9}));
        }
    }
}

TEST(Png, GivesBackTallAndWidePictures) {
    for (const int length : {10922, 10923, 10924, 65535}) {
        expect_round_trip(stretches(length, 3, 3));
        expect_round_trip(stretches(3, length, 4));
        expect_round_trip(ropes(length, 5, {1, 2, 3}));
        expect_round_trip(noise(1, length, 5));
        expect_round_trip(noise(length, 1, 6));
    }
}

TEST(Png, GivesBackAFrame) {
    expect_round_trip(ropes(1280, 720, {0, 0, 0}));
    expect_round_trip(ropes(1280, 720, {20, 30, 40}));
    expect_round_trip(gradient(1280, 720));
    expect_round_trip(noise(1280, 720, 8));
}

TEST(Png, OfAFrameIsAtMostTwiceTheSizeOfLibpngs) {
    for (const Color background : {Color{0, 0, 0}, Color{255, 255, 255}, Color{20, 30, 40}}) {
        for (const Image& image :
             {ropes(1280, 720, background), ropes(960, 640, background), filled(1280, 720, background)}) {
            EXPECT_LE(encode_png(image, {}).size(), 2 * size_by_libpng(image));
        }
    }
}

TEST(CompactPng, GivesBackEveryPicture) {
    for (const int width : {1, 2, 64, 171}) {
        for (const int height : {1, 2, 40}) {
            for (const Image& image : {noise(width, height, 1), gradient(width, height),
                                       stretches(width, height, 2), ropes(width, height, {9, 8, 7})}) {
                const Bytes file = encode_compact_png(image, {});
                EXPECT_TRUE(decode_png(file, "memory") == image) << width << "x" << height;
                EXPECT_TRUE(read_by_libpng(file) == image) << width << "x" << height;
            }
        }
    }
}

TEST(CompactPng, GivesBackPicturesThatAreCompressedInPieces) {
    const Image detail = noise(1000, 2200, 3);
    Image image = filled(1000, 2200, {9, 8, 7});
    for (std::size_t i = 0; i < image.rgb.size(); i += 9973) image.rgb[i] = detail.rgb[i];
    const Bytes file = encode_compact_png(image, {});
    EXPECT_TRUE(decode_png(file, "memory") == image);
    EXPECT_TRUE(read_by_libpng(file) == image);
}

TEST(CompactPng, IsSmallerThanLibpngs) {
    for (const Color background : {Color{0, 0, 0}, Color{20, 30, 40}}) {
        const Image image = ropes(640, 360, background);
        EXPECT_LT(encode_compact_png(image, {}).size(), size_by_libpng(image));
    }
}

TEST(CompactPng, HasTheSameTexts) {
    const Texts texts{{"title", "two ropes"}, {"scene", std::string(1000, 'x')}};
    EXPECT_EQ(decode_png_texts(encode_compact_png(filled(2, 2, {1, 2, 3}), texts), "memory"), texts);
}

TEST(Png, IsNeverMuchLargerThanThePicture) {
    for (const Image& image : {noise(1, 1, 1), noise(100, 100, 2), noise(1280, 720, 3), noise(4, 4000, 4)}) {
        const std::size_t raw = image.rgb.size() + static_cast<std::size_t>(image.height);
        EXPECT_LE(encode_png(image, {}).size(), raw + raw / 100 + 300);
    }
}

TEST(Png, IsTheSameBytesForTheSamePicture) {
    const Image image = ropes(300, 200, {0, 0, 0});
    const Texts texts{{"title", "two ropes"}, {"scene", std::string(1000, 'x')}};
    const Image copy = image;
    EXPECT_EQ(encode_png(image, texts), encode_png(copy, Texts(texts)));
}

TEST(Png, BeginsAsEveryPngDoes) {
    const Bytes file = encode_png(filled(2, 2, {1, 2, 3}), {});
    EXPECT_TRUE(is_png(file));
    EXPECT_TRUE(is_png(std::span(file).first(8)));
    EXPECT_FALSE(is_png(std::span(file).first(7)));
    EXPECT_FALSE(is_png({}));
    EXPECT_FALSE(is_png(Bytes{0xff, 0xd8, 0xff, 0xe0, 0, 0x10, 'J', 'F', 'I', 'F'}));
}

}  // namespace
}  // namespace ropesim
