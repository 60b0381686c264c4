#include "clip/jobs.h"

#include "clip/interrupt.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <cerrno>
#include <csignal>
#include <cstdio>
#include <cstring>
#include <exception>
#include <stdexcept>
#include <string>
#include <vector>

namespace ropesim {
namespace {

constexpr char done_mark = '.';
constexpr char failed_mark = '!';

void tell(int pipe, char mark) {
    while (::write(pipe, &mark, 1) < 0 && errno == EINTR) {
    }
}

// The whole life of a child process.
[[noreturn]] void run_job(int job, int pipe,
                          const std::function<void(int, const std::function<void()>&)>& work) {
    ::prctl(PR_SET_PDEATHSIG, SIGTERM);  // nobody works on when the parent was killed
    int status = 0;
    try {
        work(job, [pipe] { tell(pipe, done_mark); });
    } catch (const Interrupted& interrupted) {
        status = 128 + interrupted.signal;
    } catch (const std::exception& error) {
        std::fprintf(stderr, "ropesim: %s\n", error.what());
        tell(pipe, failed_mark);
        status = 1;
    }
    std::fflush(nullptr);
    ::_exit(status);
}

void send(const std::vector<pid_t>& processes, int signal) {
    for (const pid_t process : processes) ::kill(process, signal);
}

// Counts frames until every process has closed its end of the pipe.
void gather(int pipe, const std::vector<pid_t>& processes, const std::function<void()>& frame_done) {
    std::array<char, 256> marks;
    for (bool told = false;;) {
        const ssize_t count = ::read(pipe, marks.data(), marks.size());
        if (count == 0) return;
        if (Interrupts::arrived() != 0 && !told) {
            send(processes, Interrupts::arrived());
            told = true;
        }
        for (ssize_t i = 0; i < count; ++i) {
            if (marks[static_cast<std::size_t>(i)] == failed_mark)
                send(processes, SIGTERM);
            else
                frame_done();
        }
    }
}

// Collects the processes; what the first that failed said of itself, or "".
std::string wait_for(const std::vector<pid_t>& processes) {
    std::string failure;
    for (const pid_t process : processes) {
        int status = 0;
        while (::waitpid(process, &status, 0) < 0 && errno == EINTR) {
        }
        if (WIFSIGNALED(status))
            failure = "a job was ended by signal " + std::to_string(WTERMSIG(status)) + " (" +
                      ::strsignal(WTERMSIG(status)) + "); --resume does what it left";
        else if (WEXITSTATUS(status) == 1 && failure.empty())
            failure = "a job failed; --resume does what it left";
    }
    return failure;
}

}  // namespace

void in_processes(int jobs, const std::function<void(int, const std::function<void()>&)>& work,
                  const std::function<void()>& frame_done) {
    std::array<int, 2> ends;
    if (::pipe(ends.data()) != 0)
        throw std::runtime_error(std::string("cannot make a pipe: ") + std::strerror(errno));
    std::fflush(nullptr);
    std::vector<pid_t> processes;
    for (int job = 0; job < jobs; ++job) {
        const pid_t process = ::fork();
        if (process == 0) {
            ::close(ends[0]);
            run_job(job, ends[1], work);
        }
        if (process < 0) {
            const std::string why = std::strerror(errno);
            send(processes, SIGTERM);
            ::close(ends[0]);
            ::close(ends[1]);
            wait_for(processes);
            throw std::runtime_error("cannot start a job: " + why);
        }
        processes.push_back(process);
    }
    ::close(ends[1]);
    gather(ends[0], processes, frame_done);
    ::close(ends[0]);
    const std::string failure = wait_for(processes);
    Interrupts::check();
    if (!failure.empty()) throw std::runtime_error(failure);
}

}  // namespace ropesim
