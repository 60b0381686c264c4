#include "clip/pace.h"

#include <sched.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>

namespace ropesim {

int processors() {
    cpu_set_t set;
    if (::sched_getaffinity(0, sizeof set, &set) != 0) return 1;
    std::string cpu_max;
    std::getline(std::ifstream("/sys/fs/cgroup/cpu.max"), cpu_max);
    return std::min(CPU_COUNT(&set), granted_processors(cpu_max).value_or(CPU_COUNT(&set)));
}

std::optional<int> granted_processors(const std::string& cpu_max) {
    std::istringstream words(cpu_max);
    double quota = 0.0;
    double period = 0.0;
    if (!(words >> quota >> period) || quota <= 0.0 || period <= 0.0) return std::nullopt;
    return static_cast<int>(std::min(1e6, std::ceil(quota / period)));
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
