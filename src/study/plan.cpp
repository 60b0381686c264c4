#include "study/plan.h"

#include "simulation/diagnostics.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <stdexcept>

namespace ropesim {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// What a method's evaluations, solves and sweeps take, in evaluations by symplectic Euler: medians at 1024
// masses with AVX-512. Without it evaluations take up to twice as long and solves as they did.
struct MethodWork {
    std::string_view method;
    double evaluation;
    double solve;
};
constexpr std::array<MethodWork, 6> method_works{{{"blanes_moan_6", 1.3, 0.0},  // sums are compensated
                                                  {"backward_euler", 1.0, 85.0},
                                                  {"implicit_midpoint", 1.0, 85.0},
                                                  {"xpbd", 1.0, 42.0},
                                                  {"constraint_projection", 1.0, 29.0},
                                                  {"direct_projection", 1.0, 18.0}}};

MethodWork method_work(const Method& method) {
    const auto found = std::find_if(method_works.begin(), method_works.end(),
                                    [&](const MethodWork& each) { return each.method == method.name; });
    return found == method_works.end() ? MethodWork{method.name, 1.0, 0.0} : *found;
}

// Of one solve or sweep; 0 for a method that has none. What an evaluation waits for takes as long as some
// more masses would; a solve goes from mass to mass anyway.
double solve_work(const Rope& rope, const Method& method) {
    constexpr double waiting = 20.0;  // masses
    const auto masses = static_cast<double>(rope.mass.size());
    return method_work(method).solve * masses / (masses + waiting);
}

// A trial with more work than this, over the clip, in evaluations of one mass, is not made: a tenth of a
// second. A long clip of a long rope may have a trial of some evaluations per frame.
constexpr double most_work = 2e7;
constexpr double most_evaluations = 500.0;

// Steps are known to this share.
constexpr double close_enough = 1.1;

// Trials of one method, from which the next follows.
struct Search {
    const Method* method = nullptr;
    std::vector<Candidate> failed{};      // steps grow
    std::optional<Candidate> passed{};    // fewest steps that keep to the tolerance
    std::optional<Candidate> cheapest{};  // that keeps to it
    bool finer_is_dearer = false;         // than the cheapest: always so, but where steps are solved for
    bool given_up = false;
};

// What an error that falls at the method's order lets expect of the next trial, a little more than enough.
long expected_steps(const Search& search, double tolerance) {
    const Candidate& last = search.failed.back();
    if (!std::isfinite(last.error)) return 2 * last.steps;
    const double growth = 1.02 * std::pow(last.error / tolerance, 1.0 / search.method->order);
    const double steps = std::ceil(std::min(growth, 8.0) * static_cast<double>(last.steps));
    return std::max(last.steps + 1, static_cast<long>(steps));
}

// Whether the fewest steps are known.
bool bracketed(const Search& search) {
    if (!search.passed) return false;
    if (search.failed.empty()) return true;
    const long failed = search.failed.back().steps;
    return search.passed->steps <= failed + 1 ||
           static_cast<double>(search.passed->steps) <= close_enough * static_cast<double>(failed);
}

bool closed(const Search& search) {
    return bracketed(search) && search.finer_is_dearer;
}

long coarsest_steps(const Problem& problem, const Method& method) {
    return fewest_stable_steps(problem.rope, method, problem.frame_time, 0.0).value_or(0);
}

// Of the next trial; 0 where there is none.
long next_steps(const Search& search, const Problem& problem, double tolerance) {
    if (search.given_up || closed(search)) return 0;
    if (search.failed.empty() && !search.passed) return coarsest_steps(problem, *search.method);
    if (!search.passed) return expected_steps(search, tolerance);
    if (bracketed(search)) return search.cheapest->steps + (search.cheapest->steps + 1) / 2;
    const double failed = static_cast<double>(search.failed.back().steps);
    const double middle = std::sqrt(failed * static_cast<double>(search.passed->steps));
    return std::clamp(std::lround(middle), search.failed.back().steps + 1, search.passed->steps - 1);
}

// What a finer step can take at least. Where it is solved for, a large step takes more than a small one: that
// is one solve then.
double work_per_step(const Search& search, const Problem& problem) {
    const double solve = solve_work(problem.rope, *search.method);
    return solve > 0.0 ? solve : search.failed.back().work / static_cast<double>(search.failed.back().steps);
}

// The least work that the method can still turn out to need; infinite where it has been given up.
double least_work(const Search& search, const Problem& problem, double tolerance) {
    if (bracketed(search)) return search.cheapest->work;
    const long next = next_steps(search, problem, tolerance);
    if (next == 0) return infinity;
    if (search.failed.empty()) return static_cast<double>(next);  // at least an evaluation a step
    const long least = search.passed ? search.failed.back().steps + 1 : next;
    return work_per_step(search, problem) * static_cast<double>(least);
}

// The error has stopped falling: the model's, or that of rounding.
bool at_floor(const Search& search) {
    const std::vector<Candidate>& failed = search.failed;
    if (failed.size() < 3 || !std::isfinite(failed.back().error)) return false;
    const Candidate& before = failed[failed.size() - 3];
    return 3 * failed.back().steps >= 4 * before.steps && failed.back().error > 0.8 * before.error;
}

class Planner {
  public:
    Planner(const Problem& problem, double tolerance) : problem_(problem) {
        plan_.tolerance = tolerance;
        plan_.truth = truth(problem);
    }

    Plan search() {
        for (const Method& method : methods())
            if (takes_part(method))
                searches_.push_back({.method = &method, .given_up = coarsest_steps(problem_, method) == 0});
        while (Search* search = most_promising()) try_next(*search);
        for (const Search* search : ranked()) {
            if (!closed(*search)) break;
            if (plan_.choice && plan_.runner_up) break;
            (plan_.choice ? plan_.runner_up : plan_.choice) = search->cheapest;
        }
        if (!plan_.tried.empty()) plan_.growth = growth();
        return std::move(plan_);
    }

  private:
    bool takes_part(const Method& method) const {
        return !method.name.starts_with("seed_") && fits(problem_, method);
    }

    std::vector<Search*> ranked() {
        std::vector<Search*> order;
        for (Search& search : searches_) order.push_back(&search);
        std::stable_sort(order.begin(), order.end(), [&](const Search* a, const Search* b) {
            return least_work(*a, problem_, plan_.tolerance) < least_work(*b, problem_, plan_.tolerance);
        });
        return order;
    }

    // The first of the two cheapest that is still open; null where both are closed or nothing is left.
    Search* most_promising() {
        const std::vector<Search*> order = ranked();
        for (std::size_t i = 0; i < std::min<std::size_t>(2, order.size()); ++i)
            if (next_steps(*order[i], problem_, plan_.tolerance) > 0) return order[i];
        return nullptr;
    }

    void try_next(Search& search) {
        const long steps = next_steps(search, problem_, plan_.tolerance);
        if (too_much(search, steps)) {
            search.given_up = true;
            return;
        }
        const Candidate trial = candidate(problem_, plan_.truth, *search.method, steps);
        plan_.tried.push_back(trial);
        if (trial.error <= plan_.tolerance) {
            if (!search.passed || trial.steps < search.passed->steps) search.passed = trial;
            const bool cheaper = !search.cheapest || trial.work < search.cheapest->work;
            search.finer_is_dearer = method_work(*search.method).solve == 0.0 || !cheaper;
            if (cheaper) search.cheapest = trial;
            return;
        }
        if (search.passed && trial.steps > search.passed->steps) {
            search.finer_is_dearer = true;
            return;
        }
        search.failed.push_back(trial);
        search.given_up = !search.passed && at_floor(search);
    }

    bool too_much(const Search& search, long steps) const {
        const double evaluations =
            static_cast<double>(steps) * (search.failed.empty() ? 1.0 : work_per_step(search, problem_));
        const auto size = static_cast<double>(problem_.rope.mass.size() * problem_.frames);
        return evaluations > std::max(most_evaluations, most_work / size);
    }

    // By the choice, or what came nearest to the tolerance: two runs whose ends are a little apart.
    double growth() const {
        const auto by_error = [](const Candidate& a, const Candidate& b) { return a.error < b.error; };
        const Candidate best =
            plan_.choice.value_or(*std::min_element(plan_.tried.begin(), plan_.tried.end(), by_error));
        constexpr double disturbance = 1e-9;  // pixels
        Problem disturbed = problem_;
        const Eigen::Index free = free_mass();
        if (free < 0) return 1.0;
        disturbed.rope.start(free, 0) += disturbance / problem_.pixels_per_unit;
        const auto moved = simulate(disturbed, *best.method, best.steps).frames;
        const auto unmoved = simulate(problem_, *best.method, best.steps).frames;
        const std::size_t last = std::min(moved.size(), unmoved.size()) - 1;
        return greatest_distance(unmoved[last], moved[last]) * problem_.pixels_per_unit / disturbance;
    }

    // The last that is not pinned; -1 where all are.
    Eigen::Index free_mass() const {
        Eigen::Index mass = problem_.rope.inverse_mass.size() - 1;
        while (mass >= 0 && problem_.rope.inverse_mass(mass) == 0.0) --mass;
        return mass;
    }

    const Problem& problem_;
    Plan plan_;
    std::vector<Search> searches_;
};

std::string px(double pixels) {
    std::array<char, 32> text;
    std::snprintf(text.data(), text.size(), "%.3g px", pixels);
    return text.data();
}

}  // namespace

double work(const Rope& rope, const Method& method, const Cost& cost) {
    return method_work(method).evaluation * static_cast<double>(cost.evaluations) +
           solve_work(rope, method) * static_cast<double>(cost.solves);
}

Candidate candidate(const Problem& problem, const Truth& truth, const Method& method, long steps) {
    const Trajectory trajectory = simulate(problem, method, steps);
    const auto frames = static_cast<double>(std::max<std::size_t>(1, trajectory.frames.size() - 1));
    return {&method, steps, method_error(problem, truth, trajectory.frames).worst,
            work(problem.rope, method, trajectory.cost) / frames};
}

Plan plan(const Problem& problem, double tolerance) {
    return Planner(problem, tolerance).search();
}

std::vector<Candidate> efficient(const Plan& plan) {
    std::vector<Candidate> sorted = plan.tried;
    std::stable_sort(sorted.begin(), sorted.end(),
                     [](const Candidate& a, const Candidate& b) { return a.work < b.work; });
    std::vector<Candidate> result;
    for (const Candidate& each : sorted)
        if (std::isfinite(each.error) && (result.empty() || each.error < result.back().error))
            result.push_back(each);
    return result;
}

SceneRope planned_rope(const SceneRope& rope, const Problem& problem, const Candidate& choice) {
    SceneRope planned = rope;
    planned.method = choice.method->name;
    planned.steps_per_frame = static_cast<int>(choice.steps);
    planned.damping = problem.rope.damping;
    planned.damping_factor = 0.0;
    return planned;
}

Scene with_planned_ropes(const Scene& scene) {
    Scene planned = scene;
    for (SceneRope& rope : planned.ropes) {
        if (rope.method != auto_method) continue;
        constexpr double half_a_pixel = 0.5;
        const Problem its_problem = problem(scene, rope);
        const Plan found = plan(its_problem, scene.tolerance.value_or(half_a_pixel));
        if (!found.choice)
            throw std::runtime_error("rope '" + rope.name + "': no method keeps to " + px(found.tolerance) +
                                     " over " + std::to_string(scene.frames) +
                                     " frames; 'ropesim plan' says what can be kept");
        rope = planned_rope(rope, its_problem, *found.choice);
    }
    return planned;
}

}  // namespace ropesim
