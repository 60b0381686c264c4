#pragma once

#include <chrono>

namespace ropesim {

// One line on a terminal's stderr that updates itself: frames done, of how many, per second, time left.
// Says nothing where stderr is no terminal, or when not wanted.
class Progress {
  public:
    Progress(long frames, bool wanted);
    ~Progress();  // takes the line away
    Progress(const Progress&) = delete;
    Progress& operator=(const Progress&) = delete;

    void frames_done(long frames);
    void frame_kept();  // it need not be done

  private:
    using Clock = std::chrono::steady_clock;
    long frames_;
    bool shown_;
    long done_ = 0;
    Clock::time_point start_ = Clock::now();
    Clock::time_point last_shown_ = start_;
};

}  // namespace ropesim
