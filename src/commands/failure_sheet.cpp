#include "commands/failure_sheet.h"

#include "clip/contact_sheet.h"
#include "clip/rope_error.h"

#include <string>

namespace ropesim {
namespace {

constexpr Color gray = {128, 128, 128};
constexpr Color blue = {86, 180, 233};
constexpr Color orange = {230, 159, 0};

constexpr int cell_width = 320;
constexpr std::size_t moments_of_a_run = 3;

std::string steps(const Showing& run) {
    return std::to_string(run.steps) + (run.steps == 1 ? " step" : " steps") + " per frame";
}

std::string verdict(const Showing& run) {
    if (run.diverged) return "diverges in frame " + std::to_string(*run.diverged);
    return pixels(run.worst) + " at worst";
}

SheetCell cell(const SceneRope& rope, const Truth& truth, const Showing::Moment& moment, Color color) {
    const double line_width = rope.line_width / 2.0;
    const Points& right = truth.reference.frames[static_cast<std::size_t>(moment.frame)];
    return {{{right, gray, line_width, 0.0}, {moment.position, color, line_width, rope.point_size / 2.0}},
            {{"frame " + std::to_string(moment.frame) + ": " + pixels(moment.error), gray}}};
}

void add_run(std::vector<SheetCell>& row, const SceneRope& rope, const Truth& truth,
             const std::optional<Showing>& run, const Words& heading, Color color) {
    if (!run) {
        row.resize(row.size() + moments_of_a_run);
        row[row.size() - moments_of_a_run].words = {heading};
        return;
    }
    for (const Showing::Moment& moment : run->moments) row.push_back(cell(rope, truth, moment, color));
    std::vector<Words>& words = row[row.size() - moments_of_a_run].words;
    words.insert(words.begin(), {heading, {steps(*run) + ": " + verdict(*run), color}});
}

}  // namespace

Image failure_sheet(const Scene& scene, const SceneRope& rope, const Truth& truth,
                    const std::vector<Failure>& failures) {
    std::vector<std::vector<SheetCell>> rows;
    for (const Failure& failure : failures) {
        const std::string name(failure.method->name);
        std::vector<SheetCell>& row = rows.emplace_back();
        add_run(row, rope, truth, failure.holds, {name + (failure.holds ? " holds" : " never holds"), blue},
                blue);
        add_run(row, rope, truth, failure.fails, {name + (failure.fails ? " fails" : " never fails"), orange},
                orange);
    }
    return contact_sheet(rows, cell_width, cell_width * scene.size[1] / scene.size[0],
                         Camera{scene.view.center, scene.view.height}, scene.background);
}

}  // namespace ropesim
