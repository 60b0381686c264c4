#include "study/work_precision.h"

#include "simulation/diagnostics.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <stdexcept>

namespace ropesim {
namespace {

constexpr long most_steps_of_ladder = 1 << 20;

// Work is counted in accelerations of one mass; a solve or a sweep is worth about eight of them. A run of
// the ladder above this is left out: about a tenth of a second here.
constexpr double most_work = 4e7;
constexpr double solve_work = 8.0;

double work(const Problem& problem, const Cost& cost) {
    return (static_cast<double>(cost.evaluations) + solve_work * static_cast<double>(cost.solves)) *
           static_cast<double>(problem.rope.mass.size());
}

// 1, 2, 3, 4, 6, 8, 12, ... steps per frame.
std::vector<double> ladder_of_steps() {
    std::vector<double> steps{1.0};
    for (long power = 2; power <= most_steps_of_ladder; power *= 2) {
        steps.push_back(static_cast<double>(power));
        steps.push_back(1.5 * static_cast<double>(power));
    }
    return steps;
}

// 0.1, 0.03, 0.01, ... 1e-14, as literals: a power may be rounded differently elsewhere.
std::vector<double> ladder_of_tolerances() {
    return {1e-1, 3e-2, 1e-2, 3e-3,  1e-3,  3e-4,  1e-4,  3e-5,  1e-5,  3e-6,  1e-6,  3e-7,  1e-7, 3e-8,
            1e-8, 3e-9, 1e-9, 3e-10, 1e-10, 3e-11, 1e-11, 3e-12, 1e-12, 3e-13, 1e-13, 3e-14, 1e-14};
}

bool sensible(const Problem& problem, const Points& position, long frame) {
    return position.isFinite().all() &&
           longest_link(position) <=
               sensible_length(problem.rope, static_cast<double>(frame) * problem.frame_time);
}

struct Attempt {
    Measurement measurement;
    double seconds = 0.0;
};

Attempt attempt(const Contender& contender, const Problem& problem, const Truth& truth, double setting) {
    const std::unique_ptr<Solver> solver = contender.make(problem, setting);
    const double start = processor_seconds();
    std::vector<Points> frames{solver->position()};
    for (long frame = 1; frame < problem.frames; ++frame) {
        if (!solver->advance()) break;
        if (!sensible(problem, solver->position(), frame)) break;
        frames.push_back(solver->position());
    }
    Attempt attempt;
    attempt.seconds = processor_seconds() - start;
    Measurement& result = attempt.measurement;
    const MethodError error = method_error(problem, truth, frames);
    result.setting = setting;
    result.frames = static_cast<long>(frames.size());
    result.worst = error.worst;
    result.last = error.last;
    result.cost = solver->cost();
    if (contender.setting == Setting::steps_per_frame)
        result.h_omega = problem.frame_time / setting * greatest_frequency(problem.rope);
    if (contender.method)
        result.stable =
            stable(problem.rope, *contender.method, stepping(problem, static_cast<long>(setting)));
    return attempt;
}

// The model's own error: over the last runs the error did not change any more.
bool at_floor_of_model(const std::vector<Measurement>& runs) {
    constexpr std::size_t unchanged_runs = 5;
    constexpr double unchanged = 0.01;
    if (runs.size() <= unchanged_runs) return false;
    const double last = runs.back().worst;
    return std::isfinite(last) && std::all_of(runs.end() - unchanged_runs, runs.end(), [&](const auto& run) {
               return std::abs(run.worst - last) < unchanged * last;
           });
}

// Rounding's error: far below any tolerance, and the last runs were no better than those before.
bool at_floor_of_rounding(const std::vector<Measurement>& runs) {
    constexpr std::size_t runs_without_gain = 3;
    constexpr double far_below = 1e-5;  // pixels
    if (runs.size() <= runs_without_gain) return false;
    const auto worse = [](const auto& a, const auto& b) { return a.worst < b.worst; };
    const auto split = runs.end() - runs_without_gain;
    const double before = std::min_element(runs.begin(), split, worse)->worst;
    return before < far_below && std::min_element(split, runs.end(), worse)->worst > 0.8 * before;
}

struct CurveAndSeconds {
    Curve curve;
    std::vector<double> seconds;
};

CurveAndSeconds attempts(const Contender& contender, const Problem& problem, const Truth& truth) {
    CurveAndSeconds result{{contender, {}}, {}};
    std::vector<Measurement>& runs = result.curve.measurements;
    const bool fixed = contender.setting == Setting::steps_per_frame;
    for (const double setting : fixed ? ladder_of_steps() : ladder_of_tolerances()) {
        if (!runs.empty()) {
            const double growth = fixed ? setting / runs.back().setting : 1.0;
            if (growth * work(problem, runs.back().cost) > most_work) break;
        }
        const Attempt run = attempt(contender, problem, truth, setting);
        runs.push_back(run.measurement);
        result.seconds.push_back(run.seconds);
        if (at_floor_of_rounding(runs) || (fixed && at_floor_of_model(runs))) break;
    }
    return result;
}

// What is timed: the frames that the run attempted, and nothing else.
std::function<void()> task(const Contender& contender, const Problem& problem, const Measurement& run) {
    const std::shared_ptr<Solver> solver = contender.make(problem, run.setting);
    const long frames = std::min(run.frames, problem.frames - 1);
    return [solver, frames] {
        solver->restart();
        for (long frame = 0; frame < frames; ++frame) solver->advance();
    };
}

std::string obstacle(const Problem& problem, const Contender& contender) {
    const Model model = contender.method ? contender.method->model : Model::elastic;
    std::string of_model = obstacle(problem, model);
    if (!of_model.empty() || contender.damps || problem.rope.damping == 0.0) return of_model;
    return "follows no damping, and this rope has some";
}

double frames_of(const Problem& problem, const Measurement& run) {
    return static_cast<double>(std::max(1L, std::min(run.frames, problem.frames - 1)));
}

}  // namespace

std::vector<Contender> contenders(const Problem& problem, const std::vector<std::string>& names) {
    std::vector<Contender> all;
    for (const Method& method : methods()) all.push_back(contender(method));
    for (Contender& each : odeint_contenders()) all.push_back(std::move(each));
    for (Contender& each : sundials_contenders()) all.push_back(std::move(each));
    std::vector<Contender> wanted;
    std::string known;
    for (const Contender& each : all) {
        known += (known.empty() ? "" : ", ") + label(each);
        const bool named = std::ranges::count(names, label(each)) > 0;
        if (!named && !names.empty()) continue;
        const std::string why_not = obstacle(problem, each);
        if (why_not.empty())
            wanted.push_back(each);
        else if (named)
            throw std::runtime_error(label(each) + " " + why_not);
    }
    for (const std::string& name : names)
        if (std::ranges::none_of(wanted, [&](const auto& each) { return label(each) == name; }))
            throw std::runtime_error("unknown method '" + name + "'; expected one of: " + known);
    return wanted;
}

Curve errors_of(const Contender& contender, const Problem& problem, const Truth& truth) {
    return attempts(contender, problem, truth).curve;
}

WorkPrecision work_precision(const Problem& problem, const std::vector<Contender>& contenders,
                             const Report& report) {
    report("reference", 0, 0);
    WorkPrecision study{problem, truth(problem), {}};
    std::vector<std::function<void()>> tasks;
    std::vector<double> seconds;
    for (std::size_t i = 0; i < contenders.size(); ++i) {
        report(label(contenders[i]), static_cast<long>(i), static_cast<long>(contenders.size()));
        CurveAndSeconds found = attempts(contenders[i], study.problem, study.truth);
        for (const Measurement& run : found.curve.measurements)
            tasks.push_back(task(contenders[i], study.problem, run));
        seconds.insert(seconds.end(), found.seconds.begin(), found.seconds.end());
        study.curves.push_back(std::move(found.curve));
    }
    long done = 0;
    const long all = turns(seconds);
    const std::vector<Times> times = times_of(tasks, seconds, [&] { report("times", ++done, all); });
    auto time = times.begin();
    for (Curve& curve : study.curves) {
        for (Measurement& run : curve.measurements) {
            const double frames = frames_of(study.problem, run);
            run.time = *time++;
            run.time.lower /= frames;
            run.time.median /= frames;
            run.time.upper /= frames;
        }
    }
    return study;
}

Cheapest cheapest(const WorkPrecision& study, bool ours, double pixels) {
    Cheapest best;
    for (const Curve& curve : study.curves) {
        if (curve.contender.library.empty() != ours) continue;
        for (auto run = curve.measurements.rbegin(); run != curve.measurements.rend(); ++run) {
            if (!(run->worst <= pixels)) break;
            if (!best.measurement || run->time.median < best.measurement->time.median) best = {&curve, &*run};
        }
    }
    return best;
}

}  // namespace ropesim
