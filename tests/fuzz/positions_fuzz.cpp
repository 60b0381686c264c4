// Positions, CSV or NumPy, are refused in one line of plain text, or read back from what is written of them.

#include "clip/positions.h"
#include "fuzz/target.h"

#include <stdexcept>

using namespace ropesim;

namespace {

Scene two_ropes() {
    Scene scene;
    scene.frames = 4;
    scene.ropes.resize(2);
    scene.ropes[0].name = "Euler";
    scene.ropes[0].nodes = 2;
    scene.ropes[1].name = "a \"rope\", quoted";
    scene.ropes[1].nodes = 3;
    return scene;
}

}  // namespace

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    static const Scene scene = two_ropes();
    try {
        const Positions positions =
            parse_positions(scene, {reinterpret_cast<const char*>(bytes), size}, "fuzz.csv");
        const std::string text = to_csv(scene, positions);
        if (to_csv(scene, parse_positions(scene, text, "again.csv")) != text)
            break_off("positions do not read back");
    } catch (const std::runtime_error& error) {
        require_plain(error.what());
    }
    return 0;
}
