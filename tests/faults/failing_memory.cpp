// There is no memory, once, at the place of number ROPESIM_FAULT_PLACE in the program where some is taken, in
// the order in which they are reached; what libraries take that it is linked with counts as taken by the
// place that called them.

#include "faults/fault_shim.h"

#include <link.h>
#include <unwind.h>

#include <algorithm>
#include <array>
#include <atomic>
#include <cstdint>
#include <cstdio>
#include <new>

namespace {

using fault::real;

long fail_at_place = 0;
bool in_main = false;  // what fails before it, nobody could catch
int (*program_main)(int, char**, char**) = nullptr;

// Where the code of an object lies.
struct Object {
    std::uintptr_t begin = UINTPTR_MAX;
    std::uintptr_t end = 0;

    bool has(std::uintptr_t address) const { return begin <= address && address < end; }
};

// The program, and the libraries that it is linked with. Those that are loaded later keep their memory, and
// so does the one that unwinds the stack: we need it to see whose memory it is.
std::array<Object, 64> objects;
std::size_t object_count = 0;

int add_object(dl_phdr_info* info, std::size_t, void*) {
    if (std::strstr(info->dlpi_name, "libgcc_s")) return 0;
    Object& object = objects[object_count++];
    for (int i = 0; i < info->dlpi_phnum; ++i) {
        if (info->dlpi_phdr[i].p_type != PT_LOAD) continue;
        const std::uintptr_t begin = info->dlpi_addr + info->dlpi_phdr[i].p_vaddr;
        if (begin < object.begin) object.begin = begin;
        if (begin + info->dlpi_phdr[i].p_memsz > object.end) object.end = begin + info->dlpi_phdr[i].p_memsz;
    }
    return object_count == objects.size() ? 1 : 0;
}

__attribute__((constructor)) void begin() {
    if (!fault::is_in_ropesim()) return;
    dl_iterate_phdr(add_object, nullptr);
    fail_at_place = fault::number_in("ROPESIM_FAULT_PLACE");
}

int counted_main(int count, char** arguments, char** environment) {
    in_main = true;
    const int status = program_main(count, arguments, environment);
    in_main = false;
    return status;
}

const Object* object_with(std::uintptr_t address) {
    const auto end = objects.begin() + object_count;
    const auto found =
        std::find_if(objects.begin(), end, [&](const Object& each) { return each.has(address); });
    return found == end ? nullptr : &*found;
}

// Looks at the callers one by one, the nearest first.
_Unwind_Reason_Code look(_Unwind_Context* context, void* place) {
    const std::uintptr_t address = _Unwind_GetIP(context);
    const Object* const object = object_with(address);
    if (!object) return _URC_END_OF_STACK;
    if (object != &objects.front()) return _URC_NO_REASON;
    *static_cast<std::uintptr_t*>(place) = address - object->begin;
    return _URC_END_OF_STACK;
}

// Adds it to those that were reached; its number where it is new, else 0.
long number_of_new(std::uintptr_t place) {
    static std::atomic_flag busy;
    static std::array<std::uintptr_t, 1 << 16> reached;
    static long count = 0;
    while (busy.test_and_set()) {
    }
    const auto end = reached.begin() + count;
    const bool is_new = std::find(reached.begin(), end, place) == end && end != reached.end();
    if (is_new) reached[static_cast<std::size_t>(count++)] = place;
    const long number = is_new ? count : 0;
    busy.clear();
    return number;
}

bool has_no_memory(const void* caller) {
    if (!in_main || fail_at_place == 0) return false;
    if (!object_with(reinterpret_cast<std::uintptr_t>(caller))) return false;
    std::uintptr_t place = 0;
    _Unwind_Backtrace(look, &place);
    if (place == 0 || number_of_new(place) != fail_at_place) return false;
    std::array<char, 64> text;
    std::snprintf(text.data(), text.size(), "memory at %#lx", place);
    fault::mark(text.data());
    errno = ENOMEM;
    return true;
}

}  // namespace

extern "C" {

int __libc_start_main(int (*start)(int, char**, char**), int count, char** arguments, void (*init)(),
                      void (*fini)(), void (*loader_fini)(), void* stack_end) {
    program_main = start;
    using Start =
        int (*)(int (*)(int, char**, char**), int, char**, void (*)(), void (*)(), void (*)(), void*);
    return real<Start>("__libc_start_main")(counted_main, count, arguments, init, fini, loader_fini,
                                            stack_end);
}

void* malloc(std::size_t size) {
    static const auto next = real<void* (*)(std::size_t)>("malloc");
    return has_no_memory(__builtin_return_address(0)) ? nullptr : next(size);
}

void* calloc(std::size_t count, std::size_t size) {
    static const auto next = real<void* (*)(std::size_t, std::size_t)>("calloc");
    return has_no_memory(__builtin_return_address(0)) ? nullptr : next(count, size);
}

void* realloc(void* block, std::size_t size) {
    static const auto next = real<void* (*)(void*, std::size_t)>("realloc");
    return has_no_memory(__builtin_return_address(0)) ? nullptr : next(block, size);
}

void* aligned_alloc(std::size_t alignment, std::size_t size) {
    static const auto next = real<void* (*)(std::size_t, std::size_t)>("aligned_alloc");
    return has_no_memory(__builtin_return_address(0)) ? nullptr : next(alignment, size);
}

int posix_memalign(void** block, std::size_t alignment, std::size_t size) {
    static const auto next = real<int (*)(void**, std::size_t, std::size_t)>("posix_memalign");
    return has_no_memory(__builtin_return_address(0)) ? ENOMEM : next(block, alignment, size);
}

}  // extern "C"

#ifdef ROPESIM_SANITIZED
// The sanitizer's own would not ask malloc.
namespace {

void* allocated(std::size_t size) {
    void* memory = std::malloc(size == 0 ? 1 : size);
    if (!memory) throw std::bad_alloc();
    return memory;
}

}  // namespace

void* operator new(std::size_t size) {
    return allocated(size);
}
void* operator new[](std::size_t size) {
    return allocated(size);
}
void operator delete(void* memory) noexcept {
    std::free(memory);
}
void operator delete[](void* memory) noexcept {
    std::free(memory);
}
void operator delete(void* memory, std::size_t) noexcept {
    std::free(memory);
}
void operator delete[](void* memory, std::size_t) noexcept {
    std::free(memory);
}
#endif
