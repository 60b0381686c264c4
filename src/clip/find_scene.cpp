#include "clip/find_scene.h"

#include "clip/file.h"
#include "clip/manifest.h"
#include "image/png.h"
#include "scene/words.h"

#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <vector>

namespace ropesim {
namespace {

std::string no_such_scene(const std::string& scene) {
    std::vector<std::string_view> known;
    for (const BuiltinScene& builtin : builtin_scenes()) known.push_back(builtin.name);
    const std::string nearest = suggestion(scene, known);
    return printable(scene) + ": no such file, and no built-in scene" +
           (nearest.empty() ? "; 'ropesim scenes' lists those" : "; did you mean '" + nearest + "'?");
}

}  // namespace

FoundScene find_scene(const std::string& scene) {
    for (const BuiltinScene& builtin : builtin_scenes())
        if (builtin.name == scene) return {parse_scene(builtin.toml, builtin.name), ""};
    std::error_code unknown;
    if (std::filesystem::status(scene, unknown).type() == std::filesystem::file_type::not_found)
        throw std::runtime_error(no_such_scene(scene));
    const std::vector<std::uint8_t> bytes = read_file(scene, largest_scene);
    if (!is_png(bytes))
        return {parse_scene({reinterpret_cast<const char*>(bytes.data()), bytes.size()}, scene), ""};
    const Texts texts = decode_png_texts(bytes, scene);
    return {scene_of(texts, scene), positions_digest_of(texts)};
}

}  // namespace ropesim
