#include "diff/side.h"

#include "clip/file.h"
#include "clip/manifest.h"
#include "image/png.h"

#include <stdexcept>
#include <string_view>

namespace ropesim {
namespace {

std::filesystem::path folder_of(const Comparison& comparison, Which which) {
    const std::filesystem::path& path = which == Which::expected ? comparison.expected : comparison.actual;
    return comparison.folders ? path : path.parent_path();
}

std::string text_of(const std::filesystem::path& path, std::uint64_t largest = largest_file) {
    const std::vector<std::uint8_t> bytes = read_file(path, largest);
    return {bytes.begin(), bytes.end()};
}

const FrameComparison* frame_with_scene(const Comparison& comparison, Which which) {
    for (const FrameComparison& frame : comparison.frames)
        if (!(which == Which::expected ? frame.expected : frame.actual).scene.empty()) return &frame;
    return nullptr;
}

void read_frame(const std::filesystem::path& path, Side& side) {
    const Texts texts = decode_png_texts(read_regular_file(path), path.string());
    side.scene = scene_of(texts, path.string());
    side.drawn_from_positions = !positions_digest_of(texts).empty();
}

void read_manifest(const std::filesystem::path& path, Side& side) {
    const Manifest manifest = parse_manifest(text_of(path), path.string());
    side.scene = manifest.scene;
    side.drawn_from_positions = !manifest.positions_digest.empty();
}

void read_scene(const Comparison& comparison, Which which, Side& side) {
    const std::filesystem::path folder = folder_of(comparison, which);
    if (const FrameComparison* frame = frame_with_scene(comparison, which))
        read_frame(
            which == Which::expected ? expected_path(comparison, *frame) : actual_path(comparison, *frame),
            side);
    else if (comparison.folders && std::filesystem::is_regular_file(manifest_path(folder)))
        read_manifest(manifest_path(folder), side);
    else if (comparison.folders && std::filesystem::is_regular_file(folder / "scene.toml"))
        side.scene = parse_scene(text_of(folder / "scene.toml"), (folder / "scene.toml").string());
}

}  // namespace

Side side(const Comparison& comparison, Which which) {
    Side side;
    try {
        read_scene(comparison, which, side);
    } catch (const std::runtime_error& error) {
        side.problem = error.what();
    }
    read_positions(comparison, which, side);
    return side;
}

void read_positions(const Comparison& comparison, Which which, Side& side) {
    if (!comparison.folders || !side.scene) return;
    for (const char* name : {"positions.csv", "positions.npy"}) {
        const std::filesystem::path path = folder_of(comparison, which) / name;
        if (!std::filesystem::is_regular_file(path)) continue;
        try {
            side.positions = parse_positions(*side.scene, text_of(path, largest_positions), path.string());
        } catch (const std::runtime_error& error) {
            side.problem = error.what();
        }
        return;
    }
}

}  // namespace ropesim
