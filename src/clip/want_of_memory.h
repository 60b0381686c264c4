#pragma once

#include <exception>
#include <string_view>

namespace ropesim {

// What is said of std::bad_alloc.
inline constexpr std::string_view want_of_memory = "out of memory";

// Whether it holds a std::bad_alloc: memory can run out where an exception may not pass, and std::terminate
// is called.
bool is_want_of_memory(const std::exception_ptr& error);

}  // namespace ropesim
