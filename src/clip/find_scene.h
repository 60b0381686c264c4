#pragma once

#include "scene/scene.h"

#include <string>

namespace ropesim {

struct FoundScene {
    Scene scene;
    std::string positions_digest;  // of the positions file that the frame was drawn from; usually none
};

// The scene that SCENE on the command line means: the name of a built-in scene, a TOML file, or a frame (a
// PNG with its scene in a text chunk). Throws std::runtime_error that says what it is not, with the nearest
// built-in name.
FoundScene find_scene(const std::string& scene);

}  // namespace ropesim
