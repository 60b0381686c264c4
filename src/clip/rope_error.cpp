#include "clip/rope_error.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>

namespace ropesim {

RopeError::RopeError(const Rope& rope, const Method& method, const Stepping& stepping, double pixels_per_unit)
    : estimator_(rope, method, stepping), pixels_per_unit_(pixels_per_unit) {}

void RopeError::add(const Points& position) {
    ++frame_;
    estimator_.advance();
    const auto estimate = estimator_.estimate(position);
    const double error = estimate ? estimate->error * pixels_per_unit_ : 0.0;
    const double uncertainty =
        estimate ? estimate->uncertainty * pixels_per_unit_ : std::numeric_limits<double>::infinity();
    const bool trusted = estimate && estimate->trusted();
    last_ = trusted ? std::optional(error) : std::nullopt;
    if (frames_.size() < most_frames_kept)
        frames_.push_back(trusted ? std::optional(static_cast<float>(error)) : std::nullopt);
    const double least = trusted ? error : error - uncertainty;
    most_ = std::max(most_, trusted ? error : error + uncertainty);
    if (least <= least_) return;
    least_ = least;
    least_frame_ = frame_;
}

RopeError::Worst RopeError::worst() const {
    constexpr double invisible = 1e-3;  // pixels
    if (most_ <= 2.0 * least_) return {Bound::about, least_, least_frame_};
    if (most_ <= invisible) return {Bound::less_than, most_, least_frame_};
    return {Bound::more_than, least_, least_frame_};
}

std::string pixels(double number) {
    std::array<char, 64> text;
    const double tens = number < 1e6 ? std::pow(10.0, std::floor(std::log10(number)) - 1.0) : 0.0;
    if (tens >= 1.0)
        std::snprintf(text.data(), text.size(), "%.0f px", std::round(number / tens) * tens);
    else
        std::snprintf(text.data(), text.size(), "%.2g px", number);
    return text.data();
}

std::string to_string(const RopeError::Worst& worst) {
    constexpr std::array<const char*, 3> words{"", "more than ", "less than "};
    return words[static_cast<std::size_t>(worst.bound)] + pixels(worst.pixels);
}

}  // namespace ropesim
