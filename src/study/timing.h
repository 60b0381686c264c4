#pragma once

#include <functional>
#include <vector>

namespace ropesim {

// Seconds that the processor has spent on this thread.
double processor_seconds();

// Of repeated measurements, seconds of the processor: time in which it did other work does not count.
struct Times {
    double lower = 0.0;  // quartile
    double median = 0.0;
    double upper = 0.0;  // quartile
    int repetitions = 0;
};

// The quartiles of measurements, by linear interpolation between them.
Times quartiles(std::vector<double> seconds);

// How long each task takes. All take turns, so that whatever slows the machine for a while slows all alike.
// In a turn a task is repeated for as long as the clock needs. `estimates` are how long each took when it was
// run once, seconds; for a slow task that counts as a turn, and it has one other. `turn_done` is called
// after each turn of each task; turns(estimates) is how many there are.
std::vector<Times> times_of(const std::vector<std::function<void()>>& tasks,
                            const std::vector<double>& estimates, const std::function<void()>& turn_done);
long turns(const std::vector<double>& estimates);

// The same where nothing is known of the tasks: each is run once before, which tells how long it takes.
std::vector<Times> times_of(const std::vector<std::function<void()>>& tasks);

}  // namespace ropesim
