#include "render/gl.h"

#include <stdexcept>
#include <string>

namespace ropesim {
namespace {

template <typename Function>
void load(Function*& function, const OffscreenContext& context, const char* name) {
    function = reinterpret_cast<Function*>(context.function(name));
    if (!function) throw std::runtime_error(std::string("the OpenGL driver has no function ") + name);
}

}  // namespace

Gl load_gl(const OffscreenContext& context) {
    Gl gl{};
    load(gl.GetError, context, "glGetError");
    load(gl.GetString, context, "glGetString");
    load(gl.GetIntegerv, context, "glGetIntegerv");
    load(gl.ReadPixels, context, "glReadPixels");
    load(gl.Viewport, context, "glViewport");
    load(gl.Enable, context, "glEnable");
    load(gl.ClearColor, context, "glClearColor");
    load(gl.Clear, context, "glClear");
    load(gl.BlendEquation, context, "glBlendEquation");
    load(gl.CreateShader, context, "glCreateShader");
    load(gl.ShaderSource, context, "glShaderSource");
    load(gl.CompileShader, context, "glCompileShader");
    load(gl.GetShaderiv, context, "glGetShaderiv");
    load(gl.GetShaderInfoLog, context, "glGetShaderInfoLog");
    load(gl.DeleteShader, context, "glDeleteShader");
    load(gl.CreateProgram, context, "glCreateProgram");
    load(gl.AttachShader, context, "glAttachShader");
    load(gl.LinkProgram, context, "glLinkProgram");
    load(gl.GetProgramiv, context, "glGetProgramiv");
    load(gl.GetProgramInfoLog, context, "glGetProgramInfoLog");
    load(gl.UseProgram, context, "glUseProgram");
    load(gl.GetUniformLocation, context, "glGetUniformLocation");
    load(gl.Uniform2f, context, "glUniform2f");
    load(gl.GenVertexArrays, context, "glGenVertexArrays");
    load(gl.BindVertexArray, context, "glBindVertexArray");
    load(gl.EnableVertexAttribArray, context, "glEnableVertexAttribArray");
    load(gl.VertexAttribPointer, context, "glVertexAttribPointer");
    load(gl.VertexAttribDivisor, context, "glVertexAttribDivisor");
    load(gl.GenBuffers, context, "glGenBuffers");
    load(gl.BindBuffer, context, "glBindBuffer");
    load(gl.BufferData, context, "glBufferData");
    load(gl.DrawArraysInstanced, context, "glDrawArraysInstanced");
    load(gl.GenRenderbuffers, context, "glGenRenderbuffers");
    load(gl.BindRenderbuffer, context, "glBindRenderbuffer");
    load(gl.RenderbufferStorage, context, "glRenderbufferStorage");
    load(gl.GenFramebuffers, context, "glGenFramebuffers");
    load(gl.BindFramebuffer, context, "glBindFramebuffer");
    load(gl.FramebufferRenderbuffer, context, "glFramebufferRenderbuffer");
    load(gl.BlitFramebuffer, context, "glBlitFramebuffer");
    load(gl.CheckFramebufferStatus, context, "glCheckFramebufferStatus");
    return gl;
}

}  // namespace ropesim
