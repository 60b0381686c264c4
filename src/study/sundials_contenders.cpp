#include "simulation/links.h"
#include "study/contender.h"

#include <arkode/arkode_erkstep.h>
#include <cvode/cvode.h>
#include <nvector/nvector_serial.h>
#include <sundials/sundials_context.h>
#include <sunlinsol/sunlinsol_band.h>
#include <sunmatrix/sunmatrix_band.h>
#include <sunnonlinsol/sunnonlinsol_fixedpoint.h>

#include <stdexcept>
#include <type_traits>

namespace ropesim {
namespace {

using Eigen::Index;

template <auto release>
struct Release {
    template <class Handle>
    void operator()(Handle* handle) const {
        release(handle);
    }
};
void free_context(SUNContext context) {
    SUNContext_Free(&context);
}
void free_cvode(void* solver) {
    CVodeFree(&solver);
}
void free_arkode(void* solver) {
    ERKStepFree(&solver);
}
template <class Handle, auto release>
using Owned = std::unique_ptr<std::remove_pointer_t<Handle>, Release<release>>;

void require(bool done) {
    if (!done) throw std::runtime_error("study: SUNDIALS could not be set up");
}

void keep_quiet(int, const char*, const char*, char*, void*) {}

// What a right-hand side needs. In columns, y is x of all masses, their y, then the velocities likewise;
// by masses, it is x, y and velocity of mass 0, then of mass 1, so that the Jacobian is a band.
struct System {
    const Rope& rope;
    Scratch scratch;
    Points place;         // by masses only
    Points acceleration;  // by masses only
    long most_evaluations = 0;

    explicit System(const Rope& its_rope)
        : rope(its_rope), place(rope.start.rows(), 2), acceleration(rope.start.rows(), 2) {}
};

constexpr int recoverable = 1;
constexpr int give_up = -1;

int derivative_in_columns(realtype, N_Vector from, N_Vector to, void* data) {
    System& system = *static_cast<System*>(data);
    if (system.scratch.cost.evaluations > system.most_evaluations) return give_up;
    const Index coordinates = system.rope.start.size();
    const Eigen::Map<const Eigen::ArrayXd> y(N_VGetArrayPointer(from), 2 * coordinates);
    Eigen::Map<Eigen::ArrayXd> result(N_VGetArrayPointer(to), 2 * coordinates);
    result.head(coordinates) = y.tail(coordinates);
    accelerations(system.rope, y.data(), result.data() + coordinates, system.scratch);
    if (system.rope.damping > 0.0) result.tail(coordinates) -= system.rope.damping * y.tail(coordinates);
    return result.isFinite().all() ? 0 : recoverable;
}

int derivative_by_masses(realtype, N_Vector from, N_Vector to, void* data) {
    System& system = *static_cast<System*>(data);
    if (system.scratch.cost.evaluations > system.most_evaluations) return give_up;
    const Index masses = system.rope.start.rows();
    const Eigen::Map<const Eigen::Array4Xd> y(N_VGetArrayPointer(from), 4, masses);
    Eigen::Map<Eigen::Array4Xd> result(N_VGetArrayPointer(to), 4, masses);
    system.place = y.topRows<2>().transpose();
    accelerations(system.rope, system.place.data(), system.acceleration.data(), system.scratch);
    result.topRows<2>() = y.bottomRows<2>();
    result.bottomRows<2>() = system.acceleration.transpose() - system.rope.damping * y.bottomRows<2>();
    return result.isFinite().all() ? 0 : recoverable;
}

// What the solvers of SUNDIALS share: context, vector, system.
class SundialsSolver : public Solver {
  public:
    explicit SundialsSolver(const Problem& problem) : system_(problem.rope), frame_time_(problem.frame_time) {
        SUNContext context = nullptr;
        require(SUNContext_Create(nullptr, &context) == 0);
        context_.reset(context);
        y_.reset(N_VNew_Serial(2 * problem.rope.start.size(), context));
        require(y_ != nullptr);
    }
    bool advance() override {
        system_.most_evaluations = system_.scratch.cost.evaluations + most_evaluations_per_frame;
        ++frame_;
        return advance_to(static_cast<double>(frame_) * frame_time_);
    }

  protected:
    virtual bool advance_to(double time) = 0;

    double* values() const { return N_VGetArrayPointer(y_.get()); }
    void place_in_columns() {
        const Index coordinates = system_.rope.start.size();
        Eigen::Map<Eigen::ArrayXd> y(values(), 2 * coordinates);
        y.head(coordinates) = system_.rope.start.reshaped();
        y.tail(coordinates) = 0.0;
    }

    System system_;
    double frame_time_;
    long frame_ = 0;
    Owned<SUNContext, free_context> context_;
    Owned<N_Vector, N_VDestroy> y_;
};

class CvodeAdams : public SundialsSolver {
  public:
    CvodeAdams(const Problem& problem, double tolerance) : SundialsSolver(problem) {
        place_in_columns();
        iteration_.reset(SUNNonlinSol_FixedPoint(y_.get(), 0, context_.get()));
        solver_.reset(CVodeCreate(CV_ADAMS, context_.get()));
        require(solver_ && iteration_);
        require(CVodeInit(solver_.get(), derivative_in_columns, 0.0, y_.get()) == CV_SUCCESS &&
                CVodeSetErrHandlerFn(solver_.get(), keep_quiet, nullptr) == CV_SUCCESS &&
                CVodeSetUserData(solver_.get(), &system_) == CV_SUCCESS &&
                CVodeSStolerances(solver_.get(), tolerance, tolerance * tolerance_scale(problem.rope)) ==
                    CV_SUCCESS &&
                CVodeSetMaxNumSteps(solver_.get(), most_evaluations_per_frame) == CV_SUCCESS &&
                CVodeSetNonlinearSolver(solver_.get(), iteration_.get()) == CV_SUCCESS);
    }
    void restart() override {
        frame_ = 0;
        place_in_columns();
        require(CVodeReInit(solver_.get(), 0.0, y_.get()) == CV_SUCCESS);
    }
    Points position() const override {
        return Eigen::Map<const Points>(values(), system_.rope.start.rows(), 2);
    }
    Cost cost() const override { return system_.scratch.cost; }

  private:
    bool advance_to(double time) override {
        double reached = 0.0;
        return CVode(solver_.get(), time, y_.get(), &reached, CV_NORMAL) >= 0;
    }
    Owned<SUNNonlinearSolver, SUNNonlinSolFree> iteration_;
    Owned<void*, free_cvode> solver_;
};

class CvodeBdf : public SundialsSolver {
  public:
    CvodeBdf(const Problem& problem, double tolerance) : SundialsSolver(problem) {
        // A velocity of mass i changes with x and y of masses i - 1 to i + 1.
        constexpr int above = 3;
        constexpr int below = 7;
        place_by_masses();
        matrix_.reset(SUNBandMatrix(2 * problem.rope.start.size(), above, below, context_.get()));
        require(matrix_ != nullptr);
        band_.reset(SUNLinSol_Band(y_.get(), matrix_.get(), context_.get()));
        solver_.reset(CVodeCreate(CV_BDF, context_.get()));
        require(band_ && solver_);
        require(CVodeInit(solver_.get(), derivative_by_masses, 0.0, y_.get()) == CV_SUCCESS &&
                CVodeSetErrHandlerFn(solver_.get(), keep_quiet, nullptr) == CV_SUCCESS &&
                CVodeSetUserData(solver_.get(), &system_) == CV_SUCCESS &&
                CVodeSStolerances(solver_.get(), tolerance, tolerance * tolerance_scale(problem.rope)) ==
                    CV_SUCCESS &&
                CVodeSetMaxNumSteps(solver_.get(), most_evaluations_per_frame) == CV_SUCCESS &&
                CVodeSetLinearSolver(solver_.get(), band_.get(), matrix_.get()) == CV_SUCCESS);
    }
    void restart() override {
        frame_ = 0;
        solves_before_ += solves();
        place_by_masses();
        require(CVodeReInit(solver_.get(), 0.0, y_.get()) == CV_SUCCESS);
    }
    Points position() const override {
        return Eigen::Map<const Eigen::Array4Xd>(values(), 4, system_.rope.start.rows())
            .topRows<2>()
            .transpose();
    }
    Cost cost() const override {
        return {.evaluations = system_.scratch.cost.evaluations, .solves = solves_before_ + solves()};
    }

  private:
    bool advance_to(double time) override {
        double reached = 0.0;
        return CVode(solver_.get(), time, y_.get(), &reached, CV_NORMAL) >= 0;
    }
    void place_by_masses() {
        Eigen::Map<Eigen::Array4Xd> y(values(), 4, system_.rope.start.rows());
        y.topRows<2>() = system_.rope.start.transpose();
        y.bottomRows<2>() = 0.0;
    }
    long solves() const {
        long count = 0;
        CVodeGetNumNonlinSolvIters(solver_.get(), &count);
        return count;
    }
    long solves_before_ = 0;
    Owned<SUNMatrix, SUNMatDestroy> matrix_;
    Owned<SUNLinearSolver, SUNLinSolFree> band_;
    Owned<void*, free_cvode> solver_;
};

// Ends its steps on the frames: between steps ARKODE interpolates with less than the method's order.
class ArkodeErk : public SundialsSolver {
  public:
    ArkodeErk(const Problem& problem, double tolerance, ARKODE_ERKTableID table) : SundialsSolver(problem) {
        place_in_columns();
        solver_.reset(ERKStepCreate(derivative_in_columns, 0.0, y_.get(), context_.get()));
        require(solver_ != nullptr);
        require(ERKStepSetErrHandlerFn(solver_.get(), keep_quiet, nullptr) == ARK_SUCCESS &&
                ERKStepSetUserData(solver_.get(), &system_) == ARK_SUCCESS &&
                ERKStepSetTableNum(solver_.get(), table) == ARK_SUCCESS &&
                ERKStepSStolerances(solver_.get(), tolerance, tolerance * tolerance_scale(problem.rope)) ==
                    ARK_SUCCESS &&
                ERKStepSetMaxNumSteps(solver_.get(), most_evaluations_per_frame) == ARK_SUCCESS);
    }
    void restart() override {
        frame_ = 0;
        place_in_columns();
        require(ERKStepReInit(solver_.get(), derivative_in_columns, 0.0, y_.get()) == ARK_SUCCESS);
    }
    Points position() const override {
        return Eigen::Map<const Points>(values(), system_.rope.start.rows(), 2);
    }
    Cost cost() const override { return system_.scratch.cost; }

  private:
    bool advance_to(double time) override {
        double reached = 0.0;
        return ERKStepSetStopTime(solver_.get(), time) == ARK_SUCCESS &&
               ERKStepEvolve(solver_.get(), time, y_.get(), &reached, ARK_NORMAL) >= 0;
    }
    Owned<void*, free_arkode> solver_;
};

template <class Make>
Contender adaptive(const char* name, Make make) {
    Contender contender;
    contender.name = name;
    contender.library = "sundials";
    contender.setting = Setting::tolerance;
    contender.make = make;
    return contender;
}

Contender erk(const char* name, ARKODE_ERKTableID table) {
    return adaptive(name, [table](const Problem& problem, double tolerance) -> std::unique_ptr<Solver> {
        return std::make_unique<ArkodeErk>(problem, tolerance, table);
    });
}

}  // namespace

std::vector<Contender> sundials_contenders() {
    return {adaptive("cvode_adams",
                     [](const Problem& problem, double tolerance) -> std::unique_ptr<Solver> {
                         return std::make_unique<CvodeAdams>(problem, tolerance);
                     }),
            adaptive("cvode_bdf",
                     [](const Problem& problem, double tolerance) -> std::unique_ptr<Solver> {
                         return std::make_unique<CvodeBdf>(problem, tolerance);
                     }),
            erk("arkode_dormand_prince_5", ARKODE_DORMAND_PRINCE_7_4_5),
            erk("arkode_fehlberg_8", ARKODE_FEHLBERG_13_7_8)};
}

}  // namespace ropesim
