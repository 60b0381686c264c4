#include "clip/helpers.h"

#include "clip/interrupt.h"
#include "clip/want_of_memory.h"
#include "scene/words.h"

#include <poll.h>
#include <sys/mman.h>
#include <sys/prctl.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <exception>
#include <new>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>

namespace ropesim {
namespace {

// Frames that a helper has at once: one that it draws and one that waits, so that it need not. More would
// leave it with more to do than the others in the end.
constexpr std::size_t most_frames = 2;

// What a helper sends for each frame that it has drawn. Where it fails, it sends why instead, and ends.
constexpr char drawn_mark = '\1';

// False where nobody reads any more.
bool send_all(int socket, std::span<const std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t sent = ::send(socket, bytes.data(), bytes.size(), MSG_NOSIGNAL);
        if (sent < 0 && errno == EINTR) {
            Interrupts::check();
            continue;
        }
        if (sent < 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(sent));
    }
    return true;
}

// False where the other end has been closed.
bool read_all(int file, std::span<std::byte> bytes) {
    while (!bytes.empty()) {
        const ssize_t count = ::read(file, bytes.data(), bytes.size());
        if (count < 0 && errno == EINTR) {
            Interrupts::check();
            continue;
        }
        if (count <= 0) return false;
        bytes = bytes.subspan(static_cast<std::size_t>(count));
    }
    return true;
}

[[noreturn]] void throw_cannot_start(int error) {
    throw std::runtime_error("cannot start a job: " + std::generic_category().message(error));
}

int own_socket = -1;  // a helper's

[[noreturn]] void end_with(std::string_view failure) {
    ::send(own_socket, failure.data(), failure.size(), MSG_NOSIGNAL);
    ::_exit(1);
}

[[noreturn]] void end_where_none_may_pass() {
    if (is_want_of_memory(std::current_exception())) end_with(want_of_memory);
    std::abort();
}

// What a helper has sent by now; nothing where it has ended.
std::string received(int socket) {
    std::array<char, 4096> bytes;
    const ssize_t count = ::recv(socket, bytes.data(), bytes.size(), MSG_DONTWAIT);
    return {bytes.data(), static_cast<std::size_t>(std::max<ssize_t>(count, 0))};
}

// All that one that has ended had sent, without the marks of what it drew: why it failed, where it did.
std::string last_words(int socket, std::string words) {
    for (std::string more = received(socket); !more.empty(); more = received(socket)) words += more;
    return words.substr(std::min(words.find_first_not_of(drawn_mark), words.size()));
}

// Waits for a process to end.
int status_of(pid_t process) {
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

// The signal that ended a process, or that it ended itself for; 0 where there was none.
int signal_of(int status) {
    if (WIFSIGNALED(status)) return WTERMSIG(status);
    return std::max(0, WEXITSTATUS(status) - 128);
}

}  // namespace

// Memory that this process and a helper both see, for the positions of the frames that it has: for each rope
// the number of its masses, then their coordinates.
class Helpers::Slots {
  public:
    explicit Slots(std::size_t slot_size)
        : slot_size_(slot_size), bytes_(std::max<std::size_t>(1, most_frames * slot_size)) {
        void* const memory = ::mmap(nullptr, bytes_, PROT_READ | PROT_WRITE,
                                    MAP_SHARED | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
        if (memory == MAP_FAILED) throw std::bad_alloc();
        memory_ = static_cast<std::byte*>(memory);
    }
    ~Slots() { ::munmap(memory_, bytes_); }
    Slots(const Slots&) = delete;
    Slots& operator=(const Slots&) = delete;

    static std::size_t size_of(const std::vector<Points>& positions) {
        std::size_t size = 0;
        for (const Points& points : positions)
            size += sizeof(Eigen::Index) + coordinates(points).size_bytes();
        return size;
    }

    bool fit(const std::vector<Points>& positions) const { return size_of(positions) <= slot_size_; }

    void put(std::size_t slot, const std::vector<Points>& positions) {
        std::byte* to = memory_ + slot * slot_size_;
        for (const Points& points : positions) {
            const Eigen::Index masses = points.rows();
            to = std::ranges::copy(std::as_bytes(std::span(&masses, 1)), to).out;
            to = std::ranges::copy(std::as_bytes(coordinates(points)), to).out;
        }
    }

    std::vector<Points> positions(std::size_t slot, std::size_t ropes) const {
        const std::byte* from = memory_ + slot * slot_size_;
        const auto take = [&from](std::span<std::byte> bytes) {
            std::copy_n(from, bytes.size(), bytes.begin());
            from += bytes.size();
        };
        std::vector<Points> positions(ropes);
        for (Points& points : positions) {
            Eigen::Index masses = 0;
            take(std::as_writable_bytes(std::span(&masses, 1)));
            points.resize(masses, 2);
            take(std::as_writable_bytes(std::span(points.data(), static_cast<std::size_t>(points.size()))));
        }
        return positions;
    }

  private:
    static std::span<const double> coordinates(const Points& points) {
        return {points.data(), static_cast<std::size_t>(points.size())};
    }

    std::size_t slot_size_;
    std::size_t bytes_;
    std::byte* memory_;
};

void Helpers::draw_what_comes(int socket, const Slots& slots, const DrawFrame& draw) {
    Task task;
    while (read_all(socket, std::as_writable_bytes(std::span(&task, 1)))) {
        Interrupts::check();
        draw(task.frame, slots.positions(task.slot, task.ropes));
        if (!send_all(socket, std::as_bytes(std::span(&drawn_mark, 1)))) return;
    }
}

// The whole life of a helper.
void Helpers::help(int socket, const Slots& slots, const DrawFrame& draw) noexcept {
    own_socket = socket;
    std::set_terminate(end_where_none_may_pass);
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // nobody works on when the parent was killed
    try {
        draw_what_comes(socket, slots, draw);
    } catch (const Interrupted& interrupted) {
        ::_exit(128 + interrupted.signal);
    } catch (const std::bad_alloc&) {
        end_with(want_of_memory);
    } catch (const std::exception& error) {
        end_with(one_line(error.what()));
    }
    ::_exit(0);
}

Helpers::Helpers(int count, const std::vector<Points>& positions, DrawFrame draw) : draw_(std::move(draw)) {
    std::fflush(nullptr);
    try {
        for (int i = 0; i < count; ++i) start(Slots::size_of(positions));
    } catch (...) {
        end_all();
        throw;
    }
}

Helpers::~Helpers() {
    end_all();
}

void Helpers::start(std::size_t slot_size) {
    auto slots = std::make_unique<Slots>(slot_size);
    std::array<int, 2> ends;
    if (::socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0) throw_cannot_start(errno);
    const pid_t process = ::fork();
    if (process == 0) {
        for (Helper& other : helpers_) {
            ::close(other.socket);
            other.slots.reset();
        }
        ::close(ends[0]);
        help(ends[1], *slots, draw_);
    }
    const int error = errno;
    ::close(ends[1]);
    if (process < 0) {
        ::close(ends[0]);
        throw_cannot_start(error);
    }
    helpers_.push_back({process, ends[0], std::move(slots), {}});
}

bool Helpers::take(long frame, const std::vector<Points>& positions, int most) {
    receive_marks(false);
    const std::span<Helper> asked(helpers_.data(), static_cast<std::size_t>(std::min(most, count())));
    const auto idlest =
        std::ranges::min_element(asked, {}, [](const Helper& helper) { return helper.undrawn.size(); });
    if (idlest == asked.end() || idlest->undrawn.size() == most_frames) return false;
    if (!idlest->slots->fit(positions)) return false;
    const std::size_t slot = idlest->undrawn.empty() ? 0 : (idlest->undrawn.back().slot + 1) % most_frames;
    const Task task{frame, positions.size(), slot};
    idlest->slots->put(slot, positions);
    if (!send_all(idlest->socket, std::as_bytes(std::span(&task, 1)))) {
        bury(static_cast<std::size_t>(idlest - asked.begin()), "");
        return false;
    }
    idlest->undrawn.push_back(task);
    return true;
}

long Helpers::drawn() {
    return std::exchange(drawn_, 0);
}

void Helpers::finish() {
    while (std::ranges::any_of(helpers_, [](const Helper& helper) { return !helper.undrawn.empty(); }))
        receive_marks(true);
}

// Those that are there; with `wait`, at least one.
void Helpers::receive_marks(bool wait) {
    std::vector<pollfd> sockets;
    for (const Helper& helper : helpers_) sockets.push_back({helper.socket, POLLIN, 0});
    while (::poll(sockets.data(), sockets.size(), wait ? -1 : 0) < 0) {
        if (errno != EINTR)
            throw std::runtime_error("cannot wait for a job: " + std::generic_category().message(errno));
        Interrupts::check();
    }
    for (std::size_t i = sockets.size(); i-- > 0;) {  // from the last, as those that died go
        if (sockets[i].revents == 0) continue;
        const std::string words = received(sockets[i].fd);
        const auto marks = static_cast<long>(std::min(words.find_first_not_of(drawn_mark), words.size()));
        std::deque<Task>& undrawn = helpers_[i].undrawn;
        undrawn.erase(undrawn.begin(), undrawn.begin() + marks);
        drawn_ += marks;
        if (marks == 0 || !words.ends_with(drawn_mark)) bury(i, words);
    }
}

// Draws what a helper left that was killed; one that failed would fail again. The words are what it has sent
// at last, as far as that has been received.
void Helpers::bury(std::size_t helper, std::string words) {
    const Helper dead = std::move(helpers_[helper]);
    helpers_.erase(helpers_.begin() + static_cast<std::ptrdiff_t>(helper));
    const std::string failure = last_words(dead.socket, std::move(words));
    ::close(dead.socket);
    const int status = status_of(dead.process);
    Interrupts::check();
    if (!failure.empty()) throw std::runtime_error(failure);
    if (signal_of(status) == 0) throw std::runtime_error("a job ended before its work was done");
    any_died_ = true;
    std::fprintf(stderr, "ropesim: a job was ended by signal %d (%s); its frames are drawn again\n",
                 signal_of(status),
                 ::strsignal(signal_of(status)));  // NOLINT(concurrency-mt-unsafe): nothing else asks
    for (const Task& task : dead.undrawn) {
        draw_(task.frame, dead.slots->positions(task.slot, task.ropes));
        ++drawn_;
    }
}

// After the frame they are at.
void Helpers::end_all() {
    for (const Helper& helper : helpers_) {
        ::close(helper.socket);
        ::kill(helper.process, SIGTERM);
    }
    for (const Helper& helper : helpers_) status_of(helper.process);
    helpers_.clear();
}

}  // namespace ropesim
