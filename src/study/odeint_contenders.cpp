#include "simulation/links.h"
#include "study/contender.h"

// Boost.Odeint's headers convert between integers and floating point as they please.
#pragma GCC diagnostic push
#pragma GCC diagnostic ignored "-Wconversion"
#pragma GCC diagnostic ignored "-Wsign-conversion"
#pragma GCC diagnostic ignored "-Wshadow"
#include <boost/numeric/odeint/algebra/vector_space_algebra.hpp>
#include <boost/numeric/odeint/external/eigen/eigen_resize.hpp>
#include <boost/numeric/odeint/stepper/controlled_runge_kutta.hpp>
#include <boost/numeric/odeint/stepper/generation.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_dopri5.hpp>
#include <boost/numeric/odeint/stepper/runge_kutta_fehlberg78.hpp>
#include <boost/numeric/odeint/stepper/symplectic_euler.hpp>
#include <boost/numeric/odeint/stepper/symplectic_rkn_sb3a_mclachlan.hpp>
#include <boost/numeric/odeint/stepper/velocity_verlet.hpp>
#pragma GCC diagnostic pop

#include <algorithm>
#include <optional>
#include <utility>

namespace odeint = boost::numeric::odeint;
using Eigen::ArrayXd;

namespace boost::numeric::odeint {
template <>
struct vector_space_norm_inf<ArrayXd> {
    using result_type = double;
    double operator()(const ArrayXd& values) const { return values.abs().maxCoeff(); }
};
}  // namespace boost::numeric::odeint

namespace ropesim {
namespace {

using Algebra = odeint::vector_space_algebra;
using Operations = odeint::default_operations;

// Coordinates and velocities apart, x of all masses before their y, as the symplectic steppers want them.
struct Phase {
    ArrayXd place;
    ArrayXd speed;
};

template <class Stepper>
void do_step(Stepper& stepper, const Rope& rope, Scratch& scratch, Phase& phase, double time, double step) {
    stepper.do_step(
        [&](const ArrayXd& place, ArrayXd& acceleration) {
            accelerations(rope, place.data(), acceleration.data(), scratch);
        },
        std::make_pair(std::ref(phase.place), std::ref(phase.speed)), time, step);
}

using VelocityVerlet =
    odeint::velocity_verlet<ArrayXd, ArrayXd, double, ArrayXd, double, double, Algebra, Operations>;

void do_step(VelocityVerlet& stepper, const Rope& rope, Scratch& scratch, Phase& phase, double time,
             double step) {
    stepper.do_step([&](const ArrayXd& place, const ArrayXd&, ArrayXd& acceleration,
                        double) { accelerations(rope, place.data(), acceleration.data(), scratch); },
                    std::make_pair(std::ref(phase.place), std::ref(phase.speed)), time, step);
}

Points points(const ArrayXd& place) {
    return Eigen::Map<const Points>(place.data(), place.size() / 2, 2);
}

template <class Stepper>
class FixedSteps final : public Solver {
  public:
    FixedSteps(const Problem& problem, long steps)
        : rope_(problem.rope), stepping_(stepping(problem, steps)) {
        restart();
    }
    void restart() override {
        phase_.place = rope_.start.reshaped();
        phase_.speed = ArrayXd::Zero(rope_.start.size());
        stepper_.emplace();
    }
    bool advance() override {
        for (long step = 0; step < stepping_.steps; ++step)
            do_step(*stepper_, rope_, scratch_, phase_, 0.0, stepping_.step_size);
        return true;
    }
    Points position() const override { return points(phase_.place); }
    Cost cost() const override { return scratch_.cost; }

  private:
    const Rope& rope_;
    Stepping stepping_;
    Phase phase_;
    Scratch scratch_;
    std::optional<Stepper> stepper_;
};

// y is the coordinates, x of all masses before their y, then the velocities in the same order.
void derivative(const Rope& rope, const ArrayXd& y, ArrayXd& result, Scratch& scratch) {
    const Eigen::Index coordinates = y.size() / 2;
    result.head(coordinates) = y.tail(coordinates);
    accelerations(rope, y.data(), result.data() + coordinates, scratch);
    if (rope.damping > 0.0) result.tail(coordinates) -= rope.damping * y.tail(coordinates);
}

// Steps as the controller wants them, but for the last of each frame, which ends on it.
template <class Stepper>
class AdaptiveSteps final : public Solver {
  public:
    AdaptiveSteps(const Problem& problem, double tolerance)
        : rope_(problem.rope), frame_time_(problem.frame_time), tolerance_(tolerance) {
        restart();
    }
    void restart() override {
        y_ = ArrayXd::Zero(2 * rope_.start.size());
        y_.head(rope_.start.size()) = rope_.start.reshaped();
        stepper_.emplace(odeint::make_controlled(tolerance_ * tolerance_scale(rope_), tolerance_, Stepper()));
        step_ = first_step * frame_time_;
    }
    bool advance() override;
    Points position() const override { return points(y_.head(y_.size() / 2)); }
    Cost cost() const override { return scratch_.cost; }

  private:
    static constexpr double first_step = 1e-3;      // of a frame
    static constexpr double shortest_step = 1e-12;  // of a frame; below it the motion cannot be followed

    const Rope& rope_;
    double frame_time_;
    double tolerance_;
    std::optional<typename odeint::result_of::make_controlled<Stepper>::type> stepper_;
    ArrayXd y_;
    Scratch scratch_;
    double step_ = 0.0;
};

template <class Stepper>
bool AdaptiveSteps<Stepper>::advance() {
    const long most = scratch_.cost.evaluations + most_evaluations_per_frame;
    const auto f = [this](const ArrayXd& y, ArrayXd& result, double) {
        derivative(rope_, y, result, scratch_);
    };
    double time = 0.0;
    while (time < frame_time_) {
        const bool last = time + step_ >= frame_time_;
        double step = last ? frame_time_ - time : step_;
        const double tried = step;
        const bool done = stepper_->try_step(f, y_, time, step) == odeint::success;
        // A step that was cut at the frame says nothing against the longer one that was to be.
        step_ = done && last && step >= tried ? std::max(step, step_) : step;
        if (done && last) return true;
        if (!(step_ > shortest_step * frame_time_) || scratch_.cost.evaluations > most) return false;
    }
    return true;
}

template <class Stepper>
Contender fixed(const char* name, int order) {
    Contender contender;
    contender.name = name;
    contender.library = "odeint";
    contender.order = order;
    contender.damps = false;
    contender.make = [](const Problem& problem, double steps) -> std::unique_ptr<Solver> {
        return std::make_unique<FixedSteps<Stepper>>(problem, static_cast<long>(steps));
    };
    return contender;
}

template <class Stepper>
Contender adaptive(const char* name) {
    Contender contender;
    contender.name = name;
    contender.library = "odeint";
    contender.setting = Setting::tolerance;
    contender.make = [](const Problem& problem, double tolerance) -> std::unique_ptr<Solver> {
        return std::make_unique<AdaptiveSteps<Stepper>>(problem, tolerance);
    };
    return contender;
}

}  // namespace

std::vector<Contender> odeint_contenders() {
    using SymplecticEuler =
        odeint::symplectic_euler<ArrayXd, ArrayXd, double, ArrayXd, ArrayXd, double, Algebra, Operations>;
    using McLachlan = odeint::symplectic_rkn_sb3a_mclachlan<ArrayXd, ArrayXd, double, ArrayXd, ArrayXd,
                                                            double, Algebra, Operations>;
    using Dopri5 = odeint::runge_kutta_dopri5<ArrayXd, double, ArrayXd, double, Algebra, Operations>;
    using Fehlberg78 = odeint::runge_kutta_fehlberg78<ArrayXd, double, ArrayXd, double, Algebra, Operations>;
    return {fixed<SymplecticEuler>("symplectic_euler", 1), fixed<VelocityVerlet>("velocity_verlet", 2),
            fixed<McLachlan>("symplectic_rkn_sb3a_mclachlan", 4), adaptive<Dopri5>("runge_kutta_dopri5"),
            adaptive<Fehlberg78>("runge_kutta_fehlberg78")};
}

}  // namespace ropesim
