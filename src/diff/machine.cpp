#include "diff/machine.h"

#include "diff/summary.h"
#include "scene/words.h"

#include <nlohmann/json.hpp>

#include <algorithm>

namespace ropesim {
namespace {

using Json = nlohmann::ordered_json;

constexpr std::string_view replacement = "\xef\xbf\xbd";  // U+FFFD

Json difference_json(const PixelDifference& difference) {
    const Region& region = difference.region;
    return {{"changed", difference.changed},
            {"over", difference.over},
            {"drawn", difference.drawn},
            {"gone", difference.gone},
            {"new", difference.added},
            {"largest", difference.largest},
            {"region", {region.left, region.top, region.right, region.bottom}}};
}

Json frame_json(const Comparison& comparison, const Cause& cause, const FrameComparison& frame) {
    Json json{{"name", frame.name}, {"verdict", name(frame.verdict)}, {"passes", passes(frame.verdict)}};
    if (frame.number >= 0) json["number"] = frame.number;
    if (frame.verdict == Verdict::different || frame.verdict == Verdict::within ||
        frame.verdict == Verdict::chaos)
        json["difference"] = difference_json(frame.difference);
    if (const auto kind = cause.frames.find(frame.name); kind != cause.frames.end())
        json["cause"] = kind->second;
    if (const auto far = cause.motion.distance.find(frame.number); far != cause.motion.distance.end())
        json["distance"] = far->second;
    if (!passes(frame.verdict)) json["finding"] = finding(comparison, frame);
    return json;
}

Json moved_json(const Moved& moved) {
    return {{"frame", moved.frame}, {"rope", moved.rope}, {"mass", moved.mass}, {"distance", moved.distance}};
}

// Bytes of the character that UTF-8 text begins with; 0 where it begins with none that XML may hold
// (Extensible Markup Language 1.0, 5th edition, 2008, section 2.2).
std::size_t xml_character(std::string_view text) {
    const auto byte = [&](std::size_t i) {
        return static_cast<unsigned char>(i < text.size() ? text[i] : 0);
    };
    const unsigned char first = byte(0);
    if (first < 0x80) return first >= 0x20 || first == '\t' || first == '\n' || first == '\r' ? 1 : 0;
    const std::size_t bytes = first >= 0xf0 ? 4 : first >= 0xe0 ? 3 : 2;
    if (first < 0xc2 || first > 0xf4) return 0;
    for (std::size_t i = 1; i < bytes; ++i)
        if ((byte(i) & 0xc0) != 0x80) return 0;
    const bool overlong = (first == 0xe0 && byte(1) < 0xa0) || (first == 0xf0 && byte(1) < 0x90);
    const bool surrogate = first == 0xed && byte(1) >= 0xa0;
    const bool beyond = first == 0xf4 && byte(1) >= 0x90;
    const bool no_character = first == 0xef && byte(1) == 0xbf && byte(2) >= 0xbe;
    return overlong || surrogate || beyond || no_character ? 0 : bytes;
}

std::string xml(std::string_view text) {
    std::string result;
    while (!text.empty()) {
        const std::size_t bytes = xml_character(text);
        switch (text.front()) {
            case '&':
                result += "&amp;";
                break;
            case '<':
                result += "&lt;";
                break;
            case '>':
                result += "&gt;";
                break;
            case '"':
                result += "&quot;";
                break;
            default:
                result += bytes == 0 ? replacement : text.substr(0, bytes);
        }
        text.remove_prefix(std::max<std::size_t>(bytes, 1));
    }
    return result;
}

std::string test_case(const Comparison& comparison, const Cause& cause, const FrameComparison& frame) {
    const std::string begin = "  <testcase classname=\"" + xml(one_line(comparison.expected.string())) +
                              "\" name=\"" + xml(one_line(frame.name)) + "\"";
    if (passes(frame.verdict)) return begin + "/>\n";
    std::string text;
    for (const std::string& sentence : cause.sentences) text += xml(sentence) + "\n";
    return begin + ">\n    <failure type=\"" + std::string(name(frame.verdict)) + "\" message=\"" +
           xml(one_line(finding(comparison, frame))) + "\">" + text + "</failure>\n  </testcase>\n";
}

}  // namespace

std::string to_json(const Comparison& comparison, const Cause& cause) {
    Json json{{"expected", comparison.expected.string()},
              {"actual", comparison.actual.string()},
              {"threshold", comparison.tolerance.channel},
              {"max_pixels", comparison.tolerance.pixels},
              {"status", status(comparison)},
              {"summary", headline(comparison)},
              {"causes", cause.kinds},
              {"why", cause.sentences}};
    json["scene_keys"] = Json::array();
    for (const KeyDifference& each : cause.keys)
        json["scene_keys"].push_back(
            {{"key", each.key}, {"expected", each.expected}, {"actual", each.actual}});
    if (cause.motion.first) json["first_moved"] = moved_json(*cause.motion.first);
    if (cause.motion.farthest) json["farthest_moved"] = moved_json(*cause.motion.farthest);
    json["frames"] = Json::array();
    for (const FrameComparison& frame : comparison.frames)
        json["frames"].push_back(frame_json(comparison, cause, frame));
    return json.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

std::string to_junit(const Comparison& comparison, const Cause& cause) {
    const std::string counts = "tests=\"" + std::to_string(comparison.frames.size()) + "\" failures=\"" +
                               std::to_string(failures(comparison).size()) + "\"";
    std::string text = "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<testsuites " + counts +
                       ">\n<testsuite name=\"ropesim diff\" " + counts + ">\n";
    for (const FrameComparison& frame : comparison.frames) text += test_case(comparison, cause, frame);
    return text + "</testsuite>\n</testsuites>\n";
}

}  // namespace ropesim
