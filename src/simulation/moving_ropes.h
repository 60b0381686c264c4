#pragma once

#include "simulation/bundle.h"
#include "simulation/leaps.h"
#include "simulation/simulate.h"

#include <cstddef>
#include <vector>

namespace ropesim {

// Ropes on their way together, each of the same bits as alone. Short ropes that have method, stepping, number
// of masses and damping in common lie side by side in the lanes of the processor, eight in AVX-512.
class MovingRopes {
  public:
    explicit MovingRopes(std::vector<MovingRope> ropes);

    // All go on to the next frame; a rope that has diverged stays where it is.
    void advance();

    std::size_t size() const { return ropes_.size(); }
    const MovingRope& operator[](std::size_t rope) const { return ropes_[rope]; }

  private:
    struct SideBySide {
        std::vector<std::size_t> ropes;
        Bundle bundle;
        Leaps leaps{};
    };
    void put_states(SideBySide& side_by_side) const;
    void advance(SideBySide& side_by_side);

    std::vector<MovingRope> ropes_;
    std::vector<SideBySide> side_by_side_;
    std::vector<std::size_t> alone_;
};

}  // namespace ropesim
