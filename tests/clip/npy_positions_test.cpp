#include "clip/npy_positions.h"

#include "clip/positions_writer.h"
#include "clip/some_positions.h"
#include "clip/temporary_folder.h"

#include <gmock/gmock.h>
#include <algorithm>
#include <cmath>
#include <cstring>
#include <limits>
#include <span>

namespace ropesim {
namespace {

using testing::HasSubstr;

TEST(NpyPositions, ReadsBackAsTheSameBits) {
    const Scene scene = scene_of({{"a", 3}, {"b", 1000}});
    const Positions positions = random_positions(scene, 7);
    expect_same_bits(positions, parse_positions(scene, to_npy(scene, positions), "npy"));
}

TEST(NpyPositions, BeginsAsNumPyWritesIt) {
    const Scene scene = scene_of({{"a", 2}});
    const std::string bytes = to_npy(scene, random_positions(scene, 3));
    EXPECT_EQ(bytes.substr(0, 8), std::string("\x93NUMPY\x01\x00", 8));
    EXPECT_THAT(bytes, HasSubstr("{'descr': '<f8', 'fortran_order': False, 'shape': (3, 2, 2), }"));
    EXPECT_EQ(bytes.find('\n') % 64, 63u) << "the numbers begin at a multiple of 64";
    EXPECT_EQ(bytes.size(), bytes.find('\n') + 1 + 3 * 2 * 2 * 8);
}

// Where an array is shorter than its room, those behind it move up, also by less than their own length.
TEST(NpyPositions, EndsWhereItsRopeDiverged) {
    const Scene scene = scene_of({{"a", 2}, {"b", 2}, {"c", 5}});
    for (const std::size_t rope : {0U, 1U, 2U}) {
        for (const long last : {1L, 3L}) {
            Positions positions = random_positions(scene, 4);
            for (long frame = last; frame < 4; ++frame) positions[frame][rope] = Points(0, 2);
            expect_same_bits(positions, parse_positions(scene, to_npy(scene, positions), "npy"));
        }
    }
}

TEST(NpyPositions, NeedsEveryFrameFromTheFirstOn) {
    const Scene scene = scene_of({{"a", 2}});
    const TemporaryFolder folder;
    const std::string file = folder.path() / "a.npy";
    EXPECT_NO_THROW(make_positions_writer(file, scene, {0, 1, 2}));
    EXPECT_THROW(make_positions_writer(file, scene, {1, 2}), std::runtime_error);
    EXPECT_THROW(make_positions_writer(file, scene, {0, 2}), std::runtime_error);
}

TEST(NpyPositions, RefusesEveryTruncation) {
    const Scene scene = scene_of({{"a", 2}});
    const std::string bytes = to_npy(scene, random_positions(scene, 2));
    for (std::size_t size = 6; size < bytes.size(); ++size)
        EXPECT_THROW(parse_positions(scene, bytes.substr(0, size), "npy"), std::runtime_error) << size;
}

TEST(NpyPositions, RefusesOtherShapesAndTypes) {
    const Scene scene = scene_of({{"a", 2}});
    const std::string bytes = to_npy(scene, random_positions(scene, 2));
    EXPECT_THAT(refusal(scene_of({{"a", 3}}), bytes),
                HasSubstr("found 2 x 2 x 2, expected 10 x 3 x 2, or fewer frames"));
    std::string other = bytes;
    other.replace(other.find("<f8"), 3, "<f4");
    EXPECT_THAT(refusal(scene, other), HasSubstr("float64"));
    other = bytes;
    other.replace(other.find(", 2), }   "), 10, ", 2, 1), }");
    EXPECT_THAT(refusal(scene, other), HasSubstr("expected arrays of frames x nodes x 2"));
    EXPECT_THAT(refusal(scene, bytes.substr(0, 60)), HasSubstr("ends within its header"));
    EXPECT_THAT(refusal(scene, bytes + bytes), HasSubstr("more arrays than the scene has ropes"));
}

TEST(NpyPositions, RefusesWhatIsNotFinite) {
    Scene scene = scene_of({{"a", 16}});
    scene.frames = 10000;
    for (const double number : {std::numeric_limits<double>::infinity(), std::nan("")}) {
        Positions positions = random_positions(scene, 10000);
        positions[9999][0](1, 1) = number;
        EXPECT_THAT(refusal(scene, to_npy(scene, positions)),
                    HasSubstr("rope 'a': a coordinate of frame 9999 is not finite"));
    }
}

// However long the file is, no more than a megabyte of it is in memory, or a frame; all is read once.
TEST(NpyPositions, AreReadInParts) {
    Scene scene = scene_of({{"a", 16}, {"b", 3}});
    scene.frames = 20000;
    const std::string bytes = to_npy(scene, random_positions(scene, 20000));
    std::size_t most = 0;
    std::size_t read = 0;
    const auto read_at = [&](std::uint64_t offset, std::span<std::uint8_t> part) {
        EXPECT_EQ(offset, read);
        read += part.size();
        most = std::max(most, part.size());
        std::memcpy(part.data(), bytes.data() + offset, part.size());
    };
    const NpyPositions positions(scene, bytes.size(), read_at, "a.npy");
    EXPECT_EQ(read, bytes.size());
    EXPECT_LE(most, std::size_t{1} << 20);
    read = 0;
    positions.at(12345, [&](std::uint64_t, std::span<std::uint8_t> part) { read += part.size(); });
    EXPECT_EQ(read, (16 + 3) * 2 * sizeof(double));
}

}  // namespace
}  // namespace ropesim
