#include "render/context.h"

#include <malloc.h>
#include <sys/mman.h>
#include <sys/resource.h>

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

// Has malloc lay its next blocks in pages of 2 MB, where Linux has them for the asking: LLVM and framebuffers
// touch some 16 MB as they start, and in pages of 4 KB that takes 48 ms more, of 157. The reserve is address
// space, and memory only where it is touched; it must be less than what malloc maps apart.
void use_large_pages() {
    constexpr std::uintptr_t page = 2 << 20;
    constexpr std::size_t reserve = 15 * page;
    // NOLINTBEGIN(concurrency-mt-unsafe): no other thread yet
    mallopt(M_MMAP_THRESHOLD, 16 * page);  // the most that can be set
    mallopt(M_TRIM_THRESHOLD, 16 * page);  // or the reserve would be given back at once
    // NOLINTEND(concurrency-mt-unsafe)
    void* const block = std::malloc(reserve);
    const auto begin = reinterpret_cast<std::uintptr_t>(block);
    const std::uintptr_t first = (begin + page - 1) / page * page;
    if (block) madvise(reinterpret_cast<void*>(first), begin + reserve - first, MADV_HUGEPAGE);
    std::free(block);
}

bool set_up_process() {
    use_large_pages();
    // NOLINTBEGIN(concurrency-mt-unsafe): no other thread yet
    setenv("LP_NUM_THREADS", "0", /*overwrite=*/0);
    setenv("EGL_LOG_LEVEL", "fatal", /*overwrite=*/0);  // or a failure here would be told in many lines
    // NOLINTEND(concurrency-mt-unsafe)
    return true;
}

// What would help. The loader does not say so where it is memory that it lacks.
std::string advice(const std::string& packages) {
    constexpr rlim_t needed = 300 << 20;
    rlimit addresses{};
    if (::getrlimit(RLIMIT_AS, &addresses) == 0 && addresses.rlim_cur < needed)
        return "it needs 300 MB of memory, and ulimit -v allows " + std::to_string(addresses.rlim_cur >> 20) +
               " MB";
    return "install the Debian package " + packages;
}

}  // namespace

std::unique_ptr<OffscreenContext> make_context() {
    const char* wanted = std::getenv("ROPESIM_CONTEXT");
    if (wanted) check_known(wanted);
    [[maybe_unused]] static const bool is_set_up = set_up_process();
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
    throw std::runtime_error("no OpenGL 3.3 context could be made (" + failures + "); " + advice(packages));
}

}  // namespace ropesim
