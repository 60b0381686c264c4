#include "image/frame_encoder.h"

#include "image/pictures.h"

#include <gtest/gtest.h>

#include <random>
#include <string>

namespace ropesim {
namespace {

constexpr Color background = {7, 0, 90};

// Lays a part of a picture over another.
void copy(const Image& from, const PixelBox& box, Image& to) {
    for (int y = box.top; y < box.bottom; ++y)
        for (int x = box.left; x < box.right; ++x) set_pixel(to, x, y, pixel(from, x, y));
}

PixelBox random_box(const Image& image, std::mt19937& random) {
    const auto below = [&](int limit) { return static_cast<int>(random() % static_cast<unsigned>(limit)); };
    const int left = below(image.width);
    const int top = below(image.height);
    return {left, top, std::min(image.width, left + 1 + below(70)),
            std::min(image.height, top + 1 + below(70))};
}

// A clip in which boxes of another picture come and go: each frame as it is encoded alone.
void expect_frames_as_if_alone(const Image& other) {
    FrameEncoder encoder(other.width, other.height);
    std::mt19937 random(3);
    Tiles before(other.width, other.height);
    for (int frame = 0; frame < 40; ++frame) {
        Image image = filled(other.width, other.height, background);
        Tiles inked(other.width, other.height);
        for (int boxes = frame % 5; boxes > 0; --boxes) {
            const PixelBox box = random_box(other, random);
            copy(other, box, image);
            inked.add(box);
        }
        Tiles changed = before;
        changed.add(inked);
        before = inked;
        const Texts texts{{"frame", std::to_string(frame)}, {"scene", std::string(300, 'x')}};
        ASSERT_EQ(encoder.encode(image, inked, changed, texts), encode_png(image, texts)) << frame;
        ASSERT_EQ(decode_png(encoder.encode(image, inked, Tiles(other.width, other.height), texts), "again"),
                  image);
    }
}

TEST(FrameEncoder, GivesEachFrameAsIfItWereAlone) {
    for (const auto& [width, height] : {std::pair{200, 150}, {33, 65}, {1, 40}, {300, 1}}) {
        expect_frames_as_if_alone(noise(width, height, 1));
        expect_frames_as_if_alone(gradient(width, height));
        expect_frames_as_if_alone(ropes(width, height, background));
        expect_frames_as_if_alone(ropes(width, height, {0, 0, 0}));
    }
}

TEST(FrameEncoder, TakesWhatDidNotChangeFromTheFrameBefore) {
    FrameEncoder encoder(100, 100);
    Tiles all(100, 100);
    all.add({0, 0, 100, 100});
    const Image image = noise(100, 100, 1);
    const std::vector<std::uint8_t> file = encoder.encode(image, all, all, {});
    EXPECT_EQ(encoder.encode(noise(100, 100, 2), all, Tiles(100, 100), {}), file);
}

}  // namespace
}  // namespace ropesim
