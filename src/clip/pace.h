#pragma once

#include <optional>
#include <string>

namespace ropesim {

// How many processors this process and its children can run on at once: those that it is bound to, or fewer
// where a container grants it less of their time (cgroup v2).
int processors();

// How many processors' time a cgroup grants by its cpu.max, rounded up, such as 2 for "150000 100000"; none
// where it sets no limit ("max 100000").
std::optional<int> granted_processors(const std::string& cpu_max);

// What frames cost here, as they are drawn: says how many helpers make the rest of a clip faster.
class Pace {
  public:
    void add_frame(double seconds);

    // A helper's first frame takes as long as this process's first: both make an OpenGL context and compile
    // shaders. Of `left` frames, each helper is to have twice as much to do as that.
    int worthwhile_helpers(long left) const;

  private:
    long frames_ = 0;
    double first_ = 0.0;   // seconds
    double others_ = 0.0;  // seconds, of all other frames together
};

}  // namespace ropesim
