#pragma once

#include <functional>

namespace ropesim {

// Does `work(job, report)` for job 0 ... jobs - 1, each in a process of its own; every call of `report`
// there is a call of `frame_done` here. Throws Interrupted where a signal arrives (the processes end after
// the frame they are at), std::runtime_error where one of them fails; it has said why on stderr.
void in_processes(int jobs, const std::function<void(int job, const std::function<void()>& report)>& work,
                  const std::function<void()>& frame_done);

}  // namespace ropesim
