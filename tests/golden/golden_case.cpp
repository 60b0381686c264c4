#include "golden/golden_case.h"

#include "clip/file.h"
#include "clip/manifest.h"
#include "clip/picture.h"
#include "clip/run.h"
#include "compare/comparison_painter.h"
#include "diff/report.h"
#include "image/png.h"

#include <algorithm>
#include <sstream>

namespace ropesim {
namespace {

// Not a bit of a pixel may change: our own frames are the same on every machine.
constexpr Tolerance exactly{.channel = 0, .pixels = 0};

std::string text_of(const std::filesystem::path& path) {
    const std::vector<std::uint8_t> bytes = read_file(path);
    return {bytes.begin(), bytes.end()};
}

std::string compare_positions(const GoldenCase& expected, const GoldenCase& actual) {
    for (const auto& [frame, ropes] : expected.positions)
        if (!actual.positions.contains(frame)) return "frame " + std::to_string(frame) + " has no positions";
    const MotionDifference motion =
        motion_difference(expected.scene, expected.positions, actual.scene, actual.positions);
    if (!motion.apart.empty()) return "rope '" + motion.apart.front() + "' has other nodes";
    if (!motion.first) return "";
    return "positions moved: first " + to_string(*motion.first) + "; farthest " + to_string(*motion.farthest);
}

std::string compare_pixels(const GoldenCase& expected, const GoldenCase& actual) {
    std::ostringstream text;
    for (const auto& [frame, picture] : expected.pictures) {
        const auto there = actual.pictures.find(frame);
        if (there == actual.pictures.end()) return "frame " + std::to_string(frame) + " has no picture";
        if (picture == there->second) continue;
        const PixelDifference change = pixel_difference(picture, there->second, exactly.channel);
        text << (text.str().empty() ? "pixels changed: " : "; ") << change.over << " of " << change.drawn
             << " drawn in frame " << frame << ", most by " << change.largest << " of 255";
    }
    return text.str();
}

std::filesystem::path comparison_path(const std::string& layout) {
    return golden_folder() / "comparisons" / (layout + ".png");
}

}  // namespace

std::filesystem::path golden_folder() {
    return ROPESIM_GOLDEN_FOLDER;
}

std::vector<std::string> golden_cases() {
    std::vector<std::string> names;
    for (const auto& entry : std::filesystem::directory_iterator(golden_folder()))
        if (std::filesystem::exists(entry.path() / "scene.toml"))
            names.push_back(entry.path().filename().string());
    std::sort(names.begin(), names.end());
    return names;
}

Scene scene_of_case(const std::string& name) {
    const std::filesystem::path path = golden_folder() / name / "scene.toml";
    return parse_scene(text_of(path), path.string());
}

GoldenCase stored(const std::string& name) {
    const std::filesystem::path folder = golden_folder() / name;
    GoldenCase golden{name, scene_of_case(name), {}, {}};
    const std::string positions_file = (folder / "positions.csv").string();
    golden.positions = parse_positions(golden.scene, text_of(positions_file), positions_file);
    for (const long frame : frames_in(folder)) {
        const std::filesystem::path path = folder / frame_name(frame, golden.scene.frames);
        golden.pictures[frame] = decode_png(read_file(path), path.string());
    }
    return golden;
}

GoldenCase made(const std::string& name, const Scene& scene, const FrameList& frames) {
    const std::vector<Run> scene_runs = runs(scene);
    GoldenCase golden{name, scene, positions(simulate(scene, scene_runs), frames), {}};
    for (const auto& [frame, ropes] : golden.positions) golden.pictures[frame] = drawn(scene, ropes);
    return golden;
}

Image drawn(const Scene& scene, const std::vector<Points>& positions) {
    return make_renderer(scene)->draw(polylines(scene, positions));
}

void store(const GoldenCase& golden, const std::filesystem::path& folder) {
    write_file(folder / "positions.csv", to_csv(golden.scene, golden.positions));
    for (const auto& [frame, picture] : golden.pictures)
        write_file(folder / frame_name(frame, golden.scene.frames), encode_png(picture, {}));
}

GoldenVerdict compare(const GoldenCase& expected, const GoldenCase& actual) {
    return {compare_positions(expected, actual), compare_pixels(expected, actual)};
}

std::filesystem::path leave_report(const GoldenCase& actual, const std::filesystem::path& folder) {
    std::filesystem::create_directories(folder / actual.name);
    store(actual, folder / actual.name);
    const Comparison comparison = compare(golden_folder() / actual.name, folder / actual.name, exactly);
    const std::filesystem::path report = folder / (actual.name + ".html");
    write_file(report, to_html(comparison, cause(comparison)));
    return report;
}

std::vector<std::string> comparison_layouts() {
    return {"overlay", "side-by-side", "difference", "strip"};
}

Image stored_comparison(const std::string& layout) {
    const std::filesystem::path path = comparison_path(layout);
    return decode_png(read_file(path), path.string());
}

Image made_comparison(const std::string& layout) {
    Scene scene = scene_of_case("seed");
    scene.size = {480, 320};
    const Parting parts = parting(scene);
    const FrameList frames = {0, 60, 80, 119};
    const Positions all = positions(simulate(scene, runs(scene)), frames);
    if (layout == "strip") {
        std::vector<std::vector<Points>> of_frames;
        for (const auto& [frame, ropes] : all) of_frames.push_back(ropes);
        return strip(scene, parts, {frames.begin(), frames.end()}, of_frames);
    }
    const Layout as = layout == "overlay"        ? Layout::overlay
                      : layout == "side-by-side" ? Layout::side_by_side
                                                 : Layout::difference;
    constexpr long frame = 80;
    return ComparisonPainter(scene, parts, as).draw(frame, all.at(frame));
}

void store_comparison(const std::string& layout, const Image& picture) {
    write_file(comparison_path(layout), encode_png(picture, {}));
}

}  // namespace ropesim
