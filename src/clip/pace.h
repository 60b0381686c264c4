#pragma once

namespace ropesim {

// How many processes this one and its children can run on at once.
int processors();

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
