#include "clip/frames.h"

#include "clip/file.h"
#include "scene/words.h"

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

FrameList::Range parse_range(std::string_view text, long frames) {
    const std::size_t colon = text.find(':');
    const std::string_view before = text.substr(0, colon);
    const std::string_view after = colon == std::string_view::npos ? before : text.substr(colon + 1);
    const std::optional<long> first = before.empty() && colon == 0 ? 0 : parse_count(before);
    const std::optional<long> last =
        after.empty() && colon != std::string_view::npos ? frames - 1 : parse_count(after);
    if (!first || !last || *first > *last)
        throw std::runtime_error("frames '" + printable(text) +
                                 "' are no number or range; expected such as 2,4,10:20,90:");
    if (*last >= frames)
        throw std::runtime_error("frame " + std::to_string(*last) +
                                 " is past the end of the clip; it has frames 0 to " +
                                 std::to_string(frames - 1));
    return {*first, *last};
}

constexpr std::string_view frame_prefix = "frame_";
constexpr std::string_view frame_suffix = ".png";

std::vector<FrameList::Range> ranges_of(const std::vector<long>& numbers) {
    std::vector<FrameList::Range> ranges;
    for (const long number : numbers) ranges.push_back({number, number});
    return ranges;
}

}  // namespace

FrameList::Iterator::Iterator(const Range* range, const Range* end)
    : range_(range), end_(end), frame_(range == end ? 0 : range->first) {}

FrameList::Iterator& FrameList::Iterator::operator++() {
    if (frame_ < range_->last)
        ++frame_;
    else
        *this = Iterator(range_ + 1, end_);
    return *this;
}

FrameList::Iterator FrameList::Iterator::operator++(int) {
    const Iterator before = *this;
    ++*this;
    return before;
}

FrameList::FrameList(std::vector<Range> ranges) {
    std::ranges::sort(ranges, {}, &Range::first);
    for (const Range& range : ranges) {
        if (!ranges_.empty() && range.first - 1 <= ranges_.back().last)
            ranges_.back().last = std::max(ranges_.back().last, range.last);
        else
            ranges_.push_back(range);
    }
}

FrameList::FrameList(const std::vector<long>& numbers) : FrameList(ranges_of(numbers)) {}

std::size_t FrameList::size() const {
    std::size_t size = 0;
    for (const Range& range : ranges_) size += static_cast<std::size_t>(range.last - range.first + 1);
    return size;
}

bool FrameList::contains(long frame) const {
    const auto next = std::ranges::upper_bound(ranges_, frame, {}, &Range::first);
    return next != ranges_.begin() && frame <= std::prev(next)->last;
}

FrameList both(const FrameList& a, const FrameList& b) {
    std::vector<FrameList::Range> ranges = a.ranges();
    ranges.insert(ranges.end(), b.ranges().begin(), b.ranges().end());
    return FrameList(std::move(ranges));
}

Shard parse_shard(std::string_view text) {
    const std::size_t slash = text.find('/');
    if (slash != std::string_view::npos) {
        const auto index = parse_count(text.substr(0, slash));
        const auto count = parse_count(text.substr(slash + 1));
        if (index && count && *index < *count) return {*index, *count};
    }
    throw std::runtime_error("shard '" + printable(text) + "' is not I/N with 0 <= I < N, such as 0/4");
}

FrameList parse_frames(std::string_view text, long frames) {
    if (text.empty()) text = "0:";
    std::vector<FrameList::Range> ranges;
    for (std::size_t begin = 0; begin != std::string_view::npos;) {
        const std::size_t comma = text.find(',', begin);
        ranges.push_back(parse_range(text.substr(begin, comma - begin), frames));
        begin = comma == std::string_view::npos ? comma : comma + 1;
    }
    return FrameList(std::move(ranges));
}

std::string to_string(const FrameList& frames) {
    std::string text;
    for (const auto& [first, last] : frames.ranges()) {
        if (!text.empty()) text += ',';
        text += std::to_string(first);
        if (last > first) text += ':' + std::to_string(last);
    }
    return text;
}

std::string frame_name(long frame, long frames) {
    const std::size_t digits = std::max<std::size_t>(4, std::to_string(frames - 1).size());
    const std::string number = std::to_string(frame);
    return std::string(frame_prefix) + std::string(digits - number.size(), '0') + number +
           std::string(frame_suffix);
}

FrameList frames_in(const std::filesystem::path& folder) {
    std::vector<long> frames;
    for (const std::string& name : names_in(folder)) {
        std::string_view number = name;
        if (!number.starts_with(frame_prefix) || !number.ends_with(frame_suffix)) continue;
        number.remove_prefix(frame_prefix.size());
        number.remove_suffix(std::min(number.size(), frame_suffix.size()));
        if (const auto frame = parse_count(number)) frames.push_back(*frame);
    }
    return frames;
}

}  // namespace ropesim
