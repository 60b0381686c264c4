#pragma once

#include "scene/scene.h"

namespace ropesim {

// Numbers from `least` to `greatest`, or to below it.
struct Range {
    double least;
    double greatest;
    bool below = false;
};

// A text that must be the name of a method.
template <class Text>
struct MethodName {
    Text& name;
};

// Every key of a scene, once: with the member that holds it and the numbers it may be. A visitor has
//     field(key, member), field(key, member, range)
// and reads, writes or checks. The bounds are far beyond any picture's needs and far within what doubles,
// memory and OpenGL take.
inline constexpr Range coordinates{-1e9, 1e9};
inline constexpr Range positive{1e-12, 1e15};
inline constexpr Range pixels{0.0, 1000.0};
inline constexpr Range steps{1, 1'000'000};  // per frame
inline constexpr long most_ropes = 100'000;
inline constexpr long most_masses = 10'000'000;  // of all ropes together

template <class Visitor, class View>
void view_fields(Visitor& visitor, View& view) {
    visitor.field("center", view.center, coordinates);
    visitor.field("height", view.height, positive);
}

template <class Visitor, class Scene>
void clip_fields(Visitor& visitor, Scene& scene) {
    visitor.field("frames", scene.frames, Range{1, 10'000'000});
    visitor.field("steps_per_frame", scene.steps_per_frame, steps);
    visitor.field("frame_time", scene.frame_time, Range{1e-9, 1e9});
    visitor.field("size", scene.size, Range{1, 16'384});
    visitor.field("view", scene.view);
    visitor.field("background", scene.background);
    visitor.field("tolerance", scene.tolerance, Range{1e-9, 1e6});
    visitor.field("words", scene.words);
}

template <class Visitor, class Rope>
void rope_fields(Visitor& visitor, Rope& rope) {
    visitor.field("name", rope.name);
    visitor.field("method", MethodName{rope.method});
    visitor.field("start", rope.start, coordinates);
    visitor.field("via", rope.via, coordinates);
    visitor.field("end", rope.end, coordinates);
    visitor.field("nodes", rope.nodes, Range{2, 1'000'000});
    if (rope.masses.empty() || Visitor::reads) visitor.field("mass", rope.mass, positive);
    visitor.field("masses", rope.masses, positive);
    visitor.field("stiffness", rope.stiffness, positive);
    visitor.field("rest_length", rope.rest_length, positive);
    visitor.field("pinned", rope.pinned, Range{-1e6, 1e6});
    visitor.field("damping", rope.damping, Range{0.0, 1e6});
    visitor.field("damping_factor", rope.damping_factor, Range{0.0, 1.0, true});
    visitor.field("steps_per_frame", rope.steps_per_frame, steps);
    visitor.field("sweeps", rope.sweeps, Range{1, 1000});
    visitor.field("color", rope.color);
    visitor.field("line_width", rope.line_width, pixels);
    visitor.field("point_size", rope.point_size, pixels);
}

template <class Visitor, class Scene>
void scene_fields(Visitor& visitor, Scene& scene) {
    visitor.field("title", scene.title);
    visitor.field("gravity", scene.gravity, coordinates);
}

}  // namespace ropesim
