#pragma once

#include "simulation/method.h"

// The functions behind the rows of the table; each is documented in the file of its name.
namespace ropesim {

Advance explicit_euler;
Advance symplectic_euler;
Advance stormer_verlet;
Advance constraint_projection;
Advance seed_verlet;
Advance seed_constraints;

Stable explicit_euler_stable;
Stable symplectic_euler_stable;
Stable stormer_verlet_stable;

}  // namespace ropesim
