#include "render/context.h"
#include "render/shared_library.h"

#include <EGL/egl.h>
#include <EGL/eglext.h>

#include <array>
#include <cstdlib>
#include <stdexcept>
#include <string>

namespace ropesim {
namespace {

struct EglFunctions {
    PFNEGLGETPLATFORMDISPLAYPROC get_platform_display;
    PFNEGLINITIALIZEPROC initialize;
    PFNEGLQUERYSTRINGPROC query_string;
    PFNEGLBINDAPIPROC bind_api;
    PFNEGLCREATECONTEXTPROC create_context;
    PFNEGLDESTROYCONTEXTPROC destroy_context;
    PFNEGLMAKECURRENTPROC make_current;
    PFNEGLGETPROCADDRESSPROC function;
    PFNEGLGETERRORPROC error;
};

EglFunctions load_egl() {
    const SharedLibrary library("libEGL.so.1");
    EglFunctions egl{};
    library.load(egl.get_platform_display, "eglGetPlatformDisplay");
    library.load(egl.initialize, "eglInitialize");
    library.load(egl.query_string, "eglQueryString");
    library.load(egl.bind_api, "eglBindAPI");
    library.load(egl.create_context, "eglCreateContext");
    library.load(egl.destroy_context, "eglDestroyContext");
    library.load(egl.make_current, "eglMakeCurrent");
    library.load(egl.function, "eglGetProcAddress");
    library.load(egl.error, "eglGetError");
    return egl;
}

class EglContext final : public OffscreenContext {
  public:
    EglContext() : egl_(load_egl()) {
        // The same driver as OSMesa's, llvmpipe, also where there is a graphics card; unless the user has set
        // it. NOLINTNEXTLINE(concurrency-mt-unsafe): no other thread yet
        setenv("LIBGL_ALWAYS_SOFTWARE", "1", /*overwrite=*/0);
        open_display();
        open_context();
    }
    // The display stays open: all of a process's contexts share it.
    ~EglContext() override { destroy(); }
    EglContext(const EglContext&) = delete;
    EglContext& operator=(const EglContext&) = delete;

    void make_current() override {
        if (!egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, context_)) {
            fail("does not make its context current");
        }
    }
    std::string_view kind() const override { return "EGL"; }
    void* function(const char* name) const override { return reinterpret_cast<void*>(egl_.function(name)); }

  private:
    void open_display() {
        const char* extensions = egl_.query_string(EGL_NO_DISPLAY, EGL_EXTENSIONS);
        if (!extensions ||
            std::string_view(extensions).find("EGL_MESA_platform_surfaceless") == std::string_view::npos) {
            throw std::runtime_error("libEGL.so.1 has no driver with EGL_MESA_platform_surfaceless");
        }
        display_ = egl_.get_platform_display(EGL_PLATFORM_SURFACELESS_MESA, EGL_DEFAULT_DISPLAY, nullptr);
        if (display_ == EGL_NO_DISPLAY || !egl_.initialize(display_, nullptr, nullptr)) {
            fail("opens no surfaceless display");
        }
    }

    void open_context() {
        const std::array<EGLint, 7> attributes = {EGL_CONTEXT_MAJOR_VERSION,
                                                  3,
                                                  EGL_CONTEXT_MINOR_VERSION,
                                                  3,
                                                  EGL_CONTEXT_OPENGL_PROFILE_MASK,
                                                  EGL_CONTEXT_OPENGL_CORE_PROFILE_BIT,
                                                  EGL_NONE};
        if (!egl_.bind_api(EGL_OPENGL_API)) fail("has no desktop OpenGL");
        context_ = egl_.create_context(display_, EGL_NO_CONFIG_KHR, EGL_NO_CONTEXT, attributes.data());
        if (context_ == EGL_NO_CONTEXT) fail("makes no OpenGL 3.3 core context");
        try {
            make_current();
        } catch (...) {
            destroy();
            throw;
        }
    }

    void destroy() const {
        egl_.make_current(display_, EGL_NO_SURFACE, EGL_NO_SURFACE, EGL_NO_CONTEXT);
        egl_.destroy_context(display_, context_);
    }

    [[noreturn]] void fail(const std::string& what) const {
        throw std::runtime_error("libEGL.so.1 " + what + ", EGL error " + std::to_string(egl_.error()));
    }

    EglFunctions egl_;
    EGLDisplay display_ = EGL_NO_DISPLAY;
    EGLContext context_ = EGL_NO_CONTEXT;
};

}  // namespace

std::unique_ptr<OffscreenContext> make_egl_context() {
    return std::make_unique<EglContext>();
}

}  // namespace ropesim
