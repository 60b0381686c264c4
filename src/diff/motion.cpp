#include "diff/motion.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <cstring>

namespace ropesim {
namespace {

bool same_bits(const Points& a, const Points& b) {
    return a.size() == 0 ||
           std::memcmp(a.data(), b.data(), sizeof(double) * static_cast<std::size_t>(a.size())) == 0;
}

// The farthest mass of a rope in a frame.
Moved farthest_mass(const Points& expected, const Points& actual) {
    Moved moved;
    moved.distance = (actual - expected).square().rowwise().sum().sqrt().maxCoeff(&moved.mass);
    return moved;
}

const Points* points_of(const std::string& rope, const Scene& scene, const std::vector<Points>& frame) {
    for (std::size_t i = 0; i < scene.ropes.size(); ++i)
        if (scene.ropes[i].name == rope) return &frame[i];
    return nullptr;
}

void add_once(std::vector<std::string>& names, const std::string& name) {
    if (std::ranges::find(names, name) == names.end()) names.push_back(name);
}

}  // namespace

std::string to_string(const Moved& moved) {
    std::array<char, 32> pixels;
    std::snprintf(pixels.data(), pixels.size(), "%.3g px", moved.distance);
    return "in frame " + std::to_string(moved.frame) + ", mass " + std::to_string(moved.mass) + " of rope '" +
           moved.rope + "', by " + pixels.data();
}

MotionDifference motion_difference(const Scene& expected_scene, const Positions& expected,
                                   const Scene& actual_scene, const Positions& actual) {
    const double pixels = expected_scene.size[1] / expected_scene.view.height;
    MotionDifference result;
    for (const auto& [frame, ropes] : expected) {
        const auto there = actual.find(frame);
        if (there == actual.end()) continue;
        std::optional<Moved> farthest;
        for (std::size_t i = 0; i < ropes.size(); ++i) {
            const std::string& rope = expected_scene.ropes[i].name;
            const Points* points = points_of(rope, actual_scene, there->second);
            if (!points || points->rows() != ropes[i].rows()) {
                add_once(result.apart, rope);
                continue;
            }
            if (same_bits(ropes[i], *points)) continue;
            const Moved moved = farthest_mass(ropes[i], *points);
            const double distance = moved.distance * pixels;
            if (!farthest || distance > farthest->distance)
                farthest = Moved{frame, rope, moved.mass, distance};
        }
        result.distance[frame] = farthest ? farthest->distance : 0.0;
        if (!farthest) continue;
        if (!result.first) result.first = farthest;
        if (!result.farthest || farthest->distance > result.farthest->distance) result.farthest = farthest;
    }
    return result;
}

}  // namespace ropesim
