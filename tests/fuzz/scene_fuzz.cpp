// A scene file is refused in one line of plain text, or reads back from what is written of it.

#include "fuzz/target.h"
#include "scene/scene.h"

#include <stdexcept>

using namespace ropesim;

int LLVMFuzzerTestOneInput(const std::uint8_t* bytes, std::size_t size) {
    try {
        const Scene scene = parse_scene({reinterpret_cast<const char*>(bytes), size}, "fuzz.toml");
        if (parse_scene(to_toml(scene), "again.toml") != scene) break_off("a scene does not read back");
    } catch (const std::runtime_error& error) {
        require_plain(error.what());
    }
    return 0;
}
