#include "image/pictures.h"
#include "image/png.h"
#include "image/png_chunks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>
#include <algorithm>
#include <functional>

namespace ropesim {
namespace {

using Bytes = std::vector<std::uint8_t>;
using testing::AllOf;
using testing::HasSubstr;
using testing::StartsWith;

Bytes small_file() {
    return encode_png(ropes(9, 8, {3, 4, 5}), {{"title", "Störmer"}});
}

// The file with the chunks of one type changed, and checksums to match.
Bytes with_chunk(const Bytes& file, std::string_view type, const std::function<void(Bytes&)>& change) {
    Bytes changed(png_signature.begin(), png_signature.end());
    for (const Chunk& chunk : png_chunks(file, "original")) {
        Bytes data(chunk.data.begin(), chunk.data.end());
        if (chunk.type == type) change(data);
        append_chunk(changed, chunk.type, data);
    }
    return changed;
}

Bytes without_chunk(const Bytes& file, std::string_view type) {
    Bytes changed(png_signature.begin(), png_signature.end());
    for (const Chunk& chunk : png_chunks(file, "original")) {
        if (chunk.type != type) append_chunk(changed, chunk.type, chunk.data);
    }
    return changed;
}

Bytes with_size(const Bytes& file, std::uint32_t width, std::uint32_t height) {
    return with_chunk(file, "IHDR", [&](Bytes& data) {
        Bytes size;
        append_number(size, width);
        append_number(size, height);
        std::ranges::copy(size, data.begin());
    });
}

Bytes with_pixels(const Bytes& file, const Bytes& rows) {
    return with_chunk(file, "IDAT", [&](Bytes& data) {
        uLongf size = compressBound(static_cast<uLong>(rows.size()));
        data.resize(size);
        compress(data.data(), &size, rows.data(), static_cast<uLong>(rows.size()));
        data.resize(size);
    });
}

void expect_refused(const Bytes& file, const std::string& found) {
    EXPECT_THAT([&] { decode_png(file, "frame.png"); },
                testing::ThrowsMessage<std::runtime_error>(
                    AllOf(StartsWith("frame.png: "), HasSubstr(found), HasSubstr("expected"))));
}

void expect_texts_refused(const Bytes& file) {
    EXPECT_THROW(decode_png_texts(file, "frame.png"), std::runtime_error);
}

TEST(PngDamage, WhatIsNoPngIsRefused) {
    expect_refused({}, "0 bytes");
    expect_refused({'G', 'I', 'F', '8', '9', 'a', 0, 0, 0, 0}, "do not begin with the PNG signature");
    expect_texts_refused({});
}

TEST(PngDamage, AFileCutOffAnywhereIsRefused) {
    const Bytes file = small_file();
    for (std::size_t size = 0; size < file.size(); ++size) {
        const Bytes cut(file.begin(), file.begin() + static_cast<std::ptrdiff_t>(size));
        expect_refused(cut, std::to_string(size) + " bytes");
        expect_texts_refused(cut);
    }
}

TEST(PngDamage, EachDamagedByteIsNoticed) {
    const Bytes file = small_file();
    for (std::size_t i = 0; i < file.size(); ++i) {
        for (const int flipped : {1, 0x20, 0x80, 0xff}) {
            Bytes damaged = file;
            damaged[i] = static_cast<std::uint8_t>(damaged[i] ^ flipped);
            EXPECT_THROW(decode_png(damaged, "frame.png"), std::runtime_error) << i;
            EXPECT_THROW(decode_png_texts(damaged, "frame.png"), std::runtime_error) << i;
        }
    }
}

TEST(PngDamage, BytesAfterTheEndAreRefused) {
    Bytes file = small_file();
    file.push_back(0);
    expect_refused(file, "1 bytes after IEND");
}

TEST(PngDamage, MissingChunksAreRefused) {
    expect_refused(without_chunk(small_file(), "IHDR"), "IHDR");
    expect_refused(without_chunk(small_file(), "IDAT"), "no IDAT");
    expect_refused(without_chunk(small_file(), "IEND"), "cut off");
}

TEST(PngDamage, SizesBeyondTheLimitsAreRefusedBeforeMemoryIsTaken) {
    expect_refused(with_size(small_file(), 65536, 1), "65536x1 pixels");
    expect_refused(with_size(small_file(), 1, 65536), "1x65536 pixels");
    expect_refused(with_size(small_file(), 0, 8), "0x8 pixels");
    expect_refused(with_size(small_file(), 65535, 65535), "65535x65535 pixels");
    expect_refused(with_size(small_file(), 0xffffffff, 0xffffffff), "4294967295x4294967295 pixels");
}

TEST(PngDamage, APictureThatItsBytesCannotHoldIsRefused) {
    expect_refused(with_size(small_file(), 60000, 4000), "enough for 60000x4000 pixels");
}

TEST(PngDamage, TheBestCompressedPictureIsNotMistakenForABomb) {
    const Image image = filled(4000, 3000, {0, 0, 0});
    const Bytes rows((3 * 4000 + 1) * 3000, 0);
    EXPECT_TRUE(decode_png(with_pixels(encode_png(image, {}), rows), "frame.png") == image);
}

TEST(PngDamage, TooFewPixelsAreRefused) {
    expect_refused(with_pixels(small_file(), Bytes((3 * 9 + 1) * 8 - 1, 0)), "libpng: ");
    expect_refused(with_size(small_file(), 9, 9), "libpng: ");
}

TEST(PngDamage, TooManyPixelsAreRefused) {
    expect_refused(with_pixels(small_file(), Bytes((3 * 9 + 1) * 9, 0)), "libpng: ");
}

TEST(PngDamage, AWrongChecksumOfThePixelsIsRefused) {
    expect_refused(with_chunk(small_file(), "IDAT", [](Bytes& data) { data.back() ^= 1; }), "libpng: ");
}

TEST(PngDamage, AnUnknownKindIsRefused) {
    const auto refuse = [](std::size_t place, std::uint8_t value) {
        expect_refused(with_chunk(small_file(), "IHDR", [&](Bytes& data) { data[place] = value; }),
                       "libpng: ");
    };
    refuse(8, 5);   // depth
    refuse(9, 1);   // colour type
    refuse(10, 1);  // compression
    refuse(11, 1);  // filter
    refuse(12, 2);  // interlace
}

// Here the checksums do not help: what libpng makes of it is a picture of that size or an error.
TEST(PngDamage, WhateverTheChunksHoldItIsReadOrRefused) {
    const Bytes file = small_file();
    for (const std::string_view type : {"IHDR", "IDAT", "iTXt"}) {
        std::size_t size = 0;
        with_chunk(file, type, [&](Bytes& data) { size = data.size(); });
        for (std::size_t i = 0; i < size; ++i) {
            for (int flipped = 1; flipped < 256; flipped = 2 * flipped + 1) {
                const Bytes damaged = with_chunk(
                    file, type, [&](Bytes& data) { data[i] = static_cast<std::uint8_t>(data[i] ^ flipped); });
                try {
                    const Image image = decode_png(damaged, "frame.png");
                    EXPECT_EQ(image.rgb.size(), static_cast<std::size_t>(3 * image.width * image.height));
                } catch (const std::runtime_error& error) {
                    EXPECT_THAT(error.what(), StartsWith("frame.png: "));
                }
            }
        }
    }
}

}  // namespace
}  // namespace ropesim
