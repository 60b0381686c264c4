#pragma once

#include <chrono>

namespace ropesim {

// One line on a terminal's stderr that updates itself: frames (or points) done, of how many, per second, time
// left.
// Says nothing where stderr is no terminal, or when not wanted.
class Progress {
  public:
    Progress(long count, const char* what, bool wanted);  // what they are: "frames"
    ~Progress();                                          // takes the line away
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void done(long count);
    void kept();  // one need not be done

  private:
    using Clock = std::chrono::steady_clock;
    long count_;
    const char* what_;
    bool shown_;
    long done_ = 0;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_shown_ = start_;
};

}  // namespace ropesim
