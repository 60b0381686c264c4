#pragma once

#include <filesystem>
#include <string>
#include <string_view>
#include <vector>

namespace ropesim {

// The frames whose number is `index` modulo `count`.
struct Shard {
    long index = 0;
    long count = 1;
};

// Reads "I/N". Throws std::runtime_error unless 0 <= I < N.
Shard parse_shard(std::string_view text);

// Reads a list of frame numbers and ranges, both ends included, such as "2,4,10:20,90:"; empty means all.
// The result is sorted, each frame once. Throws std::runtime_error for what is no such list and for a
// frame beyond the last of `frames`.
std::vector<long> parse_frames(std::string_view text, long frames);

// The shortest list that parse_frames reads as these frames (sorted, each once).
std::string to_string(const std::vector<long>& frames);

// "frame_0042.png": four digits, or as many as the last frame of the clip needs.
std::string frame_name(long frame, long frames);

// Numbers of the frames in a folder, sorted: the files named frame_<digits>.png.
std::vector<long> frames_in(const std::filesystem::path& folder);

}  // namespace ropesim
