#pragma once

#include "simulation/rope.h"

#include <Eigen/Core>

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ropesim {

// What a scene names as method where the program is to choose.
inline constexpr std::string_view auto_method = "auto";

// A rope as a scene describes it; the members are the keys of [[rope]].
struct SceneRope {
    std::string name;
    std::string method = "symplectic_euler";  // or "auto": the cheapest that keeps to the clip's tolerance
    Eigen::Array2d start = {0.0, 0.0};
    std::vector<Eigen::Array2d> via;  // corners on the way from start to end; usually none
    Eigen::Array2d end = {0.0, 0.0};
    int nodes = 16;              // masses, evenly spaced along start, via, end
    double mass = 1.0;           // of each node ...
    std::vector<double> masses;  // ... unless given one by one, with `mass` as it is here
    double stiffness = 100.0;
    std::optional<double> rest_length;   // of each link; without it, the spacing at the start
    std::vector<int> pinned = {0};       // -1 is the last node, -2 the one before
    double damping = 0.0;                // rate, per unit of time
    double damping_factor = 0.0;         // the seed's: share of the velocity lost in each step
    std::optional<int> steps_per_frame;  // of this rope; without it, the clip's
    int sweeps = 1;                      // over the links in each step, where a method sweeps
    std::array<std::uint8_t, 3> color = {255, 255, 255};
    double line_width = 4.0;  // pixels
    double point_size = 8.0;  // pixels
};

// What the picture shows of the world.
struct View {
    Eigen::Array2d center = {0.0, 0.0};  // world units
    double height = 640.0;               // world units; the width follows from the picture's shape
};

// Everything a clip is made from.
struct Scene {
    std::string title;
    Eigen::Array2d gravity = {0.0, -1.0};
    int frames = 120;
    int steps_per_frame = 64;
    double frame_time = 1.0;               // units of time from one frame to the next
    std::array<int, 2> size = {960, 640};  // pixels, width and height
    View view;
    std::array<std::uint8_t, 3> background = {0, 0, 0};
    std::optional<double> tolerance;  // pixels that a rope with method "auto" may be wrong by
    bool words = true;                // title, steps per frame and the ropes' names in the picture's corner
    std::vector<SceneRope> ropes;
};

bool operator==(const SceneRope& a, const SceneRope& b);
bool operator==(const Scene& a, const Scene& b);

// The most bytes of TOML that are read; as tables they take forty times as much memory.
inline constexpr std::size_t largest_scene = std::size_t{1} << 26;

// Reads and checks a scene. `name` stands for the file in messages. Throws std::runtime_error,
// "name:line:column: what was found, what was expected".
Scene parse_scene(std::string_view toml, std::string_view name);

// The rope of that name; the first where `name` is "". Throws std::runtime_error that lists the names.
const SceneRope& rope_named(const Scene& scene, std::string_view name);

// Checks what several keys decide together, and what options may have changed after parsing: pins that
// exist, one mass per node, neighbours apart, unique names, ranges. Throws std::runtime_error that names the
// rope and key. parse_scene has checked the same (with positions in its messages).
void check_scene(const Scene& scene);

// Sets a key, as a scene file has it, to a value as TOML has it (words need no quotes): of [clip], also as
// "clip.frames"; of every [[rope]], or of one as "rope[0].stiffness" or "rope[NAME].stiffness"; or of the
// scene. "steps_per_frame" is that of the whole scene; what a key excludes (mass and masses, damping and
// damping_factor) it replaces. Throws std::runtime_error for an unknown key, a wrong type, a number out of
// range; what several keys decide together is left to check_scene.
void set_key(Scene& scene, std::string_view key, std::string_view value);

// Whether such a key takes one whole number, and not any number.
bool takes_whole_numbers(std::string_view key);

// The scene as TOML, every key written out, numbers so that they read back as the same doubles.
// parse_scene(to_toml(scene)) is the same scene, and equal scenes give equal texts.
std::string to_toml(const Scene& scene);

// How many masses the ropes have together.
long masses(const Scene& scene);

// How many steps per frame a rope is to be advanced by: its own, or the clip's.
int steps_per_frame(const Scene& scene, const SceneRope& rope);

// The rope that a method advances.
Rope make_rope(const Scene& scene, const SceneRope& rope);

// A scene that is compiled in: its name, one line about it, its file's text.
struct BuiltinScene {
    std::string_view name;
    std::string_view summary;
    std::string_view toml;
};
std::vector<BuiltinScene> builtin_scenes();  // "seed" first

// "toml++ 3.3.0", the library that reads TOML.
std::string toml_library();

}  // namespace ropesim
