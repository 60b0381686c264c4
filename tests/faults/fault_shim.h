#pragma once

#include <dlfcn.h>
#include <fcntl.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <cerrno>
#include <cstdlib>
#include <cstring>

// A library that is loaded ahead of the C library (LD_PRELOAD) and makes one call of ropesim fail, to see
// what it makes of it: one that concerns files or processes (failing_calls.cpp), or one that takes memory
// (failing_memory.cpp). What is to fail, variables of the environment say. Helpers count for themselves.
namespace fault {

// Not in programs that ropesim runs.
inline bool is_in_ropesim() {
    return std::strcmp(program_invocation_short_name, "ropesim") == 0;
}

inline long number_in(const char* variable) {
    const char* text = std::getenv(variable);
    return text ? std::strtol(text, nullptr, 10) : 0;
}

// The function of that name that ours stands in front of.
template <class Function>
Function real(const char* name) {
    return reinterpret_cast<Function>(dlsym(RTLD_NEXT, name));
}

// The file ROPESIM_FAULT_MARK names what has failed. Without calls that would be counted.
inline void mark(const char* what) {
    const char* path = std::getenv("ROPESIM_FAULT_MARK");
    if (!path) return;
    const long file = syscall(SYS_openat, AT_FDCWD, path, O_WRONLY | O_CREAT | O_APPEND, 0600);
    syscall(SYS_write, file, what, std::strlen(what));
    syscall(SYS_write, file, "\n", 1);
    syscall(SYS_close, file);
}

}  // namespace fault
