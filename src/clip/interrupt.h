#pragma once

#include <csignal>

namespace ropesim {

// SIGINT or SIGTERM arrived while an Interrupts was alive.
struct Interrupted {
    int signal;
};

// From here on SIGINT and SIGTERM end the process with a line on stderr and exit status 128 + signal.
// A write beyond the limit on a file's size (ulimit -f) fails, as one to a full disk does.
void end_at_signals();

// While it lives, SIGINT and SIGTERM are noted instead of ending the process at once.
class Interrupts {
  public:
    Interrupts();
    ~Interrupts();
    Interrupts(const Interrupts&) = delete;
    Interrupts& operator=(const Interrupts&) = delete;

    // Throws Interrupted where one has arrived.
    static void check();

  private:
    struct sigaction old_int_;
    struct sigaction old_term_;
};

}  // namespace ropesim
