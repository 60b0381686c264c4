#include "clip/interrupt.h"

#include <unistd.h>

#include <string_view>

namespace ropesim {
namespace {

volatile std::sig_atomic_t arrived_signal = 0;

void note(int signal) {
    arrived_signal = signal;
}

void end(int signal) {
    static constexpr std::string_view message = "ropesim: interrupted\n";
    [[maybe_unused]] const ssize_t written = ::write(STDERR_FILENO, message.data(), message.size());
    ::_exit(128 + signal);
}

}  // namespace

void end_at_signals() {
    std::signal(SIGINT, end);
    std::signal(SIGTERM, end);
    std::signal(SIGXFSZ, SIG_IGN);
}

Interrupts::Interrupts() {
    struct sigaction action {};
    action.sa_handler = note;  // without SA_RESTART: a blocking read returns
    ::sigaction(SIGINT, &action, &old_int_);
    ::sigaction(SIGTERM, &action, &old_term_);
}

Interrupts::~Interrupts() {
    ::sigaction(SIGINT, &old_int_, nullptr);
    ::sigaction(SIGTERM, &old_term_, nullptr);
    arrived_signal = 0;
}

void Interrupts::check() {
    if (arrived_signal != 0) throw Interrupted{arrived_signal};
}

}  // namespace ropesim
