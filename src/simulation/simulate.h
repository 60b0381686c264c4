#pragma once

#include "simulation/diagnostics.h"
#include "simulation/method.h"

#include <optional>
#include <vector>

namespace ropesim {

// A rope on its way from frame to frame, from rest in frame 0 on. It has diverged where a coordinate is not
// finite or a link longer than `sensible_length`. Looks at the rope and the method, which must outlive it.
class MovingRope {
  public:
    MovingRope(const Rope& rope, const Method& method, const Stepping& stepping);

    // Goes on to the next frame; a rope that has diverged stays where it is.
    void advance();

    // The same where the leaps of its method have taken it there, rope `lane` of a bundle, at that cost.
    void advance(const Bundle& bundle, Eigen::Index lane, const Leaps& leaps, const Cost& cost);

    const Rope& rope() const { return *rope_; }
    const Method& method() const { return *method_; }
    const Stepping& stepping() const { return stepping_; }

    // In the frame it is at; nothing in it is meant to be looked at where the rope has diverged.
    const State& state() const { return state_; }
    Diagnostics diagnostics() const;

    // The frame that it did not reach.
    std::optional<long> diverged() const { return diverged_; }

    // Of all frames, that of a diverged one included.
    const Cost& cost() const { return scratch_.cost; }

  private:
    void enter(long frame);
    bool has_diverged() const;

    const Rope* rope_;
    const Method* method_;
    Stepping stepping_;
    double sensible_length_;  // while it does not fall
    State state_;
    Scratch scratch_;
    long frame_ = 0;
    std::optional<long> diverged_;
};

// What a rope went through in the frames that were added, one after the other.
struct Summary {
    double largest_stretch = 0.0;        // in any frame
    double largest_tension = 0.0;        // in any frame
    std::optional<Energy> first_energy;  // of the first frame; none where there is no frame
    Energy last_energy;                  // of the last one

    // Total energy of the last frame less that of the first.
    double energy_drift() const { return first_energy ? last_energy.total() - first_energy->total() : 0.0; }

    void add(const Diagnostics& frame);
};

// How a rope moved. Where it diverged the frames end; nothing in it is ever non-finite.
struct Trajectory {
    std::vector<Points> frames;    // positions of frame 0 (the start), 1, 2, ...; world units, masses×2
    Summary summary;               // of these frames
    std::optional<long> diverged;  // the frame that the rope did not reach
    Cost cost;                     // of all frames, that of a diverged one included
};

// Positions of so many masses in so many frames may be kept in memory: 4 GB of them.
inline constexpr double most_kept = 268'435'456.0;

// Throws std::runtime_error where they would be more.
void check_kept(double masses, long frames);

// Runs the rope from rest over `frames` frames, frame 0 included.
Trajectory simulate(const Rope& rope, const Method& method, const Stepping& stepping, long frames);

// A length that no link comes near in a stable run, by time t: a thousand times the rope's length and the
// way that free fall takes.
double sensible_length(const Rope& rope, double time);

}  // namespace ropesim
