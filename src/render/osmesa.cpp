#include "render/context.h"
#include "render/shared_library.h"

#include <GL/glcorearb.h>

#include <array>
#include <stdexcept>

#ifdef __SANITIZE_ADDRESS__
// Read by the leak sanitizer. OSMesa keeps a few hundred bytes of every context that is destroyed. And where
// the thread-local block of a library that is loaded late starts 16 bytes into a page, which is one case in
// 256, GCC 12's takes it for one of glibc 2.19 and reads at an address that is none: it is not to follow
// those blocks.
extern "C" const char* __lsan_default_suppressions();
extern "C" const char* __lsan_default_suppressions() {
    return "leak:libOSMesa.so\n";
}
extern "C" const char* __lsan_default_options();
extern "C" const char* __lsan_default_options() {
    return "print_suppressions=0:intercept_tls_get_addr=0";
}
#endif

namespace ropesim {
namespace {

// From GL/osmesa.h, which distributions without OSMesa do not have.
constexpr int osmesa_format = 0x22;
constexpr int osmesa_profile = 0x33;
constexpr int osmesa_core_profile = 0x34;
constexpr int osmesa_context_major_version = 0x36;
constexpr int osmesa_context_minor_version = 0x37;

struct OsmesaFunctions {
    void* (*create)(const int* attributes, void* shared);
    unsigned char (*make_current)(void* context, void* buffer, unsigned type, int width, int height);
    void (*destroy)(void* context);
    void* (*function)(const char* name);
};

OsmesaFunctions load_osmesa() {
    const SharedLibrary library("libOSMesa.so.8");
    OsmesaFunctions osmesa{};
    library.load(osmesa.create, "OSMesaCreateContextAttribs");
    library.load(osmesa.make_current, "OSMesaMakeCurrent");
    library.load(osmesa.destroy, "OSMesaDestroyContext");
    library.load(osmesa.function, "OSMesaGetProcAddress");
    return osmesa;
}

class OsmesaContext final : public OffscreenContext {
  public:
    OsmesaContext() : osmesa_(load_osmesa()) {
        const std::array attributes = {osmesa_format,
                                       GL_RGBA,
                                       osmesa_profile,
                                       osmesa_core_profile,
                                       osmesa_context_major_version,
                                       3,
                                       osmesa_context_minor_version,
                                       3,
                                       0};
        context_ = osmesa_.create(attributes.data(), nullptr);
        if (!context_) throw std::runtime_error("libOSMesa.so.8 makes no OpenGL 3.3 core context");
        try {
            make_current();
        } catch (...) {
            osmesa_.destroy(context_);
            throw;
        }
    }
    ~OsmesaContext() override {
        osmesa_.make_current(nullptr, nullptr, 0, 0, 0);
        osmesa_.destroy(context_);
    }
    OsmesaContext(const OsmesaContext&) = delete;
    OsmesaContext& operator=(const OsmesaContext&) = delete;

    void make_current() override {
        if (!osmesa_.make_current(context_, buffer_.data(), GL_UNSIGNED_BYTE, buffer_side, buffer_side)) {
            throw std::runtime_error("libOSMesa.so.8 does not make its context current");
        }
    }
    std::string_view kind() const override { return "OSMesa"; }
    void* function(const char* name) const override { return osmesa_.function(name); }

  private:
    // A context is current with a buffer, though nothing is ever drawn into it.
    static constexpr int buffer_side = 4;

    OsmesaFunctions osmesa_;
    void* context_ = nullptr;
    std::array<unsigned char, std::size_t{4} * buffer_side * buffer_side> buffer_{};
};

}  // namespace

std::unique_ptr<OffscreenContext> make_osmesa_context() {
    return std::make_unique<OsmesaContext>();
}

}  // namespace ropesim
