#pragma once

#include "render/gl.h"

#include <string>
#include <string_view>

namespace ropesim {

// A program of one vertex and one fragment shader, given as GLSL and the name that messages use.
// Throws std::runtime_error, "<name>.vert does not compile: <the GLSL log>", where it does not compile
// or link.
GLuint compile_program(const Gl& gl, const std::string& name, std::string_view vertex,
                       std::string_view fragment);

// The same from shaders/<name>.vert and shaders/<name>.frag, which are compiled into the library.
GLuint embedded_program(const Gl& gl, const std::string& name);

// Where a uniform of the program is set. Throws std::runtime_error where the program has none of this name.
GLint uniform(const Gl& gl, GLuint program, const char* name);

}  // namespace ropesim
