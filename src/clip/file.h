#pragma once

#include <sys/stat.h>

#include <cstdint>
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

namespace ropesim {

// The most bytes of a scene or picture, and of positions, that are read whole.
inline constexpr std::uint64_t largest_file = std::uint64_t{1} << 30;
inline constexpr std::uint64_t largest_positions = std::uint64_t{1} << 32;

// The bytes of a file, a pipe or a device, where they are no more than the largest. Throws
// std::runtime_error, "<path>: why".
std::vector<std::uint8_t> read_file(const std::filesystem::path& path, std::uint64_t largest = largest_file);

// The same of a file that nobody named but that a folder holds: a pipe or a device, which might keep one
// waiting for ever, is refused.
std::vector<std::uint8_t> read_regular_file(const std::filesystem::path& path);

// A file that is read in parts, at any offset; open as long as it lives. Everything throws
// std::runtime_error, "<path>: why".
class OpenFile {
  public:
    explicit OpenFile(std::filesystem::path path);
    ~OpenFile();
    OpenFile(const OpenFile&) = delete;
    OpenFile& operator=(const OpenFile&) = delete;

    const std::filesystem::path& path() const { return path_; }

    // In bytes, as it was opened; of a pipe or a device there is none, nor a part.
    std::optional<std::uint64_t> size() const;

    // Throws also where the file has changed since it was opened, so that all parts are of one content.
    void read_at(std::uint64_t offset, std::span<std::uint8_t> bytes) const;

    // From the beginning, also of a pipe or a device, no more than the largest. Reads once.
    std::vector<std::uint8_t> read_all(std::uint64_t largest) const;

  private:
    std::filesystem::path path_;
    int descriptor_;
    struct stat opened_;
};

// How a file is written.
enum class Place {
    in_folder,  // over whatever has its name there
    named       // the user gave its name: a pipe, a terminal or the like is written directly, "-" is stdout
};

// A file that is being written: it appears whole when it is finished, or not at all, also when the process
// is killed. Until then it has a temporary name in the same folder; then it is renamed over whatever was
// there. Everything throws std::runtime_error, "<path>: why".
class NewFile {
  public:
    explicit NewFile(std::filesystem::path path, Place place = Place::in_folder);
    ~NewFile();  // takes away what was not finished
    NewFile(const NewFile&) = delete;
    NewFile& operator=(const NewFile&) = delete;

    // Behind what was appended before.
    void append(std::span<const std::uint8_t> bytes);
    void append(std::string_view text);

    // At an offset from the file's beginning, of a regular file.
    void write_at(std::uint64_t offset, std::span<const std::uint8_t> bytes);
    void read_at(std::uint64_t offset, std::span<std::uint8_t> bytes) const;
    void set_size(std::uint64_t size);

    // Has what was written outlast a power cut; so does the name once its folder is synced.
    void sync();

    void finish();

  private:
    void flush();
    void write(std::span<const std::uint8_t> bytes);
    [[noreturn]] void fail(const char* what) const;

    std::filesystem::path path_;
    std::filesystem::path temporary_;  // empty where it is written directly, and once it is finished
    int descriptor_ = -1;
    std::vector<std::uint8_t> unwritten_;
};

// Writes a whole file by NewFile.
void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes,
                Place place = Place::in_folder);
void write_file(const std::filesystem::path& path, std::string_view text, Place place = Place::in_folder);

// For commands that work long before they write a file that the user named: throws std::runtime_error where
// it is a folder, or in a folder that is not there or that one may not write into.
void check_writable(const std::filesystem::path& path);

// Makes a folder where there is none; the one above it must be there. Throws std::runtime_error where
// something else has its name, or where the system cannot.
void make_folder(const std::filesystem::path& folder);

// Has the names in a folder outlast a power cut. Throws std::runtime_error where the system cannot.
void sync_folder(const std::filesystem::path& folder);

// The temporary files in the folder that no process of this machine is writing: killed ones left them, or
// they are of another machine.
std::vector<std::filesystem::path> stray_temporaries(const std::filesystem::path& folder);

// Names of what a folder holds, in no order. (Where memory runs out, libstdc++'s iterator of folders ends the
// program.) Throws std::runtime_error where it cannot be read.
std::vector<std::string> names_in(const std::filesystem::path& folder);

// Deletes temporary files that killed processes of this machine left in the folder.
void remove_stale_temporaries(const std::filesystem::path& folder);

}  // namespace ropesim
