// Loaded ahead of the C library (LD_PRELOAD), makes one call of a program fail, to see what the program makes
// of it. Counts the calls that concern the folder ROPESIM_FAULT_FOLDER, or standard output once it is
// duplicated, and those that start processes, if they may fail so, from 1; the one of number ROPESIM_FAULT_AT
// fails as ROPESIM_FAULT_KIND says: by that errno, or "short", which writes or reads a byte at most. With
// ROPESIM_FAULT_PLACE instead, there is no memory, once, at the place of that number in the program where
// some is taken, in the order in which they are reached; what libraries take that it is linked with counts as
// taken by the place that called them. ROPESIM_FAULT_LIBRARIES=1 has no library of OpenGL.
//
// Where it has failed a call, the file ROPESIM_FAULT_MARK names it. Helpers count for themselves.

#include <dirent.h>
#include <dlfcn.h>
#include <fcntl.h>
#include <link.h>
#include <poll.h>
#include <spawn.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>
#include <unwind.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cerrno>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <new>

namespace {

constexpr std::size_t most_files = 1024;
constexpr int short_count = -1;  // the kind that is no errno

const char* folder = nullptr;
long fail_at = 0;
int kind = 0;
long fail_at_place = 0;
bool no_libraries = false;
long calls = 0;
bool in_main = false;  // what fails before it, nobody could catch
int (*program_main)(int, char**, char**) = nullptr;
std::array<bool, most_files> watched{};  // descriptors of files in the folder

long number_in(const char* variable) {
    const char* text = std::getenv(variable);
    return text ? std::strtol(text, nullptr, 10) : 0;
}

// Where the code of an object lies.
struct Object {
    std::uintptr_t begin = UINTPTR_MAX;
    std::uintptr_t end = 0;

    bool has(std::uintptr_t address) const { return begin <= address && address < end; }
};

// The program, and the libraries that it is linked with. Those that are loaded later keep their memory, and
// so does the one that unwinds the stack: we need it to see whose memory it is.
std::array<Object, 64> objects;
std::size_t object_count = 0;

int add_object(dl_phdr_info* info, std::size_t, void*) {
    if (std::strstr(info->dlpi_name, "libgcc_s")) return 0;
    Object& object = objects[object_count++];
    for (int i = 0; i < info->dlpi_phnum; ++i) {
        if (info->dlpi_phdr[i].p_type != PT_LOAD) continue;
        const std::uintptr_t begin = info->dlpi_addr + info->dlpi_phdr[i].p_vaddr;
        if (begin < object.begin) object.begin = begin;
        if (begin + info->dlpi_phdr[i].p_memsz > object.end) object.end = begin + info->dlpi_phdr[i].p_memsz;
    }
    return object_count == objects.size() ? 1 : 0;
}

// Not in programs that ropesim runs.
__attribute__((constructor)) void begin() {
    if (std::strcmp(program_invocation_short_name, "ropesim") != 0) return;
    dl_iterate_phdr(add_object, nullptr);
    const char* text = std::getenv("ROPESIM_FAULT_KIND");
    kind = text && std::strcmp(text, "short") == 0 ? short_count
                                                   : static_cast<int>(number_in("ROPESIM_FAULT_KIND"));
    fail_at = number_in("ROPESIM_FAULT_AT");
    fail_at_place = number_in("ROPESIM_FAULT_PLACE");
    no_libraries = number_in("ROPESIM_FAULT_LIBRARIES") != 0;
    folder = std::getenv("ROPESIM_FAULT_FOLDER");
}

template <class Function>
Function real(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

// Without calls that would be counted.
void mark(const char* what) {
    const char* path = std::getenv("ROPESIM_FAULT_MARK");
    if (!path) return;
    const long file = syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_APPEND, 0600);
    syscall(SYS_write, file, what, std::strlen(what));
    syscall(SYS_write, file, "\n", 1);
    syscall(SYS_close, file);
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
    mark(name);
    errno = kind;
    return true;
}

int counted_main(int count, char** arguments, char** environment) {
    in_main = true;
    const int status = program_main(count, arguments, environment);
    in_main = false;
    return status;
}

}  // namespace

extern "C" {

int __libc_start_main(int (*start)(int, char**, char**), int count, char** arguments, void (*init)(),
                      void (*fini)(), void (*loader_fini)(), void* stack_end) {
    program_main = start;
    using Start =
        int (*)(int (*)(int, char**, char**), int, char**, void (*)(), void (*)(), void (*)(), void*);
    return real<Start>("__libc_start_main")(counted_main, count, arguments, init, fini, loader_fini,
                                            stack_end);
}

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

namespace {

const Object* object_with(std::uintptr_t address) {
    const auto end = objects.begin() + object_count;
    const auto found =
        std::find_if(objects.begin(), end, [&](const Object& each) { return each.has(address); });
    return found == end ? nullptr : &*found;
}

// Looks at the callers one by one, the nearest first.
_Unwind_Reason_Code look(_Unwind_Context* context, void* place) {
    const std::uintptr_t address = _Unwind_GetIP(context);
    const Object* const object = object_with(address);
    if (!object) return _URC_END_OF_STACK;
    if (object != &objects.front()) return _URC_NO_REASON;
    *static_cast<std::uintptr_t*>(place) = address - object->begin;
    return _URC_END_OF_STACK;
}

// Adds it to those that were reached; its number where it is new, else 0.
long number_of_new(std::uintptr_t place) {
    static std::atomic_flag busy;
    static std::array<std::uintptr_t, 1 << 16> reached;
    static long count = 0;
    while (busy.test_and_set()) {
    }
    const auto end = reached.begin() + count;
    const bool is_new = std::find(reached.begin(), end, place) == end && end != reached.end();
    if (is_new) reached[static_cast<std::size_t>(count++)] = place;
    const long number = is_new ? count : 0;
    busy.clear();
    return number;
}

bool has_no_memory(const void* caller) {
    if (!in_main || fail_at_place == 0) return false;
    if (!object_with(reinterpret_cast<std::uintptr_t>(caller))) return false;
    std::uintptr_t place = 0;
    _Unwind_Backtrace(look, &place);
    if (place == 0 || number_of_new(place) != fail_at_place) return false;
    std::array<char, 64> text;
    std::snprintf(text.data(), text.size(), "memory at %#lx", place);
    mark(text.data());
    errno = ENOMEM;
    return true;
}

}  // namespace

extern "C" {

void* malloc(std::size_t size) {
    static const auto next = real<void* (*)(std::size_t)>("malloc");
    return has_no_memory(__builtin_return_address(0)) ? nullptr : next(size);
}

void* calloc(std::size_t count, std::size_t size) {
    static const auto next = real<void* (*)(std::size_t, std::size_t)>("calloc");
    return has_no_memory(__builtin_return_address(0)) ? nullptr : next(count, size);
}

void* realloc(void* block, std::size_t size) {
    static const auto next = real<void* (*)(void*, std::size_t)>("realloc");
    return has_no_memory(__builtin_return_address(0)) ? nullptr : next(block, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
    static const auto next = real<void* (*)(std::size_t, std::size_t)>("aligned_alloc");
    return has_no_memory(__builtin_return_address(0)) ? nullptr : next(alignment, size);
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
    static const auto next = real<int (*)(void**, std::size_t, std::size_t)>("posix_memalign");
    return has_no_memory(__builtin_return_address(0)) ? ENOMEM : next(block, alignment, size);
}

}  // extern "C"

#ifdef ROPESIM_SANITIZED
// The sanitizer's own would not ask malloc.
namespace {

void* allocated(std::size_t size) {
    void* memory = std::malloc(size == 0 ? 1 : size);
    if (!memory) throw std::bad_alloc();
    return memory;
}

}  // namespace

void* operator new(std::size_t size) {
    return allocated(size);
}
void* operator new[](std::size_t size) {
    return allocated(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}
#endif
