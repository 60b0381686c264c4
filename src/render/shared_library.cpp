#include "render/shared_library.h"

#include <dlfcn.h>

#include <stdexcept>

namespace ropesim {

SharedLibrary::SharedLibrary(const char* name) : handle_(dlopen(name, RTLD_NOW | RTLD_LOCAL)) {
    if (!handle_) throw std::runtime_error(dlerror());
}

void* SharedLibrary::address(const char* name) const {
    void* found = dlsym(handle_, name);
    if (!found) throw std::runtime_error(dlerror());
    return found;
}

}  // namespace ropesim
