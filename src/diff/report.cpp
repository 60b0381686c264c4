#include "diff/report.h"

#include "clip/file.h"
#include "diff/summary.h"
#include "image/png.h"
#include "report_files.h"
#include "scene/words.h"

#include <nlohmann/json.hpp>

#include <algorithm>
#include <stdexcept>

namespace ropesim {
namespace {

using Json = nlohmann::ordered_json;

// Base64 of the pictures, each in an element that its id names.
struct Pictures {
    std::string elements;
    std::size_t bytes = 0;   // of the files
    std::size_t frames = 0;  // that have one
};

// Adds a picture and gives its id; "" where there is none that a browser could show.
std::string add_picture(Pictures& pictures, const std::filesystem::path& path, const std::string& id) {
    try {
        const std::vector<std::uint8_t> bytes = read_regular_file(path);
        decode_png(bytes, path.string());
        pictures.bytes += bytes.size();
        pictures.elements += "<script type=\"text/plain\" id=\"" + id + "\">" +
                             base64({reinterpret_cast<const char*>(bytes.data()), bytes.size()}) +
                             "</script>\n";
        return id;
    } catch (const std::runtime_error&) {
        return "";
    }
}

Json frame_json(const Comparison& comparison, const Cause& cause, const FrameComparison& frame) {
    Json json{{"name", one_line(frame.name)},
              {"verdict", name(frame.verdict)},
              {"passes", passes(frame.verdict)},
              {"finding", one_line(finding(comparison, frame))}};
    if (frame.number >= 0) json["number"] = frame.number;
    if (frame.difference.changed > 0) {
        const Region& region = frame.difference.region;
        json["over"] = frame.difference.over;
        json["region"] = {region.left, region.top, region.right, region.bottom};
    }
    if (const auto kind = cause.frames.find(frame.name); kind != cause.frames.end())
        json["cause"] = kind->second;
    if (const auto far = cause.motion.distance.find(frame.number); far != cause.motion.distance.end())
        json["distance"] = far->second;
    return json;
}

void add_pictures(const Comparison& comparison, Json& frames, Pictures& pictures) {
    std::vector<std::size_t> failed;
    for (std::size_t i = 0; i < comparison.frames.size(); ++i)
        if (!passes(comparison.frames[i].verdict)) failed.push_back(i);
    for (const std::size_t index : pictured(failed.size(), most_pictured_frames)) {
        const std::size_t i = failed[index];
        const FrameComparison& frame = comparison.frames[i];
        if (pictures.bytes >= most_pictured_bytes) return;
        const std::string number = std::to_string(i);
        frames[i]["expected"] = add_picture(pictures, expected_path(comparison, frame), "expected-" + number);
        frames[i]["actual"] = add_picture(pictures, actual_path(comparison, frame), "actual-" + number);
        ++pictures.frames;
    }
}

// JSON that may stand in a script element: no "<" ends it or begins a comment.
std::string in_script(const Json& json) {
    std::string text;
    for (const char c : json.dump(-1, ' ', true, Json::error_handler_t::replace))
        text += c == '<' ? std::string("\\u003c") : std::string(1, c);
    return text;
}

// The template with its one `mark` replaced.
std::string filled_in(const std::string& text, std::string_view mark, const std::string& with) {
    const std::size_t at = text.find(mark);
    return text.substr(0, at) + with + text.substr(at + mark.size());
}

}  // namespace

std::vector<std::size_t> pictured(std::size_t count, std::size_t most) {
    std::vector<std::size_t> indices;
    const std::size_t first = count <= most ? count : most / 2;
    for (std::size_t i = 0; i < first; ++i) indices.push_back(i);
    const std::size_t others = std::min(count, most) - first;
    for (std::size_t i = 1; i <= others; ++i) indices.push_back(first - 1 + i * (count - first) / others);
    return indices;
}

std::string base64(std::string_view bytes) {
    constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    const auto byte = [&](std::size_t i) {
        return i < bytes.size() ? static_cast<std::uint32_t>(static_cast<unsigned char>(bytes[i])) : 0U;
    };
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::uint32_t three = byte(i) << 16 | byte(i + 1) << 8 | byte(i + 2);
        for (unsigned digit = 0; digit < 4; ++digit)
            text += digit <= bytes.size() - i ? digits[three >> (18 - 6 * digit) & 63U] : '=';
    }
    return text;
}

std::string to_html(const Comparison& comparison, const Cause& cause) {
    Json json{{"summary", one_line(headline(comparison))},
              {"why", cause.sentences},
              {"expected_path", one_line(comparison.expected.string())},
              {"actual_path", one_line(comparison.actual.string())},
              {"actual", one_line(comparison.actual.filename().string())},
              {"threshold", comparison.tolerance.channel},
              {"max_pixels", comparison.tolerance.pixels}};
    json["frames"] = Json::array();
    for (const FrameComparison& frame : comparison.frames)
        json["frames"].push_back(frame_json(comparison, cause, frame));
    Pictures pictures;
    add_pictures(comparison, json["frames"], pictures);
    json["embedded"] = pictures.frames;
    const std::string page(report_files()[0].second);
    return filled_in(filled_in(page, "@PICTURES@", pictures.elements), "@DATA@", in_script(json));
}

}  // namespace ropesim
