#include "compare/parting.h"

#include "clip/csv.h"
#include "clip/rope_error.h"
#include "clip/simulation.h"

#include <algorithm>

namespace ropesim {
namespace {

constexpr double parted = 1.0;  // pixels

std::optional<Apart> apart(const Points& first, const Points& run, double pixels_per_unit) {
    if (first.rows() == 0 || run.rows() == 0) return std::nullopt;
    const Eigen::ArrayXd distance = (run - first).square().rowwise().sum().sqrt();
    return Apart{pixels_per_unit * distance.maxCoeff(), pixels_per_unit * distance.mean()};
}

std::vector<ComparedFrame> compared_frame(const Simulation& simulation, double pixels_per_unit) {
    std::vector<ComparedFrame> frame;
    const std::vector<Points>& positions = simulation.positions();
    for (std::size_t i = 0; i < positions.size(); ++i) {
        ComparedFrame& run = frame.emplace_back();
        run.apart = apart(positions.front(), positions[i], pixels_per_unit);
        if (simulation.diverged(i)) continue;
        const Energy& energy = simulation.diagnostics()[i].energy;
        run.energy = energy.kinetic + energy.spring + energy.gravity;
    }
    return frame;
}

void append(std::string& csv, const std::optional<double>& number) {
    csv += ',';
    if (number) append_number(csv, *number);
}

}  // namespace

Parting parting(const Scene& scene) {
    const double pixels_per_unit = scene.size[1] / scene.view.height;
    Simulation simulation(scene, Simulation::Errors::left_out);
    Parting result;
    std::vector<double> farthest(scene.ropes.size());
    for (;; simulation.advance()) {
        result.frames.push_back(compared_frame(simulation, pixels_per_unit));
        for (std::size_t i = 0; i < farthest.size(); ++i) {
            ComparedFrame& run = result.frames.back()[i];
            run.farthest = farthest[i] = std::max(farthest[i], run.apart ? run.apart->greatest : 0.0);
        }
        if (simulation.frame() == scene.frames - 1) break;
    }
    for (std::size_t i = 0; i < scene.ropes.size(); ++i) result.diverged.push_back(simulation.diverged(i));
    return result;
}

std::string to_csv(const Scene& scene, const Parting& parting) {
    std::string csv = "frame,rope,against,greatest_px,mean_px,energy,energy_against\n";
    for (std::size_t f = 0; f < parting.frames.size(); ++f) {
        const std::vector<ComparedFrame>& runs = parting.frames[f];
        for (std::size_t i = 1; i < runs.size(); ++i) {
            const auto& apart = runs[i].apart;
            csv += std::to_string(f) + ',' + quoted(scene.ropes[i].name) + ',' +
                   quoted(scene.ropes.front().name);
            append(csv, apart ? std::optional(apart->greatest) : std::nullopt);
            append(csv, apart ? std::optional(apart->mean) : std::nullopt);
            append(csv, runs[i].energy);
            append(csv, runs.front().energy);
            csv += '\n';
        }
    }
    return csv;
}

std::vector<std::string> summaries(const Scene& scene, const Parting& parting) {
    std::vector<std::string> lines;
    for (std::size_t i = 1; i < scene.ropes.size(); ++i) {
        const double most = parting.frames.back()[i].farthest;
        const auto frame_of = [&](const auto& is_beyond) {
            const auto found = std::ranges::find_if(
                parting.frames, [&](const auto& runs) { return is_beyond(runs[i].farthest); });
            return "frame " + std::to_string(found - parting.frames.begin());
        };
        const std::string both = "'" + scene.ropes.front().name + "' and '" + scene.ropes[i].name + "' ";
        const std::string first =
            most > parted ? "part by more than a pixel in " + frame_of([](double px) { return px > parted; })
                          : "stay within a pixel";
        lines.push_back(both + first + "; farthest apart in " +
                        frame_of([&](double px) { return px == most; }) + ", by " + pixels(most));
    }
    return lines;
}

}  // namespace ropesim
