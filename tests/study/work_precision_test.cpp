#include "study/work_precision.h"

#include "simulation/diagnostics.h"

#include "study/work_precision_csv.h"

#include <gmock/gmock.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <sstream>

namespace ropesim {
namespace {

using testing::HasSubstr;

// A rope of the seed's length and springs, let go from rest.
Problem swinging_rope(const char* method, int masses, int frames) {
    Scene scene;
    scene.frames = frames;
    SceneRope rope;
    rope.method = method;
    rope.nodes = masses;
    rope.end = {-400.0, 0.0};
    scene.ropes.push_back(rope);
    return problem(scene, scene.ropes[0]);
}

Problem small_problem() {
    return swinging_rope("symplectic_euler", 5, 11);
}

Curve curve_of(const char* name, const Problem& problem, const Truth& truth) {
    return errors_of(contenders(problem, {name}).at(0), problem, truth);
}

double finest_error(const Curve& curve) {
    double finest = curve.measurements.front().worst;
    for (const Measurement& run : curve.measurements) finest = std::min(finest, run.worst);
    return finest;
}

// The slope of log(error) over log(step) by least squares, where steps are small and the error is far from
// the picture's size and from rounding.
double observed_order(const Curve& curve) {
    std::vector<std::array<double, 2>> points;
    for (const Measurement& run : curve.measurements)
        if (run.h_omega < 4.0 && run.worst < 0.01 && run.worst > 1e-8)
            points.push_back({-std::log(run.setting), std::log(run.worst)});
    std::array<double, 2> mean{};
    for (const auto& point : points)
        for (std::size_t axis : {0, 1}) mean[axis] += point[axis] / static_cast<double>(points.size());
    double covariance = 0.0, variance = 0.0;
    for (const auto& point : points) {
        covariance += (point[0] - mean[0]) * (point[1] - mean[1]);
        variance += (point[0] - mean[0]) * (point[0] - mean[0]);
    }
    return covariance / variance;
}

TEST(WorkPrecision, HasTheSlopesOfTheTable) {
    const std::vector<std::string> of_springs = {"symplectic_euler",
                                                 "stormer_verlet",
                                                 "runge_kutta_4",
                                                 "blanes_moan_4",
                                                 "blanes_moan_6",
                                                 "odeint:velocity_verlet",
                                                 "odeint:symplectic_rkn_sb3a_mclachlan"};
    for (const auto& names : {of_springs, {"direct_projection"}}) {
        const Problem problem = swinging_rope(names[0].c_str(), 16, 61);
        const Truth true_motion = truth(problem);
        for (const Contender& each : contenders(problem, names))
            EXPECT_NEAR(observed_order(errors_of(each, problem, true_motion)), each.order, 0.15)
                << label(each);
    }
}

TEST(WorkPrecision, LetsEveryAdaptiveSolverCloseToTheTruth) {
    const Problem problem = small_problem();
    const Truth true_motion = truth(problem);
    for (const Contender& each : contenders(problem, {}))
        if (each.setting == Setting::tolerance) {
            EXPECT_LT(finest_error(errors_of(each, problem, true_motion)), 1e-4) << label(each);
        }
}

// Two or more, times the step times the greatest frequency: the method grows without bound; below, it holds.
TEST(WorkPrecision, FailsWhereTheoryPutsIt) {
    const Problem problem = small_problem();
    const Truth true_motion = truth(problem);
    for (const char* name : {"symplectic_euler", "stormer_verlet", "runge_kutta_4", "blanes_moan_4"}) {
        const double limit = find_method(name).stability_limit;
        for (const Measurement& run : curve_of(name, problem, true_motion).measurements) {
            EXPECT_EQ(run.stable, run.h_omega < limit) << name << ' ' << run.setting;
            if (run.h_omega > 0.9 * limit && run.h_omega < 1.5 * limit) continue;
            EXPECT_EQ(run.worst < 1e3, run.stable) << name << ' ' << run.setting;
        }
    }
}

// To the scene's springs, links that do not stretch are wrong by what the springs stretch, at any step.
TEST(WorkPrecision, ShowsTheModelsOwnErrorAsAFloor) {
    const Problem elastic = small_problem();
    const Truth true_motion = truth(elastic);
    const Curve curve = curve_of("direct_projection", elastic, true_motion);
    Problem other = elastic;
    other.model = Model::inextensible;
    const Truth of_model = truth(other);
    double model_error = 0.0;
    for (std::size_t frame = 0; frame < 11; ++frame)
        model_error = std::max(model_error, greatest_distance(true_motion.reference.frames[frame],
                                                              of_model.reference.frames[frame]));
    EXPECT_NEAR(curve.measurements.back().worst, model_error, 0.01 * model_error);
}

TEST(WorkPrecision, HasTheSameErrorsToTheLastBitEachTime) {
    const Problem problem = small_problem();
    const Truth true_motion = truth(problem);
    for (const char* name : {"implicit_midpoint", "blanes_moan_6", "sundials:cvode_bdf"}) {
        const Curve first = curve_of(name, problem, true_motion);
        const Curve second = curve_of(name, problem, truth(problem));
        ASSERT_EQ(first.measurements.size(), second.measurements.size());
        for (std::size_t i = 0; i < first.measurements.size(); ++i) {
            EXPECT_EQ(first.measurements[i].worst, second.measurements[i].worst) << name;
            EXPECT_EQ(first.measurements[i].cost.evaluations, second.measurements[i].cost.evaluations)
                << name;
        }
    }
}

TEST(WorkPrecision, LeavesOutWhatCannotFollowADampedRope) {
    Problem problem = small_problem();
    const std::size_t all = contenders(problem, {}).size();
    problem.rope.damping = 0.1;
    EXPECT_EQ(contenders(problem, {}).size(), all - 3);  // the symplectic steppers of Boost.Odeint
}

TEST(WorkPrecision, RefusesAMethodThatCannotMoveTheRope) {
    const auto refusal = [](const Problem& problem, const char* name) -> std::string {
        try {
            contenders(problem, {"stormer_verlet", name});
            return "";
        } catch (const std::runtime_error& error) {
            return error.what();
        }
    };
    Problem problem = small_problem();
    EXPECT_EQ(refusal(problem, "direct_projection"), "");
    problem.rope.rest_length *= 1.1;
    EXPECT_EQ(refusal(problem, "direct_projection"),
              "direct_projection keeps links at rest length, and this rope's do not start at it");
    problem.rope.damping = 0.1;
    EXPECT_EQ(refusal(problem, "odeint:velocity_verlet"),
              "odeint:velocity_verlet follows no damping, and this rope has some");
    EXPECT_EQ(refusal(swinging_rope("xpbd", 5, 11), "xpbd"), "");
    EXPECT_EQ(refusal(swinging_rope("direct_projection", 5, 11), "direct_projection"),
              "stormer_verlet moves springs, and this rope's links keep their length");
}

TEST(WorkPrecision, RefusesAMethodThatItDoesNotKnow) {
    EXPECT_THAT(
        [] {
            contenders(small_problem(), {"stormer_verlet", "leapfrog"});
        },
        testing::ThrowsMessage<std::runtime_error>(
            AllOf(HasSubstr("unknown method 'leapfrog'"), HasSubstr("odeint:velocity_verlet"))));
}

Measurement measured(double worst, double seconds) {
    Measurement run;
    run.worst = worst;
    run.time.median = seconds;
    return run;
}

// A finer run that is worse shows that the coarser one was lucky.
TEST(Cheapest, IsTheFastestWhoseErrorIsKeptAtEveryFinerSetting) {
    WorkPrecision study;
    study.curves.resize(2);
    study.curves[0].measurements = {measured(5.0, 1.0), measured(0.1, 2.0), measured(0.9, 3.0),
                                    measured(0.05, 4.0)};
    study.curves[1].measurements = {measured(0.5, 3.5)};
    EXPECT_EQ(cheapest(study, true, 1.0).measurement->time.median, 2.0);
    EXPECT_EQ(cheapest(study, true, 0.6).measurement->time.median, 3.5);
    EXPECT_EQ(cheapest(study, true, 0.2).measurement->time.median, 4.0);
    EXPECT_EQ(cheapest(study, true, 0.01).measurement, nullptr);
    EXPECT_EQ(cheapest(study, false, 1.0).measurement, nullptr);
}

TEST(Quartiles, AreInterpolatedBetweenMeasurements) {
    const Times times = quartiles({4.0, 1.0, 3.0, 2.0});
    EXPECT_DOUBLE_EQ(times.lower, 1.75);
    EXPECT_DOUBLE_EQ(times.median, 2.5);
    EXPECT_DOUBLE_EQ(times.upper, 3.25);
    EXPECT_EQ(times.repetitions, 4);
}

TEST(TimesOf, LetsEveryTaskHaveItsTurns) {
    std::vector<int> runs(2, 0);
    long turns_done = 0;
    const std::vector<std::function<void()>> tasks{[&] { ++runs[0]; }, [&] { ++runs[1]; }};
    const std::vector<double> estimates{1.0, 1e-3};
    const std::vector<Times> times = times_of(tasks, estimates, [&] { ++turns_done; });
    EXPECT_EQ(turns_done, turns(estimates));
    EXPECT_EQ(times[0].repetitions, runs[0] + 1);  // slow: once in each of its turns, and before them
    EXPECT_GT(times[1].repetitions, times[0].repetitions);
    EXPECT_GT(runs[1], times[1].repetitions);
}

WorkPrecision small_study() {
    const Problem problem = small_problem();
    WorkPrecision study{problem, truth(problem), {}};
    for (const char* name : {"explicit_euler", "stormer_verlet", "odeint:runge_kutta_dopri5"})
        study.curves.push_back(curve_of(name, problem, study.truth));
    return study;
}

TEST(WorkPrecisionCsv, HasALineForEveryRunAndAFieldForEveryColumn) {
    const WorkPrecision study = small_study();
    std::istringstream lines(to_csv(study, "somebody"));
    std::string line;
    std::getline(lines, line);
    EXPECT_EQ(line, "# somebody");
    std::getline(lines, line);
    EXPECT_THAT(line, HasSubstr("5 masses; elastic; 11 frames"));
    std::getline(lines, line);
    const auto columns = std::count(line.begin(), line.end(), ',');
    std::size_t rows = 0;
    for (; std::getline(lines, line); ++rows) EXPECT_EQ(std::count(line.begin(), line.end(), ','), columns);
    std::size_t runs = 0;
    for (const Curve& curve : study.curves) runs += curve.measurements.size();
    EXPECT_EQ(rows, runs);
}

}  // namespace
}  // namespace ropesim
