#pragma once

#include "clip/positions.h"
#include "scene/scene.h"

#include <string>
#include <utility>
#include <vector>

namespace ropesim {

// A scene of ten frames with ropes of these names and numbers of masses.
Scene scene_of(const std::vector<std::pair<std::string, int>>& ropes);

// Any finite doubles at all; the same each time.
Positions random_positions(const Scene& scene, long frames);

// What make_positions_writer makes of them in a file with this extension.
std::string written(const std::string& extension, const Scene& scene, const Positions& positions);
std::string to_npy(const Scene& scene, const Positions& positions);

// Why parse_positions does not read it as "swing.csv"; nothing where it does.
std::string refusal(const Scene& scene, const std::string& bytes);

// A failure of the test unless all bits are the same.
void expect_same_bits(const Positions& expected, const Positions& actual);

}  // namespace ropesim
