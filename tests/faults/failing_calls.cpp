// Counts the calls that concern the folder ROPESIM_FAULT_FOLDER, or standard output once it is duplicated,
// and those that start processes, if they may fail so, from 1; the one of number ROPESIM_FAULT_AT fails as
// ROPESIM_FAULT_KIND says: by that errno, or "short", which writes or reads a byte at most.
// ROPESIM_FAULT_LIBRARIES=1 has no library of OpenGL.

#include "faults/fault_shim.h"

#include <dirent.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/stat.h>

#include <array>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <initializer_list>

namespace {

using fault::real;

constexpr std::size_t most_files = 1024;
constexpr int short_count = -1;  // the kind that is no errno

const char* folder = nullptr;
long fail_at = 0;
int kind = 0;
bool no_libraries = false;
long calls = 0;
std::array<bool, most_files> watched{};  // descriptors of files in the folder

__attribute__((constructor)) void begin() {
    if (!fault::is_in_ropesim()) return;
    const char* text = std::getenv("ROPESIM_FAULT_KIND");
    kind = text && std::strcmp(text, "short") == 0 ? short_count
                                                   : static_cast<int>(fault::number_in("ROPESIM_FAULT_KIND"));
    fail_at = fault::number_in("ROPESIM_FAULT_AT");
    no_libraries = fault::number_in("ROPESIM_FAULT_LIBRARIES") != 0;
    folder = std::getenv("ROPESIM_FAULT_FOLDER");
}

bool is_in_folder(const char* path) {
    return folder && std::strncmp(path, folder, std::strlen(folder)) == 0;
}

bool is_watched(int descriptor) {
    return descriptor >= 0 && static_cast<std::size_t>(descriptor) < most_files &&
           watched[static_cast<std::size_t>(descriptor)];
}

int watch(int descriptor, bool is_of_folder) {
    if (descriptor >= 0 && static_cast<std::size_t>(descriptor) < most_files)
        watched[static_cast<std::size_t>(descriptor)] = is_of_folder;
    return descriptor;
}

bool is_one_of(const char* name, std::initializer_list<const char*> names) {
    for (const char* each : names)
        if (std::strcmp(name, each) == 0) return true;
    return false;
}

// Whether a call of that name may fail so.
bool is_likely(const char* name) {
    switch (kind) {
        case short_count:
            return is_one_of(name, {"read", "pread", "write", "pwrite"});
        case ENOSPC:
        case EDQUOT:
            return is_one_of(name, {"open", "openat", "write", "pwrite", "close", "mkdir", "rename", "fsync",
                                    "fdatasync", "ftruncate"});
        case EMFILE:
            return is_one_of(name, {"open", "openat", "dup", "fork", "socketpair", "pipe2"});
        case EINTR:
            return is_one_of(name, {"open", "openat", "read", "pread", "write", "pwrite", "close", "fsync",
                                    "fdatasync", "fcntl", "poll", "send"});
        default:
            return true;
    }
}

bool fails(bool concerned, const char* name) {
    if (!concerned || !folder || !is_likely(name) || ++calls != fail_at) return false;
    fault::mark(name);
    errno = kind;
    return true;
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
    va_list more;
    va_start(more, flags);
    const mode_t mode = (flags & O_CREAT) ? va_arg(more, mode_t) : 0;
    va_end(more);
    if (fails(is_in_folder(path), "open")) return -1;
    return watch(real<int (*)(const char*, int, ...)>("open")(path, flags, mode), is_in_folder(path));
}

int open64(const char* path, int flags, ...) {
    va_list more;
    va_start(more, flags);
    const mode_t mode = (flags & O_CREAT) ? va_arg(more, mode_t) : 0;
    va_end(more);
    return open(path, flags, mode);
}

int openat(int at, const char* path, int flags, ...) {
    va_list more;
    va_start(more, flags);
    const mode_t mode = (flags & O_CREAT) ? va_arg(more, mode_t) : 0;
    va_end(more);
    if (fails(is_in_folder(path), "openat")) return -1;
    return watch(real<int (*)(int, const char*, int, ...)>("openat")(at, path, flags, mode),
                 is_in_folder(path));
}

int openat64(int at, const char* path, int flags, ...) {
    va_list more;
    va_start(more, flags);
    const mode_t mode = (flags & O_CREAT) ? va_arg(more, mode_t) : 0;
    va_end(more);
    return openat(at, path, flags, mode);
}

int dup(int descriptor) {
    const bool is_output = descriptor == STDOUT_FILENO;
    if (fails(is_output, "dup")) return -1;
    return watch(real<int (*)(int)>("dup")(descriptor), is_output || is_watched(descriptor));
}

int close(int descriptor) {
    const bool concerned = is_watched(descriptor);
    watch(descriptor, false);
    const int result = real<int (*)(int)>("close")(descriptor);
    return fails(concerned, "close") ? -1 : result;
}

ssize_t write(int file, const void* bytes, std::size_t size) {
    if (fails(is_watched(file), "write")) {
        if (kind != short_count) return -1;
        size = size > 1 ? 1 : size;
    }
    return real<ssize_t (*)(int, const void*, std::size_t)>("write")(file, bytes, size);
}

ssize_t pwrite(int file, const void* bytes, std::size_t size, off_t offset) {
    if (fails(is_watched(file), "pwrite")) {
        if (kind != short_count) return -1;
        size = size > 1 ? 1 : size;
    }
    return real<ssize_t (*)(int, const void*, std::size_t, off_t)>("pwrite")(file, bytes, size, offset);
}

ssize_t pwrite64(int file, const void* bytes, std::size_t size, off64_t offset) {
    return pwrite(file, bytes, size, offset);
}

ssize_t read(int file, void* bytes, std::size_t size) {
    if (fails(is_watched(file), "read")) {
        if (kind != short_count) return -1;
        size = size > 1 ? 1 : size;
    }
    return real<ssize_t (*)(int, void*, std::size_t)>("read")(file, bytes, size);
}

ssize_t pread(int file, void* bytes, std::size_t size, off_t offset) {
    if (fails(is_watched(file), "pread")) {
        if (kind != short_count) return -1;
        size = size > 1 ? 1 : size;
    }
    return real<ssize_t (*)(int, void*, std::size_t, off_t)>("pread")(file, bytes, size, offset);
}

ssize_t pread64(int file, void* bytes, std::size_t size, off64_t offset) {
    return pread(file, bytes, size, offset);
}

int ftruncate(int file, off_t size) {
    if (fails(is_watched(file), "ftruncate")) return -1;
    return real<int (*)(int, off_t)>("ftruncate")(file, size);
}

int ftruncate64(int file, off64_t size) {
    return ftruncate(file, size);
}

int fsync(int file) {
    if (fails(is_watched(file), "fsync")) return -1;
    return real<int (*)(int)>("fsync")(file);
}

int fdatasync(int file) {
    if (fails(is_watched(file), "fdatasync")) return -1;
    return real<int (*)(int)>("fdatasync")(file);
}

int fcntl(int file, int command, ...) {
    va_list more;
    va_start(more, command);
    void* const argument = va_arg(more, void*);
    va_end(more);
    if (fails(command == F_OFD_SETLK && is_watched(file), "fcntl")) return -1;
    return real<int (*)(int, int, ...)>("fcntl")(file, command, argument);
}

int fcntl64(int file, int command, ...) {
    va_list more;
    va_start(more, command);
    void* const argument = va_arg(more, void*);
    va_end(more);
    return fcntl(file, command, argument);
}

ssize_t send(int socket, const void* bytes, std::size_t size, int flags) {
    if (fails(true, "send")) return -1;
    return real<ssize_t (*)(int, const void*, std::size_t, int)>("send")(socket, bytes, size, flags);
}

int poll(pollfd* files, nfds_t count, int timeout) {
    if (fails(true, "poll")) return -1;
    return real<int (*)(pollfd*, nfds_t, int)>("poll")(files, count, timeout);
}

int posix_spawnp(pid_t* process, const char* file, const posix_spawn_file_actions_t* actions,
                 const posix_spawnattr_t* attributes, char* const arguments[], char* const environment[]) {
    if (fails(true, "posix_spawnp")) return kind;
    using Spawn = int (*)(pid_t*, const char*, const posix_spawn_file_actions_t*, const posix_spawnattr_t*,
                          char* const*, char* const*);
    return real<Spawn>("posix_spawnp")(process, file, actions, attributes, arguments, environment);
}

int rename(const char* from, const char* to) {
    if (fails(is_in_folder(from) || is_in_folder(to), "rename")) return -1;
    return real<int (*)(const char*, const char*)>("rename")(from, to);
}

int mkdir(const char* path, mode_t mode) {
    if (fails(is_in_folder(path), "mkdir")) return -1;
    return real<int (*)(const char*, mode_t)>("mkdir")(path, mode);
}

int unlink(const char* path) {
    if (fails(is_in_folder(path), "unlink")) return -1;
    return real<int (*)(const char*)>("unlink")(path);
}

int remove(const char* path) {
    if (fails(is_in_folder(path), "remove")) return -1;
    return real<int (*)(const char*)>("remove")(path);
}

dirent* readdir(DIR* directory) {
    if (fails(is_watched(dirfd(directory)), "readdir")) return nullptr;
    return real<dirent* (*)(DIR*)>("readdir")(directory);
}

pid_t fork() {
    if (fails(true, "fork")) return -1;
    return real<pid_t (*)()>("fork")();
}

int socketpair(int domain, int type, int protocol, int ends[2]) {
    if (fails(true, "socketpair")) return -1;
    return real<int (*)(int, int, int, int*)>("socketpair")(domain, type, protocol, ends);
}

int pipe2(int ends[2], int flags) {
    if (fails(true, "pipe2")) return -1;
    return real<int (*)(int*, int)>("pipe2")(ends, flags);
}

void* dlopen(const char* name, int flags) {
    const bool is_opengl = name && (std::strstr(name, "libOSMesa") || std::strstr(name, "libEGL"));
    return real<void* (*)(const char*, int)>("dlopen")(no_libraries && is_opengl ? "libnone.so" : name,
                                                       flags);
}

}  // extern "C"
