#include "clip/simulation.h"

#include "clip/csv.h"

namespace ropesim {

Simulation::Simulation(const Scene& scene) : runs_(ropesim::runs(scene)) {
    for (const Run& run : runs_) moving_.emplace_back(run.rope, *run.method, run.stepping);
    positions_.resize(runs_.size());
    diagnostics_.resize(runs_.size());
    summaries_.resize(runs_.size());
    look();
}

void Simulation::advance() {
    for (MovingRope& rope : moving_) rope.advance();
    ++frame_;
    look();
}

// What there is to say of the frame that the ropes have come to.
void Simulation::look() {
    for (std::size_t i = 0; i < moving_.size(); ++i) {
        if (moving_[i].diverged()) {
            positions_[i].resize(0, 2);
            continue;
        }
        positions_[i] = moving_[i].state().position;
        diagnostics_[i] = moving_[i].diagnostics();
        summaries_[i].add(diagnostics_[i]);
    }
}

std::string diagnostics_csv_lines(const Simulation& simulation) {
    std::string text;
    for (std::size_t i = 0; i < simulation.runs().size(); ++i) {
        if (simulation.diverged(i)) continue;
        const Diagnostics& each = simulation.diagnostics()[i];
        text += std::to_string(simulation.frame()) + ',' + quoted(simulation.runs()[i].description->name);
        for (const double number : {each.energy.kinetic, each.energy.spring, each.energy.gravity,
                                    each.largest_stretch, each.largest_tension, each.length}) {
            text += ',';
            append_number(text, number);
        }
        text += '\n';
    }
    return text;
}

}  // namespace ropesim
