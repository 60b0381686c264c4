#include "study/timing.h"

#include <algorithm>
#include <cmath>
#include <ctime>

namespace ropesim {
namespace {

constexpr int rounds = 6;
constexpr int rounds_of_slow = 1;  // after the run that told how long it takes
constexpr double slow = 0.03;      // seconds
constexpr double shortest = 2e-3;  // seconds of a turn: a clock tick and a call are far below a thousandth

bool takes_turn(int round, double estimate) {
    return estimate < slow || round % (rounds / rounds_of_slow) == 1;
}

double seconds_of(const std::function<void()>& task, double estimate) {
    const auto repetitions = std::max(1L, std::lround(shortest / std::max(estimate, 1e-9)));
    const double start = processor_seconds();
    for (long i = 0; i < repetitions; ++i) task();
    return (processor_seconds() - start) / static_cast<double>(repetitions);
}

}  // namespace

double processor_seconds() {
    timespec time{};
    ::clock_gettime(CLOCK_THREAD_CPUTIME_ID, &time);
    return static_cast<double>(time.tv_sec) + 1e-9 * static_cast<double>(time.tv_nsec);
}

Times quartiles(std::vector<double> seconds) {
    if (seconds.empty()) return {};
    std::sort(seconds.begin(), seconds.end());
    const auto at = [&](double share) {
        const double place = share * static_cast<double>(seconds.size() - 1);
        const auto below = static_cast<std::size_t>(place);
        const auto above = std::min(below + 1, seconds.size() - 1);
        return std::lerp(seconds[below], seconds[above], place - static_cast<double>(below));
    };
    return {at(0.25), at(0.5), at(0.75), static_cast<int>(seconds.size())};
}

long turns(const std::vector<double>& estimates) {
    long count = 0;
    for (const double estimate : estimates)
        for (int round = 0; round < rounds; ++round) count += takes_turn(round, estimate) ? 1 : 0;
    return count;
}

std::vector<Times> times_of(const std::vector<std::function<void()>>& tasks,
                            const std::vector<double>& estimates, const std::function<void()>& turn_done) {
    std::vector<std::vector<double>> seconds(tasks.size());
    for (std::size_t task = 0; task < tasks.size(); ++task)
        if (estimates[task] >= slow) seconds[task].push_back(estimates[task]);
    for (int round = 0; round < rounds; ++round) {
        for (std::size_t task = 0; task < tasks.size(); ++task) {
            if (!takes_turn(round, estimates[task])) continue;
            seconds[task].push_back(seconds_of(tasks[task], estimates[task]));
            turn_done();
        }
    }
    std::vector<Times> times;
    for (const std::vector<double>& each : seconds) times.push_back(quartiles(each));
    return times;
}

std::vector<Times> times_of(const std::vector<std::function<void()>>& tasks) {
    std::vector<double> estimates;
    for (const auto& task : tasks) estimates.push_back(seconds_of(task, shortest));
    return times_of(tasks, estimates, [] {});
}

}  // namespace ropesim
