#pragma once

#include "clip/positions.h"
#include "image/image.h"
#include "scene/scene.h"

#include <filesystem>
#include <functional>
#include <vector>

namespace ropesim {

// Draws a frame of a clip, with its ropes at these positions, and writes it to a file.
using MakeFrame =
    std::function<void(long frame, const std::vector<Points>& positions, const std::filesystem::path& path)>;

// Made in the process that is to draw. The scene must outlive it.
using FrameMaker = MakeFrame (*)(const Scene& scene);

MakeFrame by_ropesim(const Scene& scene);

// Our pictures, encoded anew in every frame by libpng as it is.
MakeFrame by_libpng(const Scene& scene);

std::size_t size_by_libpng(const Image& image);

// As a careful user of cairo draws the same picture: one surface, round joins, then round points.
MakeFrame by_cairo(const Scene& scene);

// The same with OpenCV: anti-aliased lines and circles, imwrite as it is.
MakeFrame by_opencv(const Scene& scene);

// What ropesim does for a frame, one part after the other; microseconds for a frame, on average over the
// clip.
struct Stages {
    double clearing = 0.0;
    double drawing = 0.0;
    double reading = 0.0;
    double filtering = 0.0;
    double compressing = 0.0;
    double writing = 0.0;
    double whole = 0.0;  // as it is done, with what is between the parts

    double sum() const { return clearing + drawing + reading + filtering + compressing + writing; }
};
Stages stages(const Scene& scene, const Positions& motion, const std::filesystem::path& folder);

}  // namespace ropesim
