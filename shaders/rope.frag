#version 330 core

flat in vec2 begin;
flat in vec2 along;
flat in float inverse_square;
flat in float reach;

uniform vec3 color;

out vec4 fragment;

// The rope's colour, and as alpha how much of the pixel the capsule covers.
void main() {
    vec2 from_begin = gl_FragCoord.xy - begin;
    float nearest = clamp(dot(from_begin, along) * inverse_square, 0.0, 1.0);
    float distance_to_segment = length(from_begin - nearest * along);
    fragment = vec4(color, clamp(reach - distance_to_segment, 0.0, 1.0));
}
