#pragma once

#include "clip/rope_error.h"
#include "clip/run.h"
#include "scene/scene.h"
#include "simulation/moving_ropes.h"

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace ropesim {

// The ropes of a scene as they move from frame to frame, from frame 0 on, and what they went through until
// then. Holds one frame, however long the clip. Looks at the scene, which must outlive it.
class Simulation {
  public:
    // Estimating errors takes a second and a third run of each rope: where it may take more than a tenth of
    // the clip's time, or less, or not at all.
    enum class Errors { always, estimated, left_out };
    Simulation(const Scene& scene, Errors errors);
    Simulation(const Simulation&) = delete;
    Simulation& operator=(const Simulation&) = delete;

    long frame() const { return frame_; }
    void advance();  // to the next frame

    // The ropes of the scene, in its order: what moves them, ...
    const std::vector<Run>& runs() const { return runs_; }
    // ... where they are in this frame (no rows where a rope has diverged), ...
    const std::vector<Points>& positions() const { return positions_; }
    // ... what they are like in it (meaningless where a rope has diverged), ...
    const std::vector<Diagnostics>& diagnostics() const { return diagnostics_; }
    // ... what they went through up to it, ...
    const std::vector<Summary>& summaries() const { return summaries_; }
    // ... what that took, ...
    const Cost& cost(std::size_t rope) const { return moving_[rope].cost(); }
    // ... and the frame that each did not reach.
    std::optional<long> diverged(std::size_t rope) const { return moving_[rope].diverged(); }

    // How wrong a rope is; null where that is left out.
    const RopeError* error(std::size_t rope) const { return errors_[rope].get(); }
    // Why errors are left out, although they were to be estimated; "" where they are not.
    const std::string& why_no_errors() const { return why_no_errors_; }

  private:
    void look();
    void begin_errors(const Scene& scene, Errors errors);

    long frame_ = 0;
    std::vector<Run> runs_;
    MovingRopes moving_;
    std::vector<Points> positions_;
    std::vector<Diagnostics> diagnostics_;
    std::vector<Summary> summaries_;
    std::vector<std::unique_ptr<RopeError>> errors_;
    std::string why_no_errors_;
};

// What drawing a frame with so many masses takes, about, in evaluations of the acceleration of one mass: by
// counts, so that it is the same everywhere.
double drawing_work(double masses);

// How wrong the ropes are, in a line for the end of a run: "error, worst frame: Euler 0.2 px (last
// 0.1 px), ..."; of many ropes the worst. "" where nothing was to be estimated.
std::string error_line(const Simulation& simulation);

// CSV of what the ropes are like: this line, then for every frame one for each rope that has not diverged.
inline constexpr std::string_view diagnostics_csv_header =
    "frame,rope,kinetic,spring,gravity,largest_stretch,largest_tension,length";
std::string diagnostics_csv_lines(const Simulation& simulation);

}  // namespace ropesim
