#pragma once

#include "simulation/method.h"

#include <vector>

namespace ropesim {

// What a rope truly does: its model's equations of motion, solved without the methods and the forces of
// `simulation`, by Taylor series in long double (taylor_run.h), twice: the second run, looser and of another
// order, tells how far the first can be believed.
// The frames end where one of the two could not go on, as at a link whose length passes through zero.
struct Reference {
    std::vector<Points> frames;      // positions of frame 0 (the start), 1, 2, ...; world units, masses×2
    std::vector<Points> velocities;  // world units per unit of time, masses×2

    // Of each frame, world units: greatest distance of any mass in the second run, an estimate from above of
    // what the positions are wrong by, where long double is the 80 bits of x86 (on the seed's rope, where a
    // run in 113 bits found 5e-11 at t = 120, it says 4e-11; up to t = 60 both are double's last digit).
    std::vector<double> error;
};

// The motion from rest over `frames` frames, frame 0 included. Damping is the rope's rate.
// Throws std::runtime_error where the model has no motion to give: a link of length zero; for the
// inextensible one, a link that does not start at its rest length (to 1e-12 of it), or two or more links
// between two pins that lie on one line (to 1e-6 radians), where their tensions are not determined.
Reference reference(const Rope& rope, Model model, double frame_time, long frames);

// Of each frame, world units: greatest distance of any mass in a run by SUNDIALS in double (sundials_run.h),
// which for an inextensible rope is in other coordinates too; shorter where that could not go on. It says
// that the equations are right; its size is the rounding of double as the motion magnifies it, which no
// method in double escapes.
std::vector<double> confirmation(const Reference& reference, const Rope& rope, Model model,
                                 double frame_time);

// How many frames from the first on can be believed: those before the first whose error is above `bound`,
// world units.
long believed_frames(const Reference& reference, double bound);

}  // namespace ropesim
