#pragma once

#include "scene/scene.h"
#include "simulation/rope.h"

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

// Reads CSV, or NumPy's format as NpyPositions does, whole. Throws std::runtime_error, "<name>:<line>: what
// was found, what was expected", where the file does not fit the scene's ropes or a number is not finite.
Positions parse_positions(const Scene& scene, std::string_view bytes, std::string_view name);

}  // namespace ropesim
