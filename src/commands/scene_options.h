#pragma once

#include "clip/find_scene.h"
#include "clip/frames.h"

#include <array>
#include <optional>
#include <string>

namespace CLI {
class App;
}

namespace ropesim {

// SCENE and the options that override it, as on the command line of everything that takes a scene.
struct SceneOptions {
    std::string scene = "seed";
    std::optional<int> steps_per_frame;
    std::optional<double> mass;
    std::optional<std::array<double, 2>> gravity;
    std::optional<int> nodes;
    bool no_error = false;
};

// The option that leaves out the estimate of errors.
void add_error_option(CLI::App& app, SceneOptions& options);

void add_scene_options(CLI::App& app, SceneOptions& options);

// The scene with the options in place, checked. Throws std::runtime_error.
FoundScene open_scene(const SceneOptions& options);

// The frames that `--frames` asks for. Throws CLI::ValidationError.
FrameList selected_frames(const std::string& text, const Scene& scene);

// What `--shard` asks for. Throws CLI::ValidationError.
Shard selected_shard(const std::string& text);

}  // namespace ropesim
