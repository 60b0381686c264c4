#pragma once

#include "study/method_error.h"

#include <functional>
#include <memory>
#include <string>
#include <vector>

namespace ropesim {

// Moves the rope of a problem frame by frame, at one setting. It may point into the problem.
class Solver {
  public:
    virtual ~Solver() = default;

    // At time 0, at rest.
    virtual void restart() = 0;

    // By one frame; false where it gives up.
    virtual bool advance() = 0;

    // Of all masses, world units.
    virtual Points position() const = 0;

    // Since the solver was made.
    virtual Cost cost() const = 0;
};

// What a solver is set by.
enum class Setting { steps_per_frame, tolerance };

// What takes part in a work-precision study.
struct Contender {
    std::string name;     // a method's, or of a stepper in its library
    std::string library;  // "" for a method of ours; else "odeint" or "sundials"
    Setting setting = Setting::steps_per_frame;
    int order = 0;                   // at fixed steps; 0 where steps adapt
    const Method* method = nullptr;  // of ours
    bool damps = true;               // whether it can follow a rope with damping
    std::function<std::unique_ptr<Solver>(const Problem& problem, double setting)> make;
};

// What it is called in charts and on the command line: library and name, the name alone for ours.
std::string label(const Contender& contender);

Contender contender(const Method& method);

// What else one would take for springs, all with the same accelerations as our methods.
// Boost.Odeint: symplectic steppers at fixed steps, Runge-Kutta pairs at a tolerance.
std::vector<Contender> odeint_contenders();
// SUNDIALS at a tolerance: CVODE by Adams and by BDF (band), ARKODE's explicit Runge-Kutta pairs.
std::vector<Contender> sundials_contenders();

// A tolerance is relative; this times it is the absolute one, world units and world units per unit of time.
double tolerance_scale(const Rope& rope);

// Greatest count of accelerations in one frame after which an adaptive solver gives up.
inline constexpr long most_evaluations_per_frame = 200'000;

}  // namespace ropesim
