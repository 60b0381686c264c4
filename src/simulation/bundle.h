#pragma once

#include "simulation/rope.h"

#include <array>
#include <vector>

namespace ropesim {

// Ropes of equally many masses side by side, laid out for vectors: element i * ropes + r of a field is of
// mass i of rope r. One rope is a bundle of one. The fields are so far apart that whole vectors may reach
// three vectors beyond their end.
class Bundle {
  public:
    // Inverse masses and the acceleration of gravity, both 0 at pins; place; velocity; of the link to the
    // next mass its vector and its length, which are for the loops to keep. A method may have more.
    enum Field { weight, fall_x, fall_y, x, y, vx, vy, link_x, link_y, length, fields };
    static constexpr int most_ropes = 8;

    void resize(Eigen::Index masses, Eigen::Index ropes, int field_count = fields);

    Eigen::Index masses() const { return masses_; }
    Eigen::Index ropes() const { return ropes_; }
    int field_count() const { return field_count_; }
    double* operator[](int field) { return storage_.data()->elements + field * pitch_; }
    const double* operator[](int field) const { return storage_.data()->elements + field * pitch_; }

    void clear(int field);

    // What never changes of rope r.
    void put(const Rope& rope, Eigen::Index r);

    // Where rope r is and how fast, the velocities times `unit`; and back, the velocities divided by it.
    void put(const State& state, Eigen::Index r, double unit = 1.0);
    void take(State& state, Eigen::Index r, double unit = 1.0) const;

    std::array<double, most_ropes> stiffness{};    // of each rope
    std::array<double, most_ropes> rest_length{};  // of each rope

  private:
    void put(const double* column, int field, Eigen::Index r, double unit = 1.0);
    void take(double* column, int field, Eigen::Index r) const;

    struct alignas(64) CacheLine {
        double elements[8];
    };
    std::vector<CacheLine> storage_;
    Eigen::Index masses_ = 0;
    Eigen::Index ropes_ = 0;
    Eigen::Index pitch_ = 0;  // elements from one field to the next
    int field_count_ = 0;
};

}  // namespace ropesim
