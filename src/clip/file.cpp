#include "clip/file.h"

#include <dirent.h>
#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <system_error>
#include <tuple>
#include <utility>

namespace ropesim {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what, int error = errno) {
    throw std::runtime_error(path.string() + ": " + what + ": " + std::generic_category().message(error));
}

void check_size(const std::filesystem::path& path, std::uint64_t size, std::uint64_t largest) {
    if (size > largest)
        throw std::runtime_error(path.string() + ": found " + std::to_string(size) +
                                 " bytes or more, expected at most " + std::to_string(largest));
}

// A file descriptor that is closed when it goes.
class Descriptor {
  public:
    explicit Descriptor(int number) : number_(number) {}
    ~Descriptor() {
        if (number_ >= 0) ::close(number_);
    }
    Descriptor(const Descriptor&) = delete;
    Descriptor& operator=(const Descriptor&) = delete;

    int number() const { return number_; }

  private:
    int number_;
};

constexpr std::size_t written_at_once = std::size_t{1} << 16;

bool is_regular_or_missing(const std::filesystem::path& path) {
    struct stat status {};
    return ::stat(path.c_str(), &status) != 0 || S_ISREG(status.st_mode);
}

// The size of a regular file; none of anything else.
std::optional<std::uint64_t> regular_size(int file) {
    struct stat status {};
    if (::fstat(file, &status) != 0 || !S_ISREG(status.st_mode)) return std::nullopt;
    return static_cast<std::uint64_t>(status.st_size);
}

std::vector<std::uint8_t> read_all(const std::filesystem::path& path, int file, std::uint64_t largest) {
    check_size(path, regular_size(file).value_or(0), largest);
    std::vector<std::uint8_t> bytes;
    std::array<std::uint8_t, 1 << 16> buffer;
    for (;;) {
        const ssize_t count = ::read(file, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(path, "cannot read");
        if (count == 0) return bytes;
        check_size(path, bytes.size() + static_cast<std::uint64_t>(count), largest);
        bytes.insert(bytes.end(), buffer.begin(), buffer.begin() + count);
    }
}

void read_at(const std::filesystem::path& path, int file, std::uint64_t offset,
             std::span<std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::pread(file, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(path, "cannot read");
        if (count == 0) throw std::runtime_error(path.string() + ": has changed while it was read");
        bytes = bytes.subspan(static_cast<std::size_t>(count));
        offset += static_cast<std::uint64_t>(count);
    }
}

constexpr std::string_view temporary_begin = ".ropesim-";
constexpr std::string_view temporary_suffix = ".tmp";

// Temporary files of this machine are named .ropesim-<host>-<process>.tmp, or .ropesim-<host>-<process>-1.tmp
// and so on where a process writes several at once.
std::string temporary_prefix() {
    std::array<char, 65> host{};
    ::gethostname(host.data(), host.size() - 1);
    return std::string(temporary_begin) + host.data() + "-";
}

// The process in the name of a temporary file; 0 for any other name.
pid_t process_of(std::string_view name, const std::string& prefix) {
    if (!name.starts_with(prefix) || !name.ends_with(temporary_suffix)) return 0;
    name.remove_prefix(prefix.size());
    name.remove_suffix(temporary_suffix.size());
    pid_t process = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), process);
    const bool ends = end == name.data() + name.size() || *end == '-';
    return error == std::errc() && ends ? process : 0;
}

bool is_dead(pid_t process) {
    return ::kill(process, 0) != 0 && errno == ESRCH;
}

struct Temporary {
    std::filesystem::path path;
    pid_t process;  // that writes or wrote it; 0 where it is of another machine
};

std::vector<Temporary> temporaries(const std::filesystem::path& folder) {
    const std::string prefix = temporary_prefix();
    std::vector<Temporary> found;
    for (const std::string& name : names_in(folder))
        if (name.starts_with(temporary_begin) && name.ends_with(temporary_suffix))
            found.push_back({folder / name, process_of(name, prefix)});
    return found;
}

}  // namespace

std::vector<std::string> names_in(const std::filesystem::path& folder) {
    const std::unique_ptr<DIR, int (*)(DIR*)> open_folder(::opendir(folder.c_str()), ::closedir);
    if (!open_folder) fail(folder, "cannot read the folder");
    std::vector<std::string> names;
    for (;;) {
        errno = 0;
        const dirent* const entry = ::readdir(open_folder.get());  // NOLINT(concurrency-mt-unsafe): our own
        if (!entry && errno != 0) fail(folder, "cannot read the folder");
        if (!entry) return names;
        const std::string name(static_cast<const char*>(entry->d_name));
        if (name != "." && name != "..") names.push_back(name);
    }
}

OpenFile::OpenFile(std::filesystem::path path)
    : path_(std::move(path)), descriptor_(::open(path_.c_str(), O_RDONLY | O_CLOEXEC)), opened_{} {
    if (descriptor_ < 0) fail(path_, "cannot open");
    ::fstat(descriptor_, &opened_);
}

OpenFile::~OpenFile() {
    ::close(descriptor_);
}

std::optional<std::uint64_t> OpenFile::size() const {
    if (!S_ISREG(opened_.st_mode)) return std::nullopt;
    return static_cast<std::uint64_t>(opened_.st_size);
}

void OpenFile::read_at(std::uint64_t offset, std::span<std::uint8_t> bytes) const {
    ropesim::read_at(path_, descriptor_, offset, bytes);
    struct stat now {};
    ::fstat(descriptor_, &now);
    const auto version = [](const struct stat& status) {
        return std::tuple(status.st_size, status.st_mtim.tv_sec, status.st_mtim.tv_nsec);
    };
    if (version(now) != version(opened_))
        throw std::runtime_error(path_.string() + ": has changed while it was read");
}

std::vector<std::uint8_t> OpenFile::read_all(std::uint64_t largest) const {
    return ropesim::read_all(path_, descriptor_, largest);
}

std::vector<std::uint8_t> read_file(const std::filesystem::path& path, std::uint64_t largest) {
    return OpenFile(path).read_all(largest);
}

std::vector<std::uint8_t> read_regular_file(const std::filesystem::path& path) {
    const Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC | O_NONBLOCK));
    if (file.number() < 0) fail(path, "cannot open");
    if (!regular_size(file.number())) throw std::runtime_error(path.string() + ": is no regular file");
    return read_all(path, file.number(), largest_file);
}

NewFile::NewFile(std::filesystem::path path, Place place) : path_(std::move(path)) {
    if (place == Place::named && path_ == "-") {
        descriptor_ = ::dup(STDOUT_FILENO);
    } else if (place == Place::named && !is_regular_or_missing(path_)) {
        descriptor_ = ::open(path_.c_str(), O_WRONLY | O_CLOEXEC);
    } else {
        const std::string begin = temporary_prefix() + std::to_string(::getpid());
        for (int i = 0; descriptor_ < 0 && (i == 0 || errno == EEXIST); ++i) {
            std::string name = begin;
            if (i > 0) name.append("-").append(std::to_string(i));
            temporary_ = path_.parent_path() / name.append(temporary_suffix);
            descriptor_ = ::open(temporary_.c_str(), O_RDWR | O_CREAT | O_EXCL | O_CLOEXEC, 0666);
        }
    }
    if (descriptor_ < 0) fail("cannot write");
}

NewFile::~NewFile() {
    if (descriptor_ >= 0) ::close(descriptor_);
    if (!temporary_.empty()) ::unlink(temporary_.c_str());
}

void NewFile::append(std::span<const std::uint8_t> bytes) {
    if (unwritten_.size() + bytes.size() > written_at_once) flush();
    if (bytes.size() > written_at_once)
        write(bytes);
    else
        unwritten_.insert(unwritten_.end(), bytes.begin(), bytes.end());
}

void NewFile::append(std::string_view text) {
    append(std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

void NewFile::flush() {
    write(unwritten_);
    unwritten_.clear();
}

void NewFile::write(std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(descriptor_, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail("cannot write");
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
}

void NewFile::write_at(std::uint64_t offset, std::span<const std::uint8_t> bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::pwrite(descriptor_, bytes.data(), bytes.size(), static_cast<off_t>(offset));
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail("cannot write");
        bytes = bytes.subspan(static_cast<std::size_t>(written));
        offset += static_cast<std::uint64_t>(written);
    }
}

void NewFile::read_at(std::uint64_t offset, std::span<std::uint8_t> bytes) const {
    ropesim::read_at(path_, descriptor_, offset, bytes);
}

void NewFile::set_size(std::uint64_t size) {
    if (::ftruncate(descriptor_, static_cast<off_t>(size)) != 0) fail("cannot write");
}

void NewFile::sync() {
    flush();
    while (::fdatasync(descriptor_) != 0)
        if (errno != EINTR) fail("cannot sync");
}

void NewFile::finish() {
    flush();
    if (::close(std::exchange(descriptor_, -1)) != 0) fail("cannot write");
    if (temporary_.empty()) return;
    if (::rename(temporary_.c_str(), path_.c_str()) != 0) fail("cannot write");
    temporary_.clear();
}

void NewFile::fail(const char* what) const {
    ropesim::fail(path_ == "-" ? "standard output" : path_, what);
}

void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes, Place place) {
    NewFile file(path, place);
    file.append(bytes);
    file.finish();
}

void write_file(const std::filesystem::path& path, std::string_view text, Place place) {
    write_file(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()), place);
}

void check_writable(const std::filesystem::path& path) {
    if (path == "-") return;
    std::error_code error;
    if (std::filesystem::is_directory(path, error)) fail(path, "cannot write", EISDIR);
    if (error == std::errc::filename_too_long) fail(path, "cannot write", ENAMETOOLONG);
    const std::filesystem::path folder = path.has_parent_path() ? path.parent_path() : ".";
    if (is_regular_or_missing(path) && ::access((folder / ".").c_str(), W_OK | X_OK) != 0)
        fail(path, "cannot write");
}

void make_folder(const std::filesystem::path& folder) {
    std::error_code error;
    std::filesystem::create_directory(folder, error);
    std::error_code ignored;
    if (std::filesystem::exists(folder, ignored) && !std::filesystem::is_directory(folder, ignored))
        throw std::runtime_error(folder.string() + ": is no folder; expected one, or nothing of that name");
    if (error) throw std::runtime_error(folder.string() + ": cannot make the folder: " + error.message());
}

void sync_folder(const std::filesystem::path& folder) {
    Descriptor file(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
    if (file.number() < 0) fail(folder, "cannot open");
    while (::fsync(file.number()) != 0)
        if (errno != EINTR) fail(folder, "cannot sync");
}

std::vector<std::filesystem::path> stray_temporaries(const std::filesystem::path& folder) {
    std::vector<std::filesystem::path> strays;
    for (const auto& [path, process] : temporaries(folder))
        if (process == 0 || is_dead(process)) strays.push_back(path);
    std::ranges::sort(strays);
    return strays;
}

void remove_stale_temporaries(const std::filesystem::path& folder) {
    for (const auto& [path, process] : temporaries(folder))
        if (process > 0 && is_dead(process)) std::filesystem::remove(path);
}

}  // namespace ropesim
