#include "commands/scene_options.h"

#include <CLI/CLI.hpp>

#include <stdexcept>

namespace ropesim {

void add_scene_options(CLI::App& app, SceneOptions& options) {
    app.add_option("SCENE", options.scene, "a scene file, the name of a built-in scene, or a frame")
        ->type_name("")
        ->default_str("seed");
    app.add_option("-s,--steps", options.steps_per_frame, "steps per frame")->type_name("N");
    app.add_option("-m,--mass", options.mass, "mass of every node")->type_name("M");
    app.add_option("-g,--gravity", options.gravity, "acceleration of gravity, two numbers")->type_name("X Y");
    app.add_option("--nodes", options.nodes, "masses in every rope")->type_name("N");
}

void add_error_option(CLI::App& app, SceneOptions& options) {
    app.add_flag("--no-error", options.no_error, "leave out the estimate of how wrong the ropes are");
}

FoundScene open_scene(const SceneOptions& options) {
    FoundScene found = find_scene(options.scene);
    Scene& scene = found.scene;
    if (options.steps_per_frame) scene.steps_per_frame = *options.steps_per_frame;
    if (options.gravity) scene.gravity = {(*options.gravity)[0], (*options.gravity)[1]};
    for (SceneRope& rope : scene.ropes) {
        if (options.steps_per_frame) rope.steps_per_frame.reset();
        if (options.nodes) rope.nodes = *options.nodes;
        if (!options.mass) continue;
        rope.mass = *options.mass;
        rope.masses.clear();
    }
    check_scene(scene);
    return found;
}

FrameList selected_frames(const std::string& text, const Scene& scene) {
    try {
        return parse_frames(text, scene.frames);
    } catch (const std::runtime_error& error) {
        throw CLI::ValidationError("--frames", error.what());
    }
}

Shard selected_shard(const std::string& text) {
    try {
        return parse_shard(text);
    } catch (const std::runtime_error& error) {
        throw CLI::ValidationError("--shard", error.what());
    }
}

}  // namespace ropesim
