#include "image/pictures.h"
#include "image/png.h"
#include "image/png_chunks.h"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <zlib.h>
#include <random>

namespace ropesim {
namespace {

using Bytes = std::vector<std::uint8_t>;
using namespace std::string_literals;

Bytes bytes_of(const std::string& text) {
    return Bytes(text.begin(), text.end());
}

std::string zlib_packed(const std::string& text) {
    uLongf size = compressBound(static_cast<uLong>(text.size()));
    std::string packed(size, '\0');
    compress(reinterpret_cast<Bytef*>(packed.data()), &size, reinterpret_cast<const Bytef*>(text.data()),
             static_cast<uLong>(text.size()));
    packed.resize(size);
    return packed;
}

// A file with one more chunk, before its end.
Bytes with_chunk(std::string_view type, const std::string& data) {
    Bytes file = encode_png(noise(3, 3, 1), {});
    file.resize(file.size() - 12);
    append_chunk(file, type, bytes_of(data));
    append_chunk(file, "IEND", {});
    return file;
}

Texts read(std::string_view type, const std::string& data) {
    return decode_png_texts(with_chunk(type, data), "frame.png");
}

void expect_refused(std::string_view type, const std::string& data, const std::string& found) {
    EXPECT_THAT([&] { read(type, data); }, testing::ThrowsMessage<std::runtime_error>(testing::AllOf(
                                               testing::StartsWith("frame.png: "), testing::HasSubstr(found),
                                               testing::HasSubstr("expected"))));
}

// Words in random order, which compress as a scene does; lines repeat at every distance up to its length.
std::string long_text(std::size_t size) {
    std::mt19937 random(1);
    std::string text;
    while (text.size() < size) text += "stiffness = " + std::to_string(random() % 1000) + ".0 # größer\n";
    return text;
}

std::string random_text(std::size_t size) {
    std::mt19937 random(2);
    std::string text;
    while (text.size() < size) text += static_cast<char>(1 + random() % 127);
    return text;
}

void expect_round_trip(const Texts& texts) {
    const Bytes file = encode_png(noise(3, 2, 1), texts);
    EXPECT_TRUE(decode_png_texts(file, "frame.png") == texts);
    EXPECT_TRUE(decode_png(file, "frame.png") == noise(3, 2, 1));
}

TEST(PngTexts, AreGivenBack) {
    expect_round_trip({});
    expect_round_trip({{"frame", "17"}, {"title", "Störmer–Verlet ≠ 显式"}, {"empty", ""}});
    expect_round_trip({{std::string(79, 'k'), "the longest keyword"}});
    expect_round_trip({{"scene", long_text(100000)}});
    expect_round_trip({{"scene", random_text(100000)}});
    expect_round_trip({{"scene", std::string(100000, ' ')}});
}

TEST(PngTexts, OfEverySmallSizeAreGivenBack) {
    for (std::size_t size = 0; size < 600; ++size) {
        expect_round_trip({{"repeated", std::string(size, 'x')}, {"scene", long_text(600).substr(0, size)}});
    }
}

TEST(PngTexts, AreCompressedWhereThatIsShorter) {
    const std::size_t without = encode_png(noise(3, 2, 1), {}).size();
    const std::string text = long_text(20000);
    const std::size_t chunk = 12 + 5 + 5;  // around the text: the chunk's frame, its fields, "scene"
    const std::size_t taken = encode_png(noise(3, 2, 1), {{"scene", text}}).size() - without - chunk;
    EXPECT_LT(taken, zlib_packed(text).size() * 11 / 10);
    const std::size_t plain =
        encode_png(noise(3, 2, 1), {{"scene", random_text(30)}}).size() - without - chunk;
    EXPECT_EQ(plain, 30U);
}

TEST(PngTexts, WithoutAKeywordOrWithAZeroAreNotWritten) {
    const Image image = noise(1, 1, 1);
    EXPECT_THROW(encode_png(image, {{"", "text"}}), std::runtime_error);
    EXPECT_THROW(encode_png(image, {{std::string(80, 'k'), "text"}}), std::runtime_error);
    EXPECT_THROW(encode_png(image, {{"a\0b"s, "text"}}), std::runtime_error);
    EXPECT_THROW(encode_png(image, {{"title", "a\0b"s}}), std::runtime_error);
}

TEST(PngTexts, ThatCouldNotBeReadAgainAreNotWritten) {
    const std::string half((std::size_t{32} << 20) + 1, 'x');
    EXPECT_THROW(encode_png(noise(1, 1, 1), {{"a", half}, {"b", half}}), std::runtime_error);
}

TEST(PngTexts, OfAllThreeChunksAreRead) {
    EXPECT_EQ(read("tEXt", "Author\0Ren\xe9"s), (Texts{{"Author", "René"}}));
    EXPECT_EQ(read("zTXt", "Author\0\0"s + zlib_packed("Ren\xe9")), (Texts{{"Author", "René"}}));
    EXPECT_EQ(read("iTXt", "Author\0\0\0fr\0Auteur\0René"s), (Texts{{"Author", "René"}}));
    EXPECT_EQ(read("iTXt", "Author\0\1\0fr\0Auteur\0"s + zlib_packed("René")), (Texts{{"Author", "René"}}));
}

TEST(PngTexts, OfOneKeywordTheFirstCounts) {
    Bytes file = with_chunk("tEXt", "Author\0first"s);
    file.resize(file.size() - 12);
    append_chunk(file, "tEXt", bytes_of("Author\0second"s));
    append_chunk(file, "IEND", {});
    EXPECT_EQ(decode_png_texts(file, "frame.png"), (Texts{{"Author", "first"}}));
}

TEST(PngTexts, AreReadWithoutThePixels) {
    const Bytes whole = encode_png(noise(3, 3, 1), {{"title", "x"}});
    Bytes file(png_signature.begin(), png_signature.end());
    for (const Chunk& chunk : png_chunks(whole, "whole")) {
        append_chunk(file, chunk.type, chunk.type == "IDAT" ? std::span<const std::uint8_t>{} : chunk.data);
    }
    EXPECT_EQ(decode_png_texts(file, "frame.png"), (Texts{{"title", "x"}}));
    EXPECT_THROW(decode_png(file, "frame.png"), std::runtime_error);
}

TEST(PngTexts, ThatAreMalformedAreRefused) {
    expect_refused("tEXt", "no end", "keyword");
    expect_refused("tEXt", "\0text"s, "0 characters");
    expect_refused("tEXt", std::string(80, 'k') + "\0text"s, "80 characters");
    expect_refused("zTXt", "Author\0"s, "compression");
    expect_refused("zTXt", "Author\0\1"s, "method 1");
    expect_refused("zTXt", "Author\0\0no stream"s, "damaged");
    const std::string packed = zlib_packed(long_text(5000));
    expect_refused("zTXt", "Author\0\0"s + packed.substr(0, packed.size() - 1), "damaged");
    expect_refused("iTXt", "Author\0\0\0fr"s, "language");
    expect_refused("iTXt", "Author\0\0\0fr\0Auteur"s, "translated keyword");
}

TEST(PngTexts, ThatUnpackToMoreThanTheLimitAreRefused) {
    const std::string most(std::size_t{64} << 20, 'x');
    EXPECT_EQ(read("zTXt", "Author\0\0"s + zlib_packed(most)).at("Author").size(), most.size());
    expect_refused("zTXt", "Author\0\0"s + zlib_packed(most + "x"), "64 MB");
}

}  // namespace
}  // namespace ropesim
