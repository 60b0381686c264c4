#include "clip/process.h"

#include <fcntl.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string_view>
#include <system_error>

namespace ropesim {
namespace {

// A pipe whose ends do not leak into other programs.
struct Pipe {
    int read_end = -1;
    int write_end = -1;

    Pipe() {
        std::array<int, 2> ends;
        if (::pipe2(ends.data(), O_CLOEXEC) != 0)
            throw std::runtime_error("cannot make a pipe: " + std::generic_category().message(errno));
        read_end = ends[0];
        write_end = ends[1];
    }
    ~Pipe() {
        close(read_end);
        close(write_end);
    }
    Pipe(const Pipe&) = delete;
    Pipe& operator=(const Pipe&) = delete;

    static void close(int& end) {
        if (end >= 0) ::close(end);
        end = -1;
    }
};

pid_t start(const std::vector<std::string>& command, const std::filesystem::path& folder, int standard_input,
            int standard_output) {
    std::vector<char*> arguments;
    for (const std::string& argument : command) arguments.push_back(const_cast<char*>(argument.c_str()));
    arguments.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    ::posix_spawn_file_actions_init(&actions);
    pid_t process = 0;
    int error = ::posix_spawn_file_actions_adddup2(&actions, standard_input, STDIN_FILENO);
    if (error == 0) error = ::posix_spawn_file_actions_adddup2(&actions, standard_output, STDOUT_FILENO);
    if (error == 0) error = ::posix_spawn_file_actions_addchdir_np(&actions, folder.c_str());
    if (error == 0)
        error = ::posix_spawnp(&process, arguments[0], &actions, nullptr, arguments.data(), environ);
    ::posix_spawn_file_actions_destroy(&actions);
    if (error != 0)
        throw std::runtime_error("cannot run " + command[0] + ": " + std::generic_category().message(error));
    return process;
}

// Writes until all is written or nobody reads any more (the program's exit status then says why).
void write_all(int file, std::string_view bytes) {
    while (!bytes.empty()) {
        const ssize_t written = ::write(file, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) return;
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
}

std::string read_all(int file) {
    std::string text;
    std::array<char, 4096> buffer;
    for (;;) {
        const ssize_t count = ::read(file, buffer.data(), buffer.size());
        if (count < 0 && errno == EINTR) continue;
        if (count <= 0) return text;
        text.append(buffer.data(), static_cast<std::size_t>(count));
    }
}

int wait_for(pid_t process) {
    int status = 0;
    while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
    }
    return status;
}

}  // namespace

bool is_installed(const std::string& program) {
    const char* path = std::getenv("PATH");
    for (std::string_view folders = path ? path : ""; !folders.empty();) {
        const std::string_view folder = folders.substr(0, folders.find(':'));
        if (::access((std::filesystem::path(folder) / program).c_str(), X_OK) == 0) return true;
        folders.remove_prefix(std::min(folder.size() + 1, folders.size()));
    }
    return false;
}

std::string run_program(const std::vector<std::string>& command, const std::filesystem::path& folder,
                        const std::function<void(const std::function<void(std::string_view)>&)>& feed) {
    Pipe input;
    Pipe output;
    const pid_t process = start(command, folder, input.read_end, output.write_end);
    Pipe::close(input.read_end);
    Pipe::close(output.write_end);
    const auto old_action = std::signal(SIGPIPE, SIG_IGN);
    try {
        feed([&](std::string_view bytes) { write_all(input.write_end, bytes); });
    } catch (...) {
        std::signal(SIGPIPE, old_action);
        ::kill(process, SIGKILL);  // lest it takes the end of its input for the end of what was to come
        wait_for(process);
        throw;
    }
    Pipe::close(input.write_end);
    std::signal(SIGPIPE, old_action);
    const std::string text = read_all(output.read_end);
    const int status = wait_for(process);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) throw std::runtime_error(command[0] + " failed");
    return text;
}

std::string run_program(const std::vector<std::string>& command, const std::filesystem::path& folder) {
    return run_program(command, folder, [](const auto&) {});
}

}  // namespace ropesim
