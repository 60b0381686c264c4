#include "render/context.h"

#include "render/renderer.h"

#include <gmock/gmock.h>

#include <cstdlib>
#include <iostream>
#include <optional>
#include <stdexcept>
#include <string>
#include <vector>

namespace ropesim {
namespace {

// An environment variable that has a value until the end of the block.
class Setting {
  public:
    Setting(const char* name, const char* value) : name_(name) {
        if (const char* before = std::getenv(name)) before_ = before;
        setenv(name, value, /*overwrite=*/1);
    }
    ~Setting() {
        if (before_) {
            setenv(name_, before_->c_str(), /*overwrite=*/1);
        } else {
            unsetenv(name_);
        }
    }
    Setting(const Setting&) = delete;
    Setting& operator=(const Setting&) = delete;

  private:
    const char* name_;
    std::optional<std::string> before_;
};

std::string error_of_making() {
    try {
        make_context();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

// Why a context of this kind cannot be made here; nothing where it can.
std::string missing(const char* kind) {
    const Setting setting("ROPESIM_CONTEXT", kind);
    return error_of_making();
}

struct Pictures {
    std::string description;
    std::vector<Image> images;
};

// Ropes that cross each other, themselves and the words, at many angles.
Pictures pictures(const char* kind) {
    const Setting setting("ROPESIM_CONTEXT", kind);
    const std::vector<Words> words = {{"Rope Simulator", {255, 255, 255}}, {"Verlet", {0, 255, 0}}};
    Renderer renderer(320, 200, {{0.0, 0.0}, 2.0}, {20, 30, 40}, words);
    Pictures pictures{renderer.description(), {}};
    for (int frame = 0; frame < 10; ++frame) {
        std::vector<Polyline> ropes(3);
        for (int rope = 0; rope < 3; ++rope) {
            Eigen::ArrayX2d& points = ropes[static_cast<std::size_t>(rope)].points;
            points.resize(16, 2);
            for (int i = 0; i < 16; ++i) {
                points(i, 0) = 0.01 * ((i * 37 + frame * 11 + rope * 5) % 300 - 150);
                points(i, 1) = 0.01 * ((i * 53 + frame * 17 + rope * 71) % 200 - 100);
            }
        }
        ropes[1].color = {0, 0, 255};
        ropes[2].color = {200, 100, 3};
        pictures.images.push_back(renderer.draw(ropes));
    }
    return pictures;
}

TEST(Contexts, DrawTheSamePixels) {
    for (const char* kind : {"osmesa", "egl"}) {
        if (const std::string reason = missing(kind); !reason.empty()) GTEST_SKIP() << reason;
    }
    const Pictures osmesa = pictures("osmesa");
    const Pictures egl = pictures("egl");
    EXPECT_THAT(osmesa.description, testing::StartsWith("OSMesa "));
    EXPECT_THAT(egl.description, testing::StartsWith("EGL "));
    EXPECT_THAT(osmesa.description, testing::HasSubstr("OpenGL "));
    EXPECT_TRUE(osmesa.images == egl.images);
}

TEST(Contexts, OfAnotherNameAreRefused) {
    const Setting setting("ROPESIM_CONTEXT", "glx");
    EXPECT_EQ(error_of_making(), "ROPESIM_CONTEXT is 'glx'; expected osmesa or egl");
}

// In a process of its own, since libEGL looks for drivers once.
TEST(ContextsDeathTest, ThatCannotBeMadeNameWhatToInstall) {
    testing::GTEST_FLAG(death_test_style) = "threadsafe";
    const auto tell_without_drivers = [] {
        setenv("ROPESIM_CONTEXT", "egl", /*overwrite=*/1);
        setenv("__EGL_VENDOR_LIBRARY_FILENAMES", "/nonexistent", /*overwrite=*/1);
        std::cerr << error_of_making();
        std::exit(0);
    };
    EXPECT_EXIT(tell_without_drivers(), testing::ExitedWithCode(0),
                testing::AllOf(testing::HasSubstr("no OpenGL 3.3 context could be made (egl: libEGL.so.1"),
                               testing::HasSubstr("); install the Debian package libegl1 and libegl-mesa0")));
}

TEST(Contexts, CanBeMadeOneAfterTheOther) {
    for (int i = 0; i < 3; ++i) EXPECT_NE(make_context()->function("glClear"), nullptr);
}

TEST(Contexts, HaveNoThreadsUnlessAskedFor) {
    make_context();
    EXPECT_STREQ(std::getenv("LP_NUM_THREADS"), "0");
}

}  // namespace
}  // namespace ropesim
