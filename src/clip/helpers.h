#pragma once

#include "simulation/rope.h"

#include <sys/types.h>

#include <cstddef>
#include <deque>
#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ropesim {

// Draws (and keeps) the picture of a frame with its ropes at these positions.
using DrawFrame = std::function<void(long frame, const std::vector<Points>& positions)>;

// Processes that draw frames for this one. Make them before this process has an OpenGL context: what they
// need they make for themselves, at their first frame. What a helper leaves undrawn that is killed, this
// process draws, and says so on stderr; the others go on.
class Helpers {
  public:
    // For frames with no more masses than there are in these positions. Throws std::runtime_error where a
    // process cannot be started.
    Helpers(int count, const std::vector<Points>& positions, DrawFrame draw);
    ~Helpers();  // ends those that are still at work, after the frame they are at
    Helpers(const Helpers&) = delete;
    Helpers& operator=(const Helpers&) = delete;

    int count() const { return static_cast<int>(helpers_.size()); }

    // Whether one was killed.
    bool any_died() const { return any_died_; }

    // Has the frame drawn by the one of the first `most` helpers that has the least to do; false where all
    // have enough to do, or there are more masses than they were made for. Throws std::runtime_error where a
    // helper has failed, with what it says.
    bool take(long frame, const std::vector<Points>& positions, int most);

    // How many frames were drawn since this was last asked.
    long drawn();

    // Waits until all is drawn. Throws as `take` does, and Interrupted.
    void finish();

  private:
    // A frame that a helper has, of so many ropes. Their positions are in memory that both see: they need
    // not fit into a socket, so that nobody waits for one that draws.
    struct Task {
        long frame = 0;
        std::size_t ropes = 0;
        std::size_t slot = 0;
    };
    class Slots;
    struct Helper {
        pid_t process;
        int socket;  // tasks go there; what is drawn, or why not, comes back
        std::unique_ptr<Slots> slots;
        std::deque<Task> undrawn;
    };

    [[noreturn]] static void help(int socket, const Slots& slots, const DrawFrame& draw) noexcept;
    static void draw_what_comes(int socket, const Slots& slots, const DrawFrame& draw);
    void start(std::size_t slot_size);
    void receive_marks(bool wait);
    void bury(std::size_t helper, std::string words);
    void end_all();

    DrawFrame draw_;
    std::vector<Helper> helpers_;
    long drawn_ = 0;
    bool any_died_ = false;
};

}  // namespace ropesim
