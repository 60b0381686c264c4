#include "sweep/sweep.h"

#include <algorithm>
#include <stdexcept>

namespace ropesim {

long Sweep::points() const {
    long result = 1;
    for (const Variation& each : variations) result *= static_cast<long>(each.values.size());
    return result;
}

std::vector<std::string> Sweep::values(long point) const {
    std::vector<std::string> result(variations.size());
    for (std::size_t i = variations.size(); i-- > 0;) {
        const auto count = static_cast<long>(variations[i].values.size());
        result[i] = variations[i].values[static_cast<std::size_t>(point % count)];
        point /= count;
    }
    return result;
}

Scene Sweep::at(long point) const {
    Scene result = scene;
    const std::vector<std::string> of_point = values(point);
    for (std::size_t i = 0; i < variations.size(); ++i) set_key(result, variations[i].key, of_point[i]);
    return result;
}

Sweep make_sweep(const Scene& scene, const std::vector<std::string>& variations) {
    constexpr long most_points = 100'000;
    Sweep sweep{scene, {}};
    long points = 1;
    for (const std::string& text : variations) {
        Variation variation = parse_variation(text, scene);
        for (const Variation& other : sweep.variations)
            if (other.key == variation.key)
                throw std::runtime_error("'" + variation.key +
                                         "' is varied twice; expected one list of all values");
        points *= static_cast<long>(variation.values.size());
        if (points > most_points)
            throw std::runtime_error("the grid has more than " + std::to_string(most_points) + " points");
        sweep.variations.push_back(std::move(variation));
    }
    return sweep;
}

std::string point_name(const Sweep& sweep, long point) {
    const std::string digits = std::to_string(point);
    const std::size_t width = std::max<std::size_t>(4, std::to_string(sweep.points() - 1).size());
    return "point_" + std::string(width - digits.size(), '0') + digits;
}

}  // namespace ropesim
