#version 330 core

uniform vec2 picture;  // width, height; pixels
uniform vec4 box;      // left, top, width, height of the words in the picture; pixels

void main() {
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);
    vec2 position = box.xy + corner * box.zw;
    gl_Position = vec4(2.0 * position / picture - 1.0, 0.0, 1.0);
}
