#pragma once

#include <cstddef>
#include <filesystem>
#include <initializer_list>
#include <iterator>
#include <string>
#include <string_view>
#include <vector>

namespace ropesim {

// Numbers of frames, ascending, each once. Kept as ranges, so that ten million take no more room than ten.
class FrameList {
  public:
    struct Range {
        long first;
        long last;  // included

        bool operator==(const Range&) const = default;
    };

    class Iterator {
      public:
        using iterator_category = std::forward_iterator_tag;
        using value_type = long;
        using difference_type = std::ptrdiff_t;
        using pointer = const long*;
        using reference = const long&;

        Iterator() = default;
        Iterator(const Range* range, const Range* end);
        const long& operator*() const { return frame_; }
        Iterator& operator++();
        Iterator operator++(int);
        bool operator==(const Iterator&) const = default;

      private:
        const Range* range_ = nullptr;
        const Range* end_ = nullptr;
        long frame_ = 0;
    };
    using value_type = long;
    using const_iterator = Iterator;

    FrameList() = default;
    explicit FrameList(std::vector<Range> ranges);  // in any order; they may overlap
    FrameList(const std::vector<long>& numbers);    // in any order
    FrameList(std::initializer_list<long> numbers) : FrameList(std::vector<long>(numbers)) {}

    Iterator begin() const { return {ranges_.data(), ranges_.data() + ranges_.size()}; }
    Iterator end() const { return {ranges_.data() + ranges_.size(), ranges_.data() + ranges_.size()}; }
    bool empty() const { return ranges_.empty(); }
    std::size_t size() const;
    long back() const { return ranges_.back().last; }
    bool contains(long frame) const;

    // Apart from each other, ascending.
    const std::vector<Range>& ranges() const { return ranges_; }

    bool operator==(const FrameList&) const = default;

  private:
    std::vector<Range> ranges_;
};

// The frames of one list or the other.
FrameList both(const FrameList& a, const FrameList& b);

// The frames whose number is `index` modulo `count`.
struct Shard {
    long index = 0;
    long count = 1;

    bool contains(long frame) const { return frame % count == index; }
};

// Reads "I/N". Throws std::runtime_error unless 0 <= I < N.
Shard parse_shard(std::string_view text);

// Reads a list of frame numbers and ranges, both ends included, such as "2,4,10:20,90:"; empty means all.
// Throws std::runtime_error for what is no such list and for a frame beyond the last of `frames`.
FrameList parse_frames(std::string_view text, long frames);

// The shortest list that parse_frames reads as these frames.
std::string to_string(const FrameList& frames);

// "frame_0042.png": four digits, or as many as the last frame of the clip needs.
std::string frame_name(long frame, long frames);

// The frames in a folder: the files named frame_<digits>.png.
FrameList frames_in(const std::filesystem::path& folder);

}  // namespace ropesim
