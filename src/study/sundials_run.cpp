#include "study/sundials_run.h"

#include "study/link_angles.h"

#include <arkode/arkode_erkstep.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>

#include <functional>
#include <memory>
#include <stdexcept>

namespace ropesim {
namespace {

using Eigen::Index;
using Eigen::VectorXd;

// y' = f(y)
using RightHandSide = std::function<VectorXd(const VectorXd&)>;

struct FreeContext {
    void operator()(SUNContext context) const { SUNContext_Free(&context); }
};
struct FreeVector {
    void operator()(N_Vector vector) const { N_VDestroy(vector); }
};
struct FreeSolver {
    void operator()(void* solver) const { ERKStepFree(&solver); }
};

void require(bool done) {
    if (!done) throw std::runtime_error("reference: SUNDIALS could not be set up");
}

// Of a component and of the system's scale, whichever is greater. At a tenth of it the error stays, since
// double's rounding makes it, and the run takes half as long again; at ten times it the error grows.
constexpr double tolerance = 1e-14;

constexpr long most_steps_per_frame = 100'000;

int call_right_hand_side(sunrealtype /*time*/, N_Vector y, N_Vector derivative, void* f) {
    const Index size = static_cast<Index>(N_VGetLength(y));
    const VectorXd result =
        (*static_cast<RightHandSide*>(f))(Eigen::Map<const VectorXd>(N_VGetArrayPointer(y), size));
    if (!result.allFinite()) return 1;
    Eigen::Map<VectorXd>(N_VGetArrayPointer(derivative), size) = result;
    return 0;
}

void keep_quiet(int, const char*, const char*, char*, void*) {}

// ARKODE on one system, frame by frame.
class Solver {
  public:
    Solver(RightHandSide f, const VectorXd& start, double scale);

    // Advances by `time`; false where it cannot.
    bool advance(double time);
    VectorXd state() const { return Eigen::Map<const VectorXd>(N_VGetArrayPointer(y_.get()), size_); }

  private:
    RightHandSide f_;
    Index size_;
    std::unique_ptr<std::remove_pointer_t<SUNContext>, FreeContext> context_;
    std::unique_ptr<std::remove_pointer_t<N_Vector>, FreeVector> y_;
    std::unique_ptr<void, FreeSolver> solver_;
};

Solver::Solver(RightHandSide f, const VectorXd& start, double scale) : f_(std::move(f)), size_(start.size()) {
    SUNContext context = nullptr;
    require(SUNContext_Create(nullptr, &context) == 0);
    context_.reset(context);
    y_.reset(N_VNew_Serial(size_, context));
    require(y_ != nullptr);
    Eigen::Map<VectorXd>(N_VGetArrayPointer(y_.get()), size_) = start;
    solver_.reset(ERKStepCreate(call_right_hand_side, 0.0, y_.get(), context));
    require(solver_ != nullptr);
    require(ERKStepSetErrHandlerFn(solver_.get(), keep_quiet, nullptr) == ARK_SUCCESS);
    require(ERKStepSetUserData(solver_.get(), &f_) == ARK_SUCCESS);
    require(ERKStepSetTableNum(solver_.get(), ARKODE_FEHLBERG_13_7_8) == ARK_SUCCESS);
    require(ERKStepSStolerances(solver_.get(), tolerance, tolerance * scale) == ARK_SUCCESS);
    require(ERKStepSetMaxNumSteps(solver_.get(), most_steps_per_frame) == ARK_SUCCESS);
}

// Each frame begins at time 0, where time has the finest rounding, and ends on a step.
bool Solver::advance(double time) {
    double reached = 0.0;
    return ERKStepReset(solver_.get(), 0.0, y_.get()) == ARK_SUCCESS &&
           ERKStepSetStopTime(solver_.get(), time) == ARK_SUCCESS &&
           ERKStepEvolve(solver_.get(), time, y_.get(), &reached, ARK_NORMAL) >= 0;
}

// y is x of all masses, then their y, then their velocities in the same order.
VectorXd elastic_derivative(const Rope& rope, const VectorXd& y) {
    const Index masses = rope.start.rows();
    const auto place = [&](Index i) { return Eigen::Vector2d(y(i), y(masses + i)); };
    VectorXd result(4 * masses);
    result.head(2 * masses) = y.tail(2 * masses);
    Eigen::Map<Eigen::MatrixX2d> acceleration(result.data() + 2 * masses, masses, 2);
    acceleration.setZero();
    for (Index i = 0; i + 1 < masses; ++i) {
        const Eigen::Vector2d difference = place(i + 1) - place(i);
        const Eigen::Vector2d force =
            rope.stiffness * (1.0 - rope.rest_length / difference.norm()) * difference;
        acceleration.row(i) += force.transpose() / rope.mass(i);
        acceleration.row(i + 1) -= force.transpose() / rope.mass(i + 1);
    }
    acceleration.rowwise() += rope.gravity.matrix().transpose();
    result.tail(2 * masses) -= rope.damping * y.tail(2 * masses);
    for (const Index pin : rope.pinned) acceleration.row(pin).setZero();
    return result;
}

Run elastic_run(const Rope& rope, double frame_time, long frames) {
    const Index masses = rope.start.rows();
    VectorXd start = VectorXd::Zero(4 * masses);
    start.head(2 * masses) = rope.start.matrix().reshaped();
    Solver solver([&](const VectorXd& y) { return elastic_derivative(rope, y); }, start,
                  rope.rest_length * static_cast<double>(masses));
    Run run;
    for (long frame = 0; frame < frames; ++frame) {
        if (frame > 0 && !solver.advance(frame_time)) break;
        const VectorXd y = solver.state();
        run.position.push_back(y.head(2 * masses).reshaped(masses, 2).array());
        run.velocity.push_back(y.tail(2 * masses).reshaped(masses, 2).array());
    }
    return run;
}

Run inextensible_run(const Rope& rope, double frame_time, long frames) {
    const LinkAngles angles(rope);
    const Index unknowns = angles.start().size();
    VectorXd start = VectorXd::Zero(2 * unknowns);
    start.head(unknowns) = angles.start();
    const auto derivative = [&](const VectorXd& y) {
        VectorXd result(2 * unknowns);
        result << y.tail(unknowns), angles.acceleration(y.head(unknowns), y.tail(unknowns));
        return result;
    };
    Solver solver(derivative, start, 1.0);
    Run run;
    for (long frame = 0; frame < frames; ++frame) {
        if (frame > 0 && !solver.advance(frame_time)) break;
        const VectorXd y = solver.state();
        run.position.push_back(angles.position(y.head(unknowns)));
        run.velocity.push_back(angles.velocity(y.head(unknowns), y.tail(unknowns)));
    }
    return run;
}

}  // namespace

Run sundials_run(const Rope& rope, Model model, double frame_time, long frames) {
    return model == Model::elastic ? elastic_run(rope, frame_time, frames)
                                   : inextensible_run(rope, frame_time, frames);
}

}  // namespace ropesim
