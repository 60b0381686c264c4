#include "clip/manifest.h"

#include "clip/digest.h"
#include "clip/render_clip.h"
#include "simulation/diagnostics.h"

#include <nlohmann/json.hpp>

#include <array>
#include <cstdio>
#include <cstdlib>
#include <stdexcept>
#include <system_error>

namespace ropesim {
namespace {

constexpr const char* version_key = "Software";
constexpr const char* scene_key = "ropesim:scene";
constexpr const char* digest_key = "ropesim:digest";
constexpr const char* frame_key = "ropesim:frame";
constexpr const char* methods_key = "ropesim:methods";
constexpr const char* positions_key = "ropesim:positions";

// A control character, which no name has.
constexpr const char* frame_errors_here = "\x7f";

std::string methods_text(const Scene& scene) {
    std::string text;
    for (const SceneRope& rope : scene.ropes)
        text += (text.empty() ? "" : "\n") + rope.name + ": " + rope.method;
    return text;
}

// An object of JSON is never made by naming a key of none: where memory runs out in that, nlohmann's 3.11.2
// leaves one that crashes when it goes.
nlohmann::ordered_json rope_json(const Scene& scene, const Run& run) {
    nlohmann::ordered_json rope{{"name", run.description->name},
                                {"method", run.method->name},
                                {"model", name(run.method->model)},
                                {"steps_per_frame", run.stepping.steps}};
    const auto fewest =
        fewest_stable_steps(run.rope, *run.method, scene.frame_time, run.stepping.damping_factor);
    if (fewest) rope["fewest_stable_steps"] = *fewest;
    rope["greatest_frequency"] = greatest_frequency(run.rope);
    return rope;
}

// Two digits and a half: it is an estimate.
double rounded(double pixels) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.3g", pixels);
    return std::strtod(text.data(), nullptr);
}

nlohmann::ordered_json error_json(const RopeError& error) {
    constexpr std::array<const char*, 3> bounds{"about", "more than", "less than"};
    const RopeError::Worst worst = error.worst();
    nlohmann::ordered_json json{{"estimated_by", error.description()},
                                {"worst", bounds[static_cast<std::size_t>(worst.bound)]},
                                {"worst_px", rounded(worst.pixels)},
                                {"worst_frame", worst.frame},
                                {"last_px", nullptr}};
    if (const auto last = error.last()) json["last_px"] = rounded(*last);
    json["px"] = frame_errors_here;
    return json;
}

// The estimates of all frames, on one line.
std::string frame_errors(const RopeError& error) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const auto& pixels : error.frames())
        json.push_back(pixels ? nlohmann::ordered_json(rounded(*pixels)) : nullptr);
    return json.dump();
}

// In place of what stands for them in the text, one after the other.
std::string with_frame_errors(std::string text, const Simulation& simulation) {
    const std::string mark = '"' + std::string(frame_errors_here) + '"';
    std::size_t place = 0;
    for (std::size_t i = 0; i < simulation.runs().size(); ++i) {
        if (!simulation.error(i)) continue;
        place = text.find(mark, place);
        const std::string errors = frame_errors(*simulation.error(i));
        text.replace(place, mark.size(), errors);
        place += errors.size();
    }
    return text;
}

nlohmann::ordered_json energy_json(const Energy& energy) {
    return {{"kinetic", energy.kinetic}, {"spring", energy.spring}, {"gravity", energy.gravity}};
}

void add_motion(const Scene& scene, const Simulation& simulation, std::size_t i,
                nlohmann::ordered_json& rope) {
    const Summary& summary = simulation.summaries()[i];
    rope["largest_stretch"] = summary.largest_stretch;
    rope["largest_tension"] = summary.largest_tension;
    if (summary.first_energy)
        rope["energy"] = {{"first", energy_json(*summary.first_energy)},
                          {"last", energy_json(summary.last_energy)}};
    rope["energy_drift"] = summary.energy_drift();
    if (const RopeError* error = simulation.error(i))
        rope["error"] = error_json(*error);
    else if (!simulation.why_no_errors().empty())
        rope["error"] = {{"left_out", simulation.why_no_errors()}};
    if (const auto frame = simulation.diverged(i)) {
        rope["diverged_in_frame"] = *frame;
        rope["divergence"] = divergence(scene, simulation.runs()[i], *frame);
    }
}

// The text of a key; "" where it has none.
std::string text_of(const nlohmann::json& json, const char* key) {
    return json.contains(key) && json[key].is_string() ? json[key].get<std::string>() : "";
}

std::string text_of(const Texts& texts, const char* key) {
    const auto text = texts.find(key);
    return text == texts.end() ? "" : text->second;
}

}  // namespace

Texts frame_texts(const Scene& scene, const std::string& positions_digest) {
    const std::string toml = to_toml(scene);
    Texts texts{{version_key, version()},
                {scene_key, toml},
                {digest_key, digest(toml)},
                {methods_key, methods_text(scene)}};
    if (!positions_digest.empty()) texts[positions_key] = positions_digest;
    return texts;
}

void set_frame(Texts& texts, long frame) {
    texts[frame_key] = std::to_string(frame);
}

Scene scene_of(const Texts& texts, const std::string& name) {
    const auto scene = texts.find(scene_key);
    if (scene == texts.end())
        throw std::runtime_error(name +
                                 ": a picture without a scene in it; expected a frame made by ropesim");
    return parse_scene(scene->second, name);
}

std::string scene_digest_of(const Texts& texts) {
    return text_of(texts, digest_key);
}

std::string frame_of(const Texts& texts) {
    return text_of(texts, frame_key);
}

std::string version_of(const Texts& texts) {
    return text_of(texts, version_key);
}

std::string positions_digest_of(const Texts& texts) {
    return text_of(texts, positions_key);
}

std::string clip_json(const Scene& scene, const Simulation& simulation, const ClipOptions& options,
                      const FrameList& frames, const std::string& renderer) {
    const bool simulated = options.positions_digest.empty();
    const std::string toml = to_toml(scene);
    nlohmann::ordered_json json{{"version", version()},
                                {"renderer", renderer},
                                {"frames", to_string(frames)},
                                {"digest", digest(toml)}};
    if (options.compact) json["compact"] = true;
    if (!simulated) json["positions"] = options.positions_digest;
    json["ropes"] = nlohmann::ordered_json::array();
    for (std::size_t i = 0; i < simulation.runs().size(); ++i) {
        json["ropes"].push_back(rope_json(scene, simulation.runs()[i]));
        if (simulated) add_motion(scene, simulation, i, json["ropes"].back());
    }
    json["scene"] = toml;
    return (simulated ? with_frame_errors(json.dump(2), simulation) : json.dump(2)) + "\n";
}

Manifest parse_manifest(std::string_view text, const std::string& name) {
    constexpr std::size_t largest = 2 * largest_scene;  // a scene, and what became of its ropes
    if (text.size() > largest)
        throw std::runtime_error(name + ": found " + std::to_string(text.size()) +
                                 " bytes, expected at most " + std::to_string(largest));
    const nlohmann::json json = nlohmann::json::parse(text, nullptr, false);
    if (!json.is_object() || text_of(json, "scene").empty())
        throw std::runtime_error(name + ": holds no scene, expected a manifest made by ropesim");
    Manifest manifest;
    manifest.scene = parse_scene(text_of(json, "scene"), name);
    manifest.digest = text_of(json, "digest");
    if (manifest.digest != digest(text_of(json, "scene")))
        throw std::runtime_error(name + ": its digest is not that of its scene");
    manifest.version = text_of(json, "version");
    manifest.positions_digest = text_of(json, "positions");
    manifest.compact = json.value("compact", nlohmann::json()) == true;
    const std::string frames = text_of(json, "frames");
    if (frames.empty()) throw std::runtime_error(name + ": does not say which frames the clip has");
    try {
        manifest.frames = parse_frames(frames, manifest.scene.frames);
    } catch (const std::runtime_error& error) {
        throw std::runtime_error(name + ": " + error.what());
    }
    const nlohmann::json ropes = json.value("ropes", nlohmann::json::array());
    manifest.has_errors = !ropes.empty() && ropes.is_array() && ropes[0].contains("error");
    return manifest;
}

std::filesystem::path manifest_path(const std::filesystem::path& folder) {
    return folder / "clip.json";
}

void remove_manifest(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::remove(manifest_path(folder), error);
    if (error)
        throw std::runtime_error(manifest_path(folder).string() + ": cannot remove: " + error.message());
}

}  // namespace ropesim
