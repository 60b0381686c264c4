#include "render/shader.h"

#include "embedded_shaders.h"

#include <stdexcept>

namespace ropesim {
namespace {

// A driver's log on one line.
std::string one_line(std::string log) {
    while (!log.empty() && (log.back() == '\0' || log.back() == '\n')) log.pop_back();
    for (std::size_t at = log.find('\n'); at != std::string::npos; at = log.find('\n', at)) {
        log.replace(at, 1, "; ");
    }
    return log;
}

std::string shader_log(const Gl& gl, GLuint shader) {
    GLint length = 0;
    gl.GetShaderiv(shader, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    gl.GetShaderInfoLog(shader, length, nullptr, log.data());
    return one_line(log);
}

std::string program_log(const Gl& gl, GLuint program) {
    GLint length = 0;
    gl.GetProgramiv(program, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length), '\0');
    gl.GetProgramInfoLog(program, length, nullptr, log.data());
    return one_line(log);
}

GLuint compile_shader(const Gl& gl, GLenum stage, const std::string& name, std::string_view source) {
    const GLuint shader = gl.CreateShader(stage);
    const char* text = source.data();
    const auto length = static_cast<GLint>(source.size());
    gl.ShaderSource(shader, 1, &text, &length);
    gl.CompileShader(shader);
    GLint compiled = GL_FALSE;
    gl.GetShaderiv(shader, GL_COMPILE_STATUS, &compiled);
    if (!compiled) throw std::runtime_error(name + " does not compile: " + shader_log(gl, shader));
    return shader;
}

std::string_view embedded_source(const std::string& name) {
    for (const auto& [file, source] : embedded_shaders()) {
        if (file == name) return source;
    }
    throw std::runtime_error("no shader " + name + " was compiled in");
}

}  // namespace

GLuint compile_program(const Gl& gl, const std::string& name, std::string_view vertex,
                       std::string_view fragment) {
    const GLuint program = gl.CreateProgram();
    for (const GLuint shader : {compile_shader(gl, GL_VERTEX_SHADER, name + ".vert", vertex),
                                compile_shader(gl, GL_FRAGMENT_SHADER, name + ".frag", fragment)}) {
        gl.AttachShader(program, shader);
        gl.DeleteShader(shader);
    }
    gl.LinkProgram(program);
    GLint linked = GL_FALSE;
    gl.GetProgramiv(program, GL_LINK_STATUS, &linked);
    if (!linked) throw std::runtime_error(name + " does not link: " + program_log(gl, program));
    return program;
}

GLuint embedded_program(const Gl& gl, const std::string& name) {
    return compile_program(gl, name, embedded_source(name + ".vert"), embedded_source(name + ".frag"));
}

GLint uniform(const Gl& gl, GLuint program, const char* name) {
    const GLint location = gl.GetUniformLocation(program, name);
    if (location < 0) throw std::runtime_error(std::string("a shader has no uniform ") + name);
    return location;
}

}  // namespace ropesim
