#include "clip/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <cstring>
#include <stdexcept>
#include <thread>
#include <utility>

namespace ropesim {
namespace {

constexpr std::chrono::milliseconds patience{2000};
constexpr std::chrono::milliseconds between_tries{10};

// False where another process holds it.
bool take(int descriptor, FolderLock::Kind kind) {
    const int operation = kind == FolderLock::Kind::alone ? LOCK_EX : LOCK_SH;
    return ::flock(descriptor, operation | LOCK_NB) == 0 || errno != EWOULDBLOCK;
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder, Kind kind)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ < 0)
        throw std::runtime_error(folder.string() + ": cannot open the folder: " + std::strerror(errno));
    for (auto waited = std::chrono::milliseconds(0); !take(descriptor_, kind); waited += between_tries) {
        if (waited >= patience) {
            ::close(descriptor_);
            throw std::runtime_error(folder.string() +
                                     ": another ropesim is writing frames there, and only shards of one clip "
                                     "share a folder; wait for it, or name another with -o");
        }
        std::this_thread::sleep_for(between_tries);
    }
}

FolderLock::FolderLock(FolderLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

FolderLock::~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace ropesim
