#include "render/shader.h"

#include <gmock/gmock.h>

#include <memory>
#include <stdexcept>
#include <string>
#include <string_view>

namespace ropesim {
namespace {

constexpr std::string_view vertex = "#version 330 core\nvoid main() { gl_Position = vec4(0.0); }\n";
constexpr std::string_view fragment = "#version 330 core\nout vec4 c;\nvoid main() { c = vec4(1.0); }\n";

std::string error_of(std::string_view vertex_source, std::string_view fragment_source) {
    const std::unique_ptr<OffscreenContext> context = make_context();
    try {
        compile_program(load_gl(*context), "test", vertex_source, fragment_source);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

TEST(CompileProgram, AcceptsShadersThatCompile) {
    EXPECT_EQ(error_of(vertex, fragment), "");
}

TEST(CompileProgram, ReportsTheLogOfAShaderThatDoesNot) {
    const std::string broken = "#version 330 core\nout vec4 c;\nvoid main() { c = colour; }\n";
    const std::string error = error_of(vertex, broken);
    EXPECT_THAT(error, testing::StartsWith("test.frag does not compile: "));
    EXPECT_THAT(error, testing::HasSubstr("0:3("));
    EXPECT_THAT(error, testing::HasSubstr("`colour' undeclared"));
    EXPECT_THAT(error, testing::Not(testing::HasSubstr("\n")));
    EXPECT_THAT(error_of("#version 330 core\nvoid main() { (; }", fragment),
                testing::StartsWith("test.vert does not compile: "));
}

TEST(CompileProgram, ReportsTheLogOfAProgramThatDoesNotLink) {
    const std::string gives_two =
        "#version 330 core\nout vec2 tint;\nvoid main() { tint = vec2(1.0); gl_Position = vec4(0.0); }\n";
    const std::string takes_three =
        "#version 330 core\nin vec3 tint;\nout vec4 c;\nvoid main() { c = tint.xyzz; }\n";
    const std::string error = error_of(gives_two, takes_three);
    EXPECT_THAT(error, testing::StartsWith("test does not link: "));
    EXPECT_THAT(error, testing::HasSubstr("tint"));
}

TEST(Uniform, ThatIsNotThereIsRefused) {
    const std::unique_ptr<OffscreenContext> context = make_context();
    const Gl gl = load_gl(*context);
    const GLuint program = compile_program(gl, "test", vertex, fragment);
    EXPECT_THROW(uniform(gl, program, "color"), std::runtime_error);
}

}  // namespace
}  // namespace ropesim
