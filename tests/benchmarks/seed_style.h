#pragma once

#include <memory>
#include <vector>

namespace ropesim {

// The assignment's rope in the assignment's own way, as its skeleton has it: masses and springs are objects
// on the heap that point to each other, every spring adds its force to both of its masses, symplectic Euler.
class SeedStyle {
  public:
    explicit SeedStyle(int masses);
    void advance(long steps);

  private:
    struct Vector {
        double x = 0.0;
        double y = 0.0;
    };
    struct Mass {
        double mass;
        bool pinned;
        Vector position;
        Vector velocity;
        Vector force;
    };
    struct Spring {
        double stiffness;
        double rest_length;
        Mass* first;
        Mass* second;
    };

    std::vector<std::unique_ptr<Mass>> masses_;
    std::vector<std::unique_ptr<Spring>> springs_;
};

}  // namespace ropesim
