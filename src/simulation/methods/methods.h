#pragma once

#include "simulation/method.h"

// The functions behind the rows of the table; each is documented in the file of its name.
namespace ropesim {

Advance explicit_euler;
LeapsOf symplectic_euler;
LeapsOf stormer_verlet;
Advance backward_euler;
Advance implicit_midpoint;
Advance runge_kutta_4;
LeapsOf blanes_moan_4;
LeapsOf blanes_moan_6;
Advance xpbd;
Advance constraint_projection;
Advance direct_projection;
LeapsOf seed_verlet;
Advance seed_constraints;

Stable explicit_euler_stable;
Stable symplectic_euler_stable;
Stable stormer_verlet_stable;
Stable runge_kutta_4_stable;
Stable blanes_moan_4_stable;
Stable blanes_moan_6_stable;

}  // namespace ropesim
