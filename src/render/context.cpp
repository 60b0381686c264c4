#include "render/context.h"

#include <malloc.h>
#include <sys/mman.h>

#include <array>
#include <cstdint>
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

// Has malloc lay its next blocks in pages of 2 MB, where the kernel has them for the asking. LLVM and the
// framebuffers of 1280 x 720 touch 16 MB as they start; in pages of 4 KB that was a third of the start.
void use_large_pages() {
    constexpr std::uintptr_t page = 2 << 20;
    constexpr std::size_t reserve = 15 * page;  // taken from the kernel only where it is touched
    mallopt(M_MMAP_THRESHOLD, 16 * page);       // the most that it lets one set
    mallopt(M_TRIM_THRESHOLD, 32 * page);
    void* const block = std::malloc(reserve);
    const auto begin = reinterpret_cast<std::uintptr_t>(block);
    const std::uintptr_t first = (begin + page - 1) / page * page;
    if (block) madvise(reinterpret_cast<void*>(first), begin + reserve - first, MADV_HUGEPAGE);
    std::free(block);
}

}  // namespace

std::unique_ptr<OffscreenContext> make_context() {
    const char* wanted = std::getenv("ROPESIM_CONTEXT");
    if (wanted) check_known(wanted);
    use_large_pages();
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
