#version 330 core

flat in vec2 begin;
flat in vec2 along;
flat in float inverse_square;
flat in float reach;
flat in vec4 channel;

out vec4 coverage;

// How much of the pixel the capsule covers.
void main() {
    vec2 from_begin = gl_FragCoord.xy - begin;
    float nearest = clamp(dot(from_begin, along) * inverse_square, 0.0, 1.0);
    float distance_to_segment = length(from_begin - nearest * along);
    coverage = clamp(reach - distance_to_segment, 0.0, 1.0) * channel;
}
