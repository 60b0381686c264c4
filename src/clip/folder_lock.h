#pragma once

#include <filesystem>

namespace ropesim {

// Keeps other processes of ropesim from writing frames into a folder while it lives. It leaves no file, and
// the system lets go of it when the process has ended, however it ended, and its helpers with it. Where the
// file system has no locks (some of networks), nobody is kept out.
class FolderLock {
  public:
    enum class Kind { alone, shared };  // shards of one clip share a folder

    // Throws std::runtime_error where another process is at work there and does not end within two seconds
    // (as helpers of a killed one do, after the frame they are at).
    FolderLock(const std::filesystem::path& folder, Kind kind);
    FolderLock(FolderLock&& other) noexcept;
    FolderLock& operator=(FolderLock&&) = delete;
    ~FolderLock();

  private:
    int descriptor_;
};

}  // namespace ropesim
