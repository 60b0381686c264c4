#pragma once

#include <filesystem>
#include <string>

namespace ropesim {

// Keeps other processes of ropesim from writing into a folder while it lives. It leaves no file, and
// the system lets go of it when the process has ended, however it ended, and its helpers with it. Where the
// file system has no locks (some of networks), nobody is kept out.
class FolderLock {
  public:
    // Of those that name the same clip, by a digest, several share a folder, as its shards; without a name,
    // none does. Throws std::runtime_error where another process is at work there and does not end within two
    // seconds (as helpers of a killed one do, after the frame they are at).
    FolderLock(const std::filesystem::path& folder, const std::string& clip_digest);
    FolderLock(FolderLock&& other) noexcept;
    FolderLock& operator=(FolderLock&&) = delete;
    ~FolderLock();

  private:
    int descriptor_;
};

}  // namespace ropesim
