#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace ropesim {

// The bytes of a file, a pipe or a device. Throws std::runtime_error, "<path>: why".
std::vector<std::uint8_t> read_file(const std::filesystem::path& path);

// Writes a file so that it appears whole or not at all, also when the process is killed: to a temporary
// name in the same folder, then renamed over whatever was there. What is no regular file (a pipe, a
// terminal) is written directly. Throws std::runtime_error, "<path>: why", and leaves nothing behind.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);

// Deletes temporary files that killed processes of this machine left in the folder.
void remove_stale_temporaries(const std::filesystem::path& folder);

}  // namespace ropesim
