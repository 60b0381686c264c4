#pragma once

#include <memory>
#include <string_view>

namespace ropesim {

// An OpenGL 3.3 core context without a window, current in the thread that made it.
// It has no usable framebuffer of its own: draw into a framebuffer object.
class OffscreenContext {
  public:
    virtual ~OffscreenContext() = default;

    // Makes it current again, where another context has been made or destroyed since.
    virtual void make_current() = 0;

    // How it was made: "OSMesa" or "EGL".
    virtual std::string_view kind() const = 0;

    // The address of an OpenGL function; null where there is none of this name.
    virtual void* function(const char* name) const = 0;
};

// By Mesa's library for drawing into memory, libOSMesa.so.8. Throws std::runtime_error.
std::unique_ptr<OffscreenContext> make_osmesa_context();

// By EGL on Mesa's surfaceless platform, drawing on the processor. Throws std::runtime_error.
std::unique_ptr<OffscreenContext> make_egl_context();

// By OSMesa, else by EGL; or by the one that the environment variable ROPESIM_CONTEXT names, "osmesa" or
// "egl". Throws std::runtime_error where the variable is another word, or where no context can be made:
// the message names what was tried and the Debian packages to install.
//
// The first also has malloc take large pages, and sets LP_NUM_THREADS=0 in the environment unless it is set:
// llvmpipe's own threads make a small picture three times slower.
std::unique_ptr<OffscreenContext> make_context();

}  // namespace ropesim
