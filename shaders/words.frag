#version 330 core

uniform sampler2D glyphs;  // coverage of each line of words, one below the other
uniform ivec2 offset;      // from a pixel of the picture to its texel
uniform vec3 color;

out vec4 fragment;

void main() {
    fragment = vec4(color, texelFetch(glyphs, ivec2(gl_FragCoord.xy) + offset, 0).r);
}
