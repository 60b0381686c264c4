#include "clip/frames.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <optional>
#include <stdexcept>

namespace ropesim {
namespace {

// A whole number without sign, or nothing.
std::optional<long> parse_count(std::string_view text) {
    long number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    if (error != std::errc() || end != text.data() + text.size() || number < 0) return std::nullopt;
    return number;
}

struct Range {
    long first;
    long last;
};

Range parse_range(std::string_view text, long frames) {
    const std::size_t colon = text.find(':');
    const std::string_view before = text.substr(0, colon);
    const std::string_view after = colon == std::string_view::npos ? before : text.substr(colon + 1);
    const std::optional<long> first = before.empty() && colon == 0 ? 0 : parse_count(before);
    const std::optional<long> last =
        after.empty() && colon != std::string_view::npos ? frames - 1 : parse_count(after);
    if (!first || !last || *first > *last)
        throw std::runtime_error("frames '" + std::string(text) +
                                 "' are no number or range; expected such as 2,4,10:20,90:");
    if (*last >= frames)
        throw std::runtime_error("frame " + std::to_string(*last) +
                                 " is past the end of the clip; it has frames 0 to " +
                                 std::to_string(frames - 1));
    return {*first, *last};
}

constexpr std::string_view frame_prefix = "frame_";
constexpr std::string_view frame_suffix = ".png";

}  // namespace

Shard parse_shard(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash != std::string_view::npos) {
        const auto index = parse_count(text.substr(0, slash));
        const auto count = parse_count(text.substr(slash + 1));
        if (index && count && *index < *count) return {*index, *count};
    }
    throw std::runtime_error("shard '" + std::string(text) + "' is not I/N with 0 <= I < N, such as 0/4");
}

std::vector<long> parse_frames(std::string_view text, long frames) {
    if (text.empty()) text = "0:";
    std::vector<Range> ranges;
    for (std::size_t begin = 0; begin != std::string_view::npos;) {
        const std::size_t comma = text.find(',', begin);
        ranges.push_back(parse_range(text.substr(begin, comma - begin), frames));
        begin = comma == std::string_view::npos ? comma : comma + 1;
    }
    std::vector<long> selected;
    for (const Range& range : ranges)
        for (long frame = range.first; frame <= range.last; ++frame) selected.push_back(frame);
    std::sort(selected.begin(), selected.end());
    selected.erase(std::unique(selected.begin(), selected.end()), selected.end());
    return selected;
}

std::string to_string(const std::vector<long>& frames) {
    std::string text;
    for (std::size_t i = 0; i < frames.size();) {
        std::size_t end = i + 1;
        while (end < frames.size() && frames[end] == frames[end - 1] + 1) ++end;
        if (!text.empty()) text += ',';
        text += std::to_string(frames[i]);
        if (end > i + 1) text += ':' + std::to_string(frames[end - 1]);
        i = end;
    }
    return text;
}

std::string frame_name(long frame, long frames) {
    const std::size_t digits = std::max<std::size_t>(4, std::to_string(frames - 1).size());
    const std::string number = std::to_string(frame);
    return std::string(frame_prefix) + std::string(digits - number.size(), '0') + number +
           std::string(frame_suffix);
}

std::vector<long> frames_in(const std::filesystem::path& folder) {
    std::vector<long> frames;
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const std::string name = entry.path().filename().string();
        std::string_view number = name;
        if (!number.starts_with(frame_prefix) || !number.ends_with(frame_suffix)) continue;
        number.remove_prefix(frame_prefix.size());
        number.remove_suffix(std::min(number.size(), frame_suffix.size()));
        if (const auto frame = parse_count(number)) frames.push_back(*frame);
    }
    std::sort(frames.begin(), frames.end());
    return frames;
}

}  // namespace ropesim
