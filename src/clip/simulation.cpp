#include "clip/simulation.h"

#include "clip/csv.h"

#include <algorithm>

namespace ropesim {

namespace {

std::vector<MovingRope> at_start(const std::vector<Run>& runs) {
    std::vector<MovingRope> ropes;
    for (const Run& run : runs) ropes.emplace_back(run.rope, *run.method, run.stepping);
    return ropes;
}

}  // namespace

Simulation::Simulation(const Scene& scene, Errors errors)
    : runs_(ropesim::runs(scene)), moving_(at_start(runs_)) {
    positions_.resize(runs_.size());
    diagnostics_.resize(runs_.size());
    summaries_.resize(runs_.size());
    errors_.resize(runs_.size());
    if (errors != Errors::left_out) begin_errors(scene, errors);
    look();
}

void Simulation::begin_errors(const Scene& scene, Errors errors) {
    constexpr double share = 0.1;  // of the clip's time
    double masses = 0.0;
    double work = 0.0;
    for (std::size_t i = 0; i < runs_.size(); ++i) {
        const Run& run = runs_[i];
        if (run.method->model == Model::inextensible && !links_at_rest_length(run.rope, run.rope.start))
            continue;
        errors_[i] = std::make_unique<RopeError>(run.rope, *run.method, run.stepping,
                                                 scene.size[1] / scene.view.height);
        masses += static_cast<double>(run.rope.mass.size());
        work += errors_[i]->work();
    }
    if (errors == Errors::always || work <= share * drawing_work(masses)) return;
    for (auto& error : errors_) error.reset();
    why_no_errors_ = "it would take more than a tenth of the clip's time";
}

void Simulation::advance() {
    moving_.advance();
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
        if (errors_[i] && frame_ > 0) errors_[i]->add(positions_[i]);
    }
}

namespace {

std::string error_of(const Simulation& simulation, std::size_t rope) {
    const RopeError& error = *simulation.error(rope);
    const std::string worst = simulation.runs()[rope].description->name + ' ' + to_string(error.worst());
    if (simulation.diverged(rope)) return worst + " until it diverged";
    const auto last = error.last();
    return worst + " (last " + (last ? pixels(*last) : "unknown") + ')';
}

}  // namespace

double drawing_work(double masses) {
    constexpr double of_frame = 250'000.0;
    constexpr double of_mass = 1'000.0;
    return of_frame + of_mass * masses;
}

std::string error_line(const Simulation& simulation) {
    constexpr std::size_t most_named = 6;
    if (!simulation.why_no_errors().empty()) return "errors not estimated: " + simulation.why_no_errors();
    std::vector<std::size_t> known;
    for (std::size_t i = 0; i < simulation.runs().size(); ++i)
        if (simulation.error(i)) known.push_back(i);
    if (known.empty()) return "";
    std::string line;
    if (known.size() <= most_named) {
        for (const std::size_t i : known) line += (line.empty() ? "" : ", ") + error_of(simulation, i);
    } else {
        const auto by_error = [&](std::size_t a, std::size_t b) {
            return simulation.error(a)->worst().pixels < simulation.error(b)->worst().pixels;
        };
        line = error_of(simulation, *std::max_element(known.begin(), known.end(), by_error)) + ", worst of " +
               std::to_string(known.size()) + " ropes";
    }
    return "error, worst frame: " + line;
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
