#include "clip/file.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <charconv>
#include <csignal>
#include <cstring>
#include <stdexcept>
#include <string>
#include <utility>

namespace ropesim {
namespace {

[[noreturn]] void fail(const std::filesystem::path& path, const std::string& what, int error = errno) {
    throw std::runtime_error(path.string() + ": " + what + ": " + std::strerror(error));
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
    bool close() { return ::close(std::exchange(number_, -1)) == 0; }

  private:
    int number_;
};

void write_all(Descriptor& file, std::span<const std::uint8_t> bytes, const std::filesystem::path& path) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file.number(), bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail(path, "cannot write");
        bytes = bytes.subspan(static_cast<std::size_t>(written));
    }
    if (!file.close()) fail(path, "cannot write");
}

// Temporary files of this machine are named .ropesim-<host>-<process>.tmp.
std::string temporary_prefix() {
    std::array<char, 65> host{};
    ::gethostname(host.data(), host.size() - 1);
    return ".ropesim-" + std::string(host.data()) + "-";
}
constexpr std::string_view temporary_suffix = ".tmp";

// The process in the name of a temporary file; 0 for any other name.
pid_t process_of(std::string_view name, const std::string& prefix) {
    if (!name.starts_with(prefix) || !name.ends_with(temporary_suffix)) return 0;
    name.remove_prefix(prefix.size());
    name.remove_suffix(temporary_suffix.size());
    pid_t process = 0;
    const auto [end, error] = std::from_chars(name.data(), name.data() + name.size(), process);
    return error == std::errc() && end == name.data() + name.size() ? process : 0;
}

}  // namespace

std::vector<std::uint8_t> read_file(const std::filesystem::path& path) {
    Descriptor file(::open(path.c_str(), O_RDONLY | O_CLOEXEC));
    if (file.number() < 0) fail(path, "cannot open");
    std::vector<std::uint8_t> bytes;
    std::array<std::uint8_t, 1 << 16> buffer;
    for (;;) {
        const ssize_t count = ::read(file.number(), buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count < 0) fail(path, "cannot read");
        if (count == 0) return bytes;
        bytes.insert(bytes.end(), buffer.begin(), buffer.begin() + count);
    }
}

void write_file(const std::filesystem::path& path, std::span<const std::uint8_t> bytes) {
    struct stat status {};
    if (::stat(path.c_str(), &status) == 0 && !S_ISREG(status.st_mode)) {  // a pipe, a terminal, /dev/null
        Descriptor file(::open(path.c_str(), O_WRONLY | O_CLOEXEC));
        if (file.number() < 0) fail(path, "cannot write");
        return write_all(file, bytes, path);
    }
    const std::filesystem::path temporary =
        path.parent_path() /
        (temporary_prefix() + std::to_string(::getpid()) + std::string(temporary_suffix));
    try {
        Descriptor file(::open(temporary.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666));
        if (file.number() < 0) fail(path, "cannot write");
        write_all(file, bytes, path);
        if (::rename(temporary.c_str(), path.c_str()) != 0) fail(path, "cannot write");
    } catch (...) {
        ::unlink(temporary.c_str());
        throw;
    }
}

void write_file(const std::filesystem::path& path, std::string_view text) {
    write_file(path, std::span(reinterpret_cast<const std::uint8_t*>(text.data()), text.size()));
}

void remove_stale_temporaries(const std::filesystem::path& folder) {
    const std::string prefix = temporary_prefix();
    for (const auto& entry : std::filesystem::directory_iterator(folder)) {
        const pid_t process = process_of(entry.path().filename().string(), prefix);
        if (process > 0 && ::kill(process, 0) != 0 && errno == ESRCH) std::filesystem::remove(entry.path());
    }
}

}  // namespace ropesim
