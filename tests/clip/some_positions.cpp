#include "clip/some_positions.h"

#include "clip/file.h"
#include "clip/positions_writer.h"
#include "clip/temporary_folder.h"

#include <gtest/gtest.h>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <random>
#include <stdexcept>

namespace ropesim {

Scene scene_of(const std::vector<std::pair<std::string, int>>& ropes) {
    Scene scene;
    scene.frames = 10;
    for (const auto& [name, nodes] : ropes) {
        SceneRope rope;
        rope.name = name;
        rope.nodes = nodes;
        rope.end = {1.0, 0.0};
        scene.ropes.push_back(rope);
    }
    return scene;
}

namespace {

// Any doubles at all that are finite: random bits.
Points random_points(int masses, std::mt19937_64& random) {
    Points points(masses, 2);
    for (double& number : points.reshaped()) do {
            const std::uint64_t bits = random();
            std::memcpy(&number, &bits, sizeof number);
        } while (!std::isfinite(number));
    return points;
}

}  // namespace

Positions random_positions(const Scene& scene, long frames) {
    std::mt19937_64 random(7);
    Positions positions;
    for (long frame = 0; frame < frames; ++frame)
        for (const SceneRope& rope : scene.ropes)
            positions[frame].push_back(random_points(rope.nodes, random));
    return positions;
}

std::string written(const std::string& extension, const Scene& scene, const Positions& positions) {
    const TemporaryFolder folder;
    const std::string file = folder.path() / ("positions" + extension);
    const auto writer = make_positions_writer(file, scene, parse_frames("", positions.rbegin()->first + 1));
    for (const auto& [frame, ropes] : positions) writer->add(frame, ropes);
    writer->finish();
    const std::vector<std::uint8_t> bytes = read_file(file);
    return {bytes.begin(), bytes.end()};
}

std::string to_npy(const Scene& scene, const Positions& positions) {
    return written(".npy", scene, positions);
}

std::string refusal(const Scene& scene, const std::string& bytes) {
    try {
        parse_positions(scene, bytes, "swing.csv");
        return "";
    } catch (const std::runtime_error& error) {
        return error.what();
    }
}

void expect_same_bits(const Positions& expected, const Positions& actual) {
    ASSERT_EQ(expected.size(), actual.size());
    for (const auto& [frame, ropes] : expected) {
        const std::vector<Points>& others = actual.at(frame);
        ASSERT_EQ(ropes.size(), others.size());
        for (std::size_t i = 0; i < ropes.size(); ++i) {
            ASSERT_EQ(ropes[i].rows(), others[i].rows());
            if (ropes[i].size() == 0) continue;
            EXPECT_EQ(std::memcmp(ropes[i].data(), others[i].data(),
                                  sizeof(double) * static_cast<std::size_t>(ropes[i].size())),
                      0);
        }
    }
}

}  // namespace ropesim
