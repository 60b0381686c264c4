#include "clip/progress.h"

#include <unistd.h>

#include <cmath>
#include <cstdio>

namespace ropesim {

Progress::Progress(long count, const char* what, bool wanted)
    : count_(count), what_(what), shown_(wanted && ::isatty(STDERR_FILENO) == 1) {}

Progress::~Progress() {
    if (shown_) std::fputs("\r\x1b[K", stderr);
}

void Progress::kept() {
    --count_;
}

void Progress::done(long count) {
    done_ += count;
    const Clock::time_point now = Clock::now();
    if (!shown_ || done_ == 0 || now - last_shown_ < std::chrono::milliseconds(100)) return;
    last_shown_ = now;
    const double seconds = std::chrono::duration<double>(now - start_).count();
    const double rate = static_cast<double>(done_) / seconds;
    const long left = std::lround(static_cast<double>(count_ - done_) / rate);
    std::fprintf(stderr, "\r%ld of %ld %s, %.3g per second, %ld:%02ld left\x1b[K", done_, count_, what_, rate,
                 left / 60, left % 60);
    std::fflush(stderr);
}

}  // namespace ropesim
