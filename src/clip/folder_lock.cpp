#include "clip/folder_lock.h"

#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

#include <cerrno>
#include <chrono>
#include <stdexcept>
#include <system_error>
#include <thread>
#include <utility>

namespace ropesim {
namespace {

constexpr std::chrono::milliseconds patience{2000};
constexpr std::chrono::milliseconds between_tries{10};

// Of shards, each has a lock on one byte of the folder, whose number stands for the clip.
struct flock byte_lock(short type, off_t start, off_t length) {
    struct flock lock {};
    lock.l_type = type;
    lock.l_whence = SEEK_SET;
    lock.l_start = start;
    lock.l_len = length;
    return lock;
}

// A length of 0 goes to the end.
bool is_locked_by_others(int descriptor, off_t start, off_t length) {
    struct flock lock = byte_lock(F_WRLCK, start, length);
    return ::fcntl(descriptor, F_OFD_GETLK, &lock) == 0 && lock.l_type != F_UNLCK;
}

// False where shards of another clip are at work.
bool share(int descriptor, const std::string& clip_digest) {
    const auto byte = static_cast<off_t>(1 + std::stoull(clip_digest.substr(0, 12), nullptr, 16));
    struct flock ours = byte_lock(F_RDLCK, byte, 1);
    ::fcntl(descriptor, F_OFD_SETLK, &ours);
    if (!is_locked_by_others(descriptor, 0, byte) && !is_locked_by_others(descriptor, byte + 1, 0))
        return true;
    ours.l_type = F_UNLCK;
    ::fcntl(descriptor, F_OFD_SETLK, &ours);
    return false;
}

// False where another process keeps us out.
bool take(int descriptor, const std::string& clip_digest) {
    const bool alone = clip_digest.empty();
    if (::flock(descriptor, (alone ? LOCK_EX : LOCK_SH) | LOCK_NB) != 0) return errno != EWOULDBLOCK;
    return alone || share(descriptor, clip_digest);
}

}  // namespace

FolderLock::FolderLock(const std::filesystem::path& folder, const std::string& clip_digest)
    : descriptor_(::open(folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC)) {
    if (descriptor_ < 0)
        throw std::runtime_error(folder.string() +
                                 ": cannot open the folder: " + std::generic_category().message(errno));
    for (auto waited = std::chrono::milliseconds(0); !take(descriptor_, clip_digest);
         waited += between_tries) {
        if (waited >= patience) {
            ::close(descriptor_);
            throw std::runtime_error(folder.string() + ": another ropesim is writing there" +
                                     (clip_digest.empty() ? "" : ", and no shard of the same clip") +
                                     "; wait until it has ended, or name another folder");
        }
        std::this_thread::sleep_for(between_tries);
    }
}

FolderLock::FolderLock(FolderLock&& other) noexcept : descriptor_(std::exchange(other.descriptor_, -1)) {}

FolderLock::~FolderLock() {
    if (descriptor_ >= 0) ::close(descriptor_);
}

}  // namespace ropesim
