#include "commands/program.h"

#include "clip/file.h"
#include "clip/temporary_folder.h"

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

namespace ropesim {
namespace {

pid_t start(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
            const std::string& out, const std::string& err, rlim_t addresses = RLIM_INFINITY) {
    const pid_t process = ::fork();
    if (process != 0) return process;
    std::vector<char*> values{const_cast<char*>("ropesim")};
    for (const std::string& argument : arguments) values.push_back(const_cast<char*>(argument.c_str()));
    values.push_back(nullptr);
    ::dup2(::open("/dev/null", O_RDONLY), STDIN_FILENO);
    ::dup2(::open(out.c_str(), O_WRONLY | O_CREAT, 0600), STDOUT_FILENO);
    ::dup2(::open(err.c_str(), O_WRONLY | O_CREAT, 0600), STDERR_FILENO);
    const rlimit limit{addresses, addresses};
    if (addresses != RLIM_INFINITY) ::setrlimit(RLIMIT_AS, &limit);
    if (::chdir(folder.c_str()) == 0) ::execv(ROPESIM_PROGRAM, values.data());
    ::_exit(127);
}

std::string text_of(const std::filesystem::path& path) {
    const auto bytes = read_file(path);
    return {bytes.begin(), bytes.end()};
}

}  // namespace

Outcome ropesim(const std::filesystem::path& folder, const std::vector<std::string>& arguments,
                rlim_t addresses) {
    const TemporaryFolder output;
    const std::string out = output.path() / "out";
    const std::string err = output.path() / "err";
    const int status = wait_for(start(folder, arguments, out, err, addresses));
    return {status, text_of(out), text_of(err)};
}

Outcome ropesim_with_full_output(const std::filesystem::path& folder,
                                 const std::vector<std::string>& arguments) {
    const TemporaryFolder output;
    const std::string err = output.path() / "err";
    const int status = wait_for(start(folder, arguments, "/dev/full", err));
    return {status, "", text_of(err)};
}

pid_t start_ropesim(const std::filesystem::path& folder, const std::vector<std::string>& arguments) {
    return start(folder, arguments, "/dev/null", "/dev/null");
}

int wait_for(pid_t process) {
    int status = 0;
    ::waitpid(process, &status, 0);
    return WIFSIGNALED(status) ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
}

}  // namespace ropesim
