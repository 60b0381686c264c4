#include "clip/want_of_memory.h"

#include <gtest/gtest.h>

#include <new>
#include <stdexcept>

namespace ropesim {
namespace {

TEST(WantOfMemory, IsToldFromOtherReasonsToEnd) {
    EXPECT_TRUE(is_want_of_memory(std::make_exception_ptr(std::bad_alloc())));
    EXPECT_TRUE(is_want_of_memory(std::make_exception_ptr(std::bad_array_new_length())));
    EXPECT_FALSE(is_want_of_memory(std::make_exception_ptr(std::runtime_error("out of memory"))));
    EXPECT_FALSE(is_want_of_memory(std::make_exception_ptr(1)));
    EXPECT_FALSE(is_want_of_memory(nullptr)) << "no exception at all";
}

}  // namespace
}  // namespace ropesim
