#pragma once

#include "clip/frames.h"
#include "clip/positions.h"
#include "image/image.h"
#include "scene/scene.h"

#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace ropesim {

// What a folder of golden/ holds: a scene, and of some of its frames the positions and the picture.
struct GoldenCase {
    std::string name;
    Scene scene;
    Positions positions;
    std::map<long, Image> pictures;
};

// The names of all cases: the folders of golden/ with a scene.toml.
std::vector<std::string> golden_cases();

Scene scene_of_case(const std::string& name);

// The case as its files say. Throws std::runtime_error.
GoldenCase stored(const std::string& name);

// The case as the program makes it: these frames of the scene, simulated and drawn.
GoldenCase made(const std::string& name, const Scene& scene, const FrameList& frames);

// The picture of one frame.
Image drawn(const Scene& scene, const std::vector<Points>& positions);

// Writes the pictures and positions of the case into the folder, over what is there.
void store(const GoldenCase& golden, const std::filesystem::path& folder);

// What moved, in words; "" where all is equal, bit for bit.
struct GoldenVerdict {
    std::string positions;
    std::string pixels;
};
GoldenVerdict compare(const GoldenCase& expected, const GoldenCase& actual);

// Leaves the case as it was made in <folder>/<name>/, and <folder>/<name>.html, a report of how it differs
// from the stored one; gives the report's path.
std::filesystem::path leave_report(const GoldenCase& actual, const std::filesystem::path& folder);

// The layouts of comparisons; golden/comparisons/<layout>.png is one of the seed's ropes in each.
std::vector<std::string> comparison_layouts();
Image stored_comparison(const std::string& layout);
Image made_comparison(const std::string& layout);
void store_comparison(const std::string& layout, const Image& picture);

// golden/ of the source tree.
std::filesystem::path golden_folder();

}  // namespace ropesim
