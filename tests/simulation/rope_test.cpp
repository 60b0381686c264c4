#include "simulation/rope.h"

#include "simulation/chains.h"

#include <gtest/gtest.h>

#include <limits>
#include <stdexcept>

namespace ropesim {
namespace {

TEST(Rope, PinnedMassesNeitherFallNorYield) {
    Rope rope = straight_rope(4, {1.0, 0.0}, {0.5, -1.0});
    rope.pinned = {0, 3};
    rope.mass << 1.0, 2.0, 4.0, 8.0;
    rope = finished(rope);
    EXPECT_TRUE((rope.inverse_mass == Eigen::Array4d(0.0, 0.5, 0.25, 0.0)).all());
    EXPECT_TRUE((rope.free_fall.col(0) == Eigen::Array4d(0.0, 0.5, 0.5, 0.0)).all());
    EXPECT_TRUE((rope.free_fall.col(1) == Eigen::Array4d(0.0, -1.0, -1.0, 0.0)).all());
}

TEST(Rope, RefusesWhatIsNoRope) {
    const Rope good = straight_rope(3, {1.0, 0.0}, {0.0, -1.0});
    const auto refused = [&](auto&& change) {
        Rope rope = good;
        change(rope);
        EXPECT_THROW(finished(rope), std::runtime_error);
    };
    refused([](Rope& rope) { rope.start.conservativeResize(1, 2); });
    refused([](Rope& rope) { rope.start(1, 1) = std::numeric_limits<double>::quiet_NaN(); });
    refused([](Rope& rope) { rope.mass.conservativeResize(2); });
    refused([](Rope& rope) { rope.mass(1) = 0.0; });
    refused([](Rope& rope) { rope.mass(2) = -1.0; });
    refused([](Rope& rope) { rope.rest_length = 0.0; });
    refused([](Rope& rope) { rope.pinned = {3}; });
    refused([](Rope& rope) { rope.pinned = {-1}; });
}

}  // namespace
}  // namespace ropesim
