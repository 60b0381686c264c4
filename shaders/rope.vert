#version 330 core

// A capsule: all points within `radius` of the segment. Pixels, from the picture's top left corner.
layout(location = 0) in vec4 segment;  // begin, end
layout(location = 1) in float radius;
layout(location = 2) in vec4 into;  // 1 in the channel of the framebuffer that the coverage goes to

uniform vec2 picture;  // width, height

flat out vec2 begin;
flat out vec2 along;             // end - begin
flat out float inverse_square;   // 1 / |along|^2, or 0 for a point
flat out float reach;            // distance at which coverage ends
flat out vec4 channel;

void main() {
    begin = segment.xy;
    along = segment.zw - segment.xy;
    float square = dot(along, along);
    bool point = square < 1e-8;
    inverse_square = point ? 0.0 : 1.0 / square;
    reach = radius + 0.5;
    channel = into;

    // One pixel more on every side than the capsule: the quad's own edges never decide on a pixel.
    float margin = reach + 0.5;
    vec2 direction = point ? vec2(1.0, 0.0) : along * inversesqrt(square);
    vec2 across = vec2(-direction.y, direction.x);
    vec2 corner = vec2(gl_VertexID & 1, gl_VertexID >> 1);  // 0 or 1 along, 0 or 1 across
    vec2 position = begin + corner.x * along + (2.0 * corner.x - 1.0) * margin * direction +
                    (2.0 * corner.y - 1.0) * margin * across;
    // The framebuffer's first row is the picture's top row, so y is not turned round.
    gl_Position = vec4(2.0 * position / picture - 1.0, 0.0, 1.0);
}
