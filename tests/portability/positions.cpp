// Prints all positions of every built-in scene, and of a rope moved by every method.
#include "clip/csv.h"
#include "clip/run.h"
#include "simulation/motion.h"

#include <cstdio>

using namespace ropesim;

namespace {

// scene,frame,rope,node,x,y
std::string lines(const std::string& scene, long frame, const Run& run, const Points& points) {
    std::string text;
    for (Eigen::Index node = 0; node < points.rows(); ++node) {
        text += scene + ',' + std::to_string(frame) + ',' + quoted(run.description->name) + ',' +
                std::to_string(node) + ',';
        append_number(text, points(node, 0));
        append_number(text += ',', points(node, 1));
        text += '\n';
    }
    return text;
}

}  // namespace

int main() {
    for (const BuiltinScene& builtin : builtin_scenes()) {
        const std::string name(builtin.name);
        const Scene scene = parse_scene(builtin.toml, name);
        const std::vector<Run> ropes = runs(scene);
        const std::vector<Trajectory> trajectories = simulate(scene, ropes);
        for (std::size_t rope = 0; rope < ropes.size(); ++rope)
            for (std::size_t frame = 0; frame < trajectories[rope].frames.size(); ++frame)
                std::fputs(
                    lines(name, static_cast<long>(frame), ropes[rope], trajectories[rope].frames[frame])
                        .c_str(),
                    stdout);
    }
    for (const Method& method : methods()) std::fputs(motion(method).c_str(), stdout);
}
