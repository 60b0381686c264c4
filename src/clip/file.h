#pragma once

#include <cstdint>
#include <filesystem>
#include <span>
#include <string_view>
#include <vector>

namespace ropesim {

// The bytes of a file (a regular file, a pipe, a device). Throws std::runtime_error, "<path>: why".
std::vector<std::uint8_t> read_file(const std::filesystem::path& path);

// Writes a file so that it appears whole or not at all, also when the process is killed: to a temporary
// name in the same folder (".<name>.<host>-<pid>.tmp"), then renamed over whatever was there. Throws
// std::runtime_error, "<path>: why", and leaves no temporary file behind.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes);
void write_file(const std::filesystem::path& path, std::string_view text);

// Deletes temporary files that a process of this machine, now dead, left in the folder.
void remove_stale_temporaries(const std::filesystem::path& folder);

}  // namespace ropesim
