#include "render/context.h"

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace ropesim {
namespace {

struct Way {
    std::string_view name;  // in ROPESIM_CONTEXT
    std::unique_ptr<OffscreenContext> (*make)();
    std::string_view packages;
};

constexpr std::array ways = {
    Way{"osmesa", make_osmesa_context, "libosmesa6"},
    Way{"egl", make_egl_context, "libegl1 and libegl-mesa0"},
};

void append(std::string& list, std::string_view separator, std::string_view item) {
    if (!list.empty()) list += separator;
    list += item;
}

void check_known(std::string_view wanted) {
    std::string known;
    for (const Way& way : ways) {
        if (wanted == way.name) return;
        append(known, " or ", way.name);
    }
    throw std::runtime_error("ROPESIM_CONTEXT is '" + std::string(wanted) + "'; expected " + known);
}

}  // namespace

std::unique_ptr<OffscreenContext> make_context() {
    const char* wanted = std::getenv("ROPESIM_CONTEXT");
    if (wanted) check_known(wanted);
    // NOLINTNEXTLINE(concurrency-mt-unsafe): no other thread yet
    setenv("LP_NUM_THREADS", "0", /*overwrite=*/0);
    std::string failures;
    std::string packages;
    for (const Way& way : ways) {
        if (wanted && wanted != way.name) continue;
        try {
            return way.make();
        } catch (const std::runtime_error& error) {
            append(failures, "; ", std::string(way.name) + ": " + error.what());
            append(packages, ", or ", way.packages);
        }
    }
    throw std::runtime_error("no OpenGL 3.3 context could be made (" + failures +
                             "); install the Debian package " + packages);
}

}  // namespace ropesim
