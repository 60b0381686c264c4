#include "clip/pace.h"

#include <sched.h>

#include <algorithm>

namespace ropesim {

int processors() {
    cpu_set_t set;
    if (::sched_getaffinity(0, sizeof set, &set) != 0) return 1;
    return CPU_COUNT(&set);
}

void Pace::add_frame(double seconds) {
    (frames_ == 0 ? first_ : others_) += seconds;
    ++frames_;
}

int Pace::worthwhile_helpers(long left) const {
    constexpr double most = 1024.0;
    if (frames_ < 2 || first_ <= 0.0) return 0;
    const double work = others_ / static_cast<double>(frames_ - 1) * static_cast<double>(left);
    return static_cast<int>(std::min(most, work / (2.0 * first_)));
}

}  // namespace ropesim
