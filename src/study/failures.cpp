#include "study/failures.h"

#include <algorithm>
#include <cmath>

namespace ropesim {
namespace {

struct Attempt {
    long steps = 0;
    Trajectory trajectory;
    MethodError error;

    bool holds() const { return quality(error.worst) <= Quality::usable; }
};

Attempt attempt(const Problem& problem, const Truth& truth, const Method& method, long steps) {
    Attempt result{steps, simulate(problem, method, steps), {}};
    result.error = method_error(problem, truth, result.trajectory.frames);
    return result;
}

struct Brink {
    std::optional<Attempt> holds;
    std::optional<Attempt> fails;
};

Brink brink(const Problem& problem, const Truth& truth, const Method& method) {
    Brink found;
    const std::vector<long> steps = ladder_of_steps();
    for (auto each = steps.rbegin(); each != steps.rend() && !found.fails; ++each) {
        Attempt run = attempt(problem, truth, method, *each);
        (run.holds() ? found.holds : found.fails) = std::move(run);
    }
    while (found.holds && found.fails && found.holds->steps > found.fails->steps + 1) {
        Attempt run = attempt(problem, truth, method, (found.holds->steps + found.fails->steps) / 2);
        (run.holds() ? found.holds : found.fails) = std::move(run);
    }
    return found;
}

std::vector<long> thirds(long last) {
    return {last / 3, 2 * last / 3, last};
}

long last_frame(const Attempt& run) {
    return static_cast<long>(run.error.of_frame.size()) - 1;
}

std::vector<long> moments_of_failing(const Attempt& run) {
    const std::vector<double>& errors = run.error.of_frame;
    const long last = last_frame(run);
    const auto too_far = std::find_if(errors.begin(), errors.end(),
                                      [](double error) { return quality(error) > Quality::usable; });
    const long failing = too_far - errors.begin();
    return failing < last ? std::vector<long>{failing / 2, failing, last} : thirds(last);
}

Showing showing(const Attempt& run, const std::vector<long>& frames) {
    Showing shown{run.steps, run.error.worst, run.trajectory.diverged, {}};
    for (const long frame : frames) {
        const auto at = static_cast<std::size_t>(frame);
        shown.moments.push_back({frame, run.error.of_frame[at], run.trajectory.frames[at]});
    }
    return shown;
}

}  // namespace

std::vector<Failure> failures(const Problem& problem, const Truth& truth,
                              const std::vector<const Method*>& methods, const MapReport& report) {
    std::vector<Failure> all;
    for (const Method* method : methods) {
        report(static_cast<long>(all.size()), static_cast<long>(methods.size()));
        const Brink found = brink(problem, truth, *method);
        Failure failure{method, std::nullopt, std::nullopt};
        if (found.holds) failure.holds = showing(*found.holds, thirds(last_frame(*found.holds)));
        if (found.fails) failure.fails = showing(*found.fails, moments_of_failing(*found.fails));
        all.push_back(std::move(failure));
    }
    return all;
}

}  // namespace ropesim
