#include "clip/want_of_memory.h"

#include <new>

namespace ropesim {

bool is_want_of_memory(const std::exception_ptr& error) {
    if (!error) return false;
    try {
        std::rethrow_exception(error);
    } catch (const std::bad_alloc&) {
        return true;
    } catch (...) {
        return false;
    }
}

}  // namespace ropesim
