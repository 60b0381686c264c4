#pragma once

#include "clip/frames.h"
#include "scene/scene.h"
#include "simulation/rope.h"

#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace ropesim {

// Where the masses are: per frame and rope (in the order of the scene), masses×2 in world units. A rope that
// has no rows in a frame has diverged before.
using Positions = std::map<long, std::vector<Points>>;

// CSV: this line, then one line per mass with 17 significant digits, so that reading it back gives the same
// doubles. Names with commas or quotes are quoted as in RFC 4180.
inline constexpr std::string_view positions_csv_header = "frame,rope,node,x,y";
std::string csv_lines(const Scene& scene, long frame, const std::vector<Points>& positions);
std::string to_csv(const Scene& scene, const Positions& positions);

// Reads CSV, or NumPy's format: one array per rope, one after the other in one file (frames × nodes × 2,
// float64, as repeated numpy.load calls on the open file read them); frames from 0 on. Throws
// std::runtime_error, "<name>:<line>: what was found, what was expected", where the file does not fit the
// scene's ropes or a number is not finite.
Positions parse_positions(const Scene& scene, std::string_view bytes, std::string_view name);

// The same from a file, and the digest of its bytes.
struct PositionsFile {
    Positions positions;
    std::string digest;
};
PositionsFile read_positions(const Scene& scene, const std::filesystem::path& path);

// Throws std::runtime_error, "<name>: what is missing", where they have not all of these frames.
void check_frames(const Positions& positions, const FrameList& frames, std::string_view name);

}  // namespace ropesim
