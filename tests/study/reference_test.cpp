#include "study/reference.h"

#include "simulation/chains.h"
#include "simulation/simulate.h"

#include <gmock/gmock.h>

#include <cmath>
#include <limits>
#include <numbers>

namespace ropesim {
namespace {

// What the rounding of long double may come to here, in world units: 64 bits of mantissa or more, or 53.
constexpr bool extended = std::numeric_limits<long double>::digits >= 64;
constexpr double negligible = extended ? 1e-12 : 1e-8;

constexpr Model models[] = {Model::elastic, Model::inextensible};

// Links of rest length 1 in a zigzag about the x axis: slack between any two pins, and bent everywhere.
Rope zigzag(int masses, std::vector<Eigen::Index> pins) {
    Rope rope;
    rope.start.resize(masses, 2);
    rope.start.row(0) = 0.0;
    for (int i = 1; i < masses; ++i) {
        const double angle = i % 3 == 0 ? 0.4 : -0.9 + 0.1 * i;
        rope.start.row(i) =
            rope.start.row(i - 1) + Eigen::Array2d(std::cos(angle), std::sin(angle)).transpose();
    }
    rope.mass = Eigen::ArrayXd::LinSpaced(masses, 0.5, 2.0);
    rope.pinned = std::move(pins);
    rope.stiffness = 50.0;
    return finished(rope);
}

// The ropes that no analytic solution is known for, one for each way to pin them.
std::vector<Rope> zigzags() {
    std::vector<Rope> ropes;
    for (const std::vector<Eigen::Index>& pins :
         {std::vector<Eigen::Index>{}, {0}, {6}, {3}, {0, 6}, {5, 1}, {0, 3, 6}, {2, 3}, {0, 1, 5}})
        ropes.push_back(zigzag(7, pins));
    return ropes;
}

// Distance of SUNDIALS' run from the truth in the last frame.
double confirmed(const Reference& truth, const Rope& rope, Model model, double frame_time) {
    const std::vector<double> distances = confirmation(truth, rope, model, frame_time);
    EXPECT_EQ(distances.size(), truth.frames.size());
    return distances.back();
}

TEST(Reference, IsThePendulumOfTheEllipticFunctions) {
    const double length = 100.0;
    Rope rope = straight_rope(2, {-1.0, 0.0}, {0.0, -1.0});
    rope.start *= length;
    rope.rest_length = length;
    const Reference truth = reference(finished(rope), Model::inextensible, 1.0, 61);
    ASSERT_EQ(truth.frames.size(), 61u);
    for (std::size_t frame = 0; frame < truth.frames.size(); ++frame) {
        const double angle =
            pendulum_angle(std::numbers::pi / 2.0, 1.0 / std::sqrt(length), static_cast<double>(frame));
        Points expected(2, 2);
        expected << 0.0, 0.0, -length * std::sin(angle), -length * std::cos(angle);
        EXPECT_LT(greatest_distance(expected, truth.frames[frame]), 1e-11) << frame;
    }
}

// About its equilibrium a spring of two masses in line with gravity moves as a cosine, exactly.
TEST(Reference, IsTheCosineOfAMassOnASpring) {
    for (const double damping : {0.0, 0.3}) {
        Rope rope = straight_rope(2, {0.0, -1.0}, {0.0, -1.0});
        rope.start.row(1) << 0.0, -1.2;
        rope.mass(1) = 2.5;
        rope.damping = damping;
        const Rope hanging = finished(rope);
        const Reference truth = reference(hanging, Model::elastic, 0.5, 41);
        ASSERT_EQ(truth.frames.size(), 41u);
        const double decay = damping / 2.0;
        const double omega = std::sqrt(hanging.stiffness / 2.5 - decay * decay);
        const double rest = -1.0 - 2.5 / hanging.stiffness;
        for (std::size_t frame = 0; frame < truth.frames.size(); ++frame) {
            const double t = 0.5 * static_cast<double>(frame);
            const double share =
                std::exp(-decay * t) * (std::cos(omega * t) + decay / omega * std::sin(omega * t));
            EXPECT_NEAR(truth.frames[frame](1, 1), rest + (-1.2 - rest) * share, 1e-14) << frame;
            EXPECT_EQ(truth.frames[frame](1, 0), 0.0);
        }
    }
}

TEST(Reference, IsTheSumOfAHangingChainsNormalModes) {
    Rope rope = straight_rope(6, {0.0, -1.0}, {0.0, -1.0});
    rope.mass << 1.0, 0.5, 2.0, 1.5, 1.0, 3.0;
    rope.damping = 0.05;
    const Rope chain = finished(rope);
    const Reference truth = reference(chain, Model::elastic, 1.0, 21);
    ASSERT_EQ(truth.frames.size(), 21u);
    for (std::size_t frame = 0; frame < truth.frames.size(); ++frame) {
        const Eigen::ArrayXd expected = hanging_chain(chain, static_cast<double>(frame));
        EXPECT_LT((truth.frames[frame].col(1) - expected).abs().maxCoeff(), 1e-12) << frame;
    }
}

// Small oscillations of a rope hung by one end: of two links of length and mass one and g = 1, the slower
// normal mode has ω² = 2 - √2 and shape θ₂ = √2 θ₁. Away from it by the square of the amplitude, relatively.
TEST(Reference, SwingsADoublePendulumInItsNormalMode) {
    const double amplitude = 1e-5;
    const double ratio = std::numbers::sqrt2;
    Rope rope = straight_rope(3, {0.0, -1.0}, {0.0, -1.0});
    rope.start.row(1) << std::sin(amplitude), -std::cos(amplitude);
    rope.start.row(2) << std::sin(amplitude) + std::sin(ratio * amplitude),
        -std::cos(amplitude) - std::cos(ratio * amplitude);
    const Reference truth = reference(finished(rope), Model::inextensible, 1.0, 21);
    ASSERT_EQ(truth.frames.size(), 21u);
    for (std::size_t frame = 0; frame < truth.frames.size(); ++frame) {
        const double share = std::cos(std::sqrt(2.0 - ratio) * static_cast<double>(frame));
        EXPECT_NEAR(truth.frames[frame](1, 0), amplitude * share, 10.0 * std::pow(amplitude, 3));
        EXPECT_NEAR(truth.frames[frame](2, 0), (1.0 + ratio) * amplitude * share,
                    30.0 * std::pow(amplitude, 3));
    }
}

// The centre of a rope that nothing holds falls freely, or as free fall under damping: v' = g - d v.
TEST(Reference, LetsTheCentreOfMassFallFreely) {
    for (const Model model : models) {
        for (const double damping : {0.0, 0.2}) {
            Rope rope = zigzag(7, {});
            rope.damping = damping;
            const Reference truth = reference(rope, model, 1.0, 11);
            ASSERT_EQ(truth.frames.size(), 11u);
            const auto centre = [&](const Points& points) {
                return ((points.colwise() * rope.mass).colwise().sum() / rope.mass.sum()).eval();
            };
            const double fall = damping == 0.0 ? 50.0 : (10.0 - (1.0 - std::exp(-2.0)) / damping) / damping;
            EXPECT_NEAR(centre(truth.frames[10])(1), centre(rope.start)(1) - fall, 1e-12);
            EXPECT_NEAR(centre(truth.frames[10])(0), centre(rope.start)(0), 1e-12);
        }
    }
}

// Nothing pulls on a rope at rest length that falls: each of its masses falls freely.
TEST(Reference, LetsARopeAtRestLengthFallFreely) {
    for (const Model model : models) {
        const Rope rope = zigzag(7, {});
        const Reference truth = reference(rope, model, 1.0, 11);
        Points expected = rope.start;
        expected.col(1) -= 50.0;
        EXPECT_LT(greatest_distance(expected, truth.frames[10]), 1e-13) << name(model);
    }
}

// Relative to the greatest of its parts, which is what rounding goes by.
TEST(Reference, KeepsTheEnergy) {
    for (const Model model : models) {
        for (const Rope& rope : zigzags()) {
            const Reference truth = reference(rope, model, 0.5, 11);
            ASSERT_EQ(truth.frames.size(), 11u);
            const auto energy_in = [&](std::size_t frame) {
                return energy(rope, model, {0.0, truth.frames[frame], truth.velocities[frame]});
            };
            const double total = energy_in(0).total();
            for (std::size_t frame = 0; frame < truth.frames.size(); ++frame) {
                const Energy now = energy_in(frame);
                const double size = std::max({std::abs(total), now.kinetic, std::abs(now.gravity)});
                EXPECT_NEAR(now.total(), total, 1e-12 * size) << name(model) << ' ' << frame;
            }
        }
    }
}

TEST(Reference, KeepsTheLinksOfAnInextensibleRope) {
    for (const Rope& rope : zigzags()) {
        for (const Points& points : reference(rope, Model::inextensible, 0.5, 11).frames) {
            for (Eigen::Index i = 0; i + 1 < points.rows(); ++i)
                EXPECT_NEAR((points.row(i + 1) - points.row(i)).matrix().norm(), 1.0, negligible);
            for (const Eigen::Index pin : rope.pinned)
                EXPECT_TRUE((points.row(pin) == rope.start.row(pin)).all());
        }
    }
}

// Two formulations, two integrators, two precisions, two tolerances: one motion. Here, with links of length
// one, over 5 units of time.
TEST(Reference, AgreesWithTheOtherRuns) {
    for (const Model model : models) {
        for (Rope rope : zigzags()) {
            for (const double damping : {0.0, 0.1}) {
                rope.damping = damping;
                const Reference truth = reference(rope, model, 0.5, 11);
                ASSERT_EQ(truth.frames.size(), 11u);
                EXPECT_LT(truth.error.back(), negligible) << name(model) << ' ' << rope.pinned.size();
                EXPECT_LT(confirmed(truth, rope, model, 0.5), 1e-10)
                    << name(model) << ' ' << rope.pinned.size();
                EXPECT_GT(greatest_distance(truth.frames[0], truth.frames[10]), 0.01);
            }
        }
    }
}

// An elastic rope may start at any length of its links.
// What rounds in the last digit at the start is magnified; the estimate of it grows along.
TEST(Reference, IsBelievedOverTheWholeClipOfTheSeed) {
    for (const Model model : models) {
        const Reference truth = reference(seed_rope(16), model, 1.0, 121);
        EXPECT_EQ(believed_frames(truth, extended ? 1e-9 : 1e-3), 121) << name(model);
        EXPECT_LT(confirmed(truth, seed_rope(16), model, 1.0), 1e-5) << name(model);
    }
}

// Of all masses held still nothing moves, and of a rope that hangs at rest.
TEST(Reference, LeavesWhatIsAtRest) {
    const auto farthest = [](const Rope& rope, Model model) {
        const Reference truth = reference(rope, model, 1.0, 4);
        return greatest_distance(rope.start, truth.frames.at(3)) + confirmed(truth, rope, model, 1.0);
    };
    for (const Model model : models)
        EXPECT_LT(farthest(zigzag(4, {3, 0, 1, 2}), model), 1e-14) << name(model);
    EXPECT_LT(farthest(straight_rope(5, {0.0, -1.0}, {0.0, -1.0}), Model::inextensible), 1e-14);
}

TEST(Reference, StartsFromLinksThatAreNotAtRestLength) {
    Rope rope = zigzag(7, {0, 6});
    rope.rest_length = 0.7;
    const Reference truth = reference(rope, Model::elastic, 0.5, 21);
    ASSERT_EQ(truth.frames.size(), 21u);
    EXPECT_LT(truth.error.back(), negligible);
    EXPECT_LT(confirmed(truth, rope, Model::elastic, 0.5), 1e-10);
}

double distance_at(const Reference& truth, const char* method, long frame) {
    return greatest_distance(truth.frames[static_cast<std::size_t>(frame)],
                             positions_at(seed_rope(16), find_method(method), stepping(1.0, 64), frame));
}

// Figures that were found with another program, to their two digits.
TEST(Reference, FindsTheKnownErrorsOnTheSeedsElasticRope) {
    const Reference truth = reference(seed_rope(16), Model::elastic, 1.0, 61);
    EXPECT_EQ(believed_frames(truth, negligible), 61);
    EXPECT_LT(confirmed(truth, seed_rope(16), Model::elastic, 1.0), 1e-10);
    EXPECT_NEAR(distance_at(truth, "symplectic_euler", 20), 0.195, 0.0005);
    EXPECT_NEAR(distance_at(truth, "seed_verlet", 20), 0.195, 0.0005);
    EXPECT_NEAR(distance_at(truth, "stormer_verlet", 20), 0.00017, 0.000005);
}

TEST(Reference, FindsTheKnownErrorsOnTheSeedsInextensibleRope) {
    const Reference truth = reference(seed_rope(16), Model::inextensible, 1.0, 61);
    EXPECT_EQ(believed_frames(truth, negligible), 61);
    EXPECT_LT(confirmed(truth, seed_rope(16), Model::inextensible, 1.0), 1e-10);
    EXPECT_NEAR(distance_at(truth, "constraint_projection", 20), 0.18, 0.005);
    EXPECT_NEAR(distance_at(truth, "constraint_projection", 60), 7.2, 0.05);
}

// k = 40000 is stiff to the methods; the inextensible rope is within 0.024 of it.
TEST(Reference, KnowsTheStiffRope) {
    Rope rope = seed_rope(64);
    rope.stiffness = 40000.0;
    rope.mass.setConstant(0.25);
    rope = finished(rope);
    const Reference elastic = reference(rope, Model::elastic, 1.0, 21);
    const Reference inextensible = reference(rope, Model::inextensible, 1.0, 21);
    for (const Reference& truth : {elastic, inextensible}) EXPECT_EQ(believed_frames(truth, negligible), 21);
    EXPECT_LT(confirmed(elastic, rope, Model::elastic, 1.0), 1e-10);
    EXPECT_LT(confirmed(inextensible, rope, Model::inextensible, 1.0), 1e-10);
    EXPECT_NEAR(greatest_distance(elastic.frames[20], inextensible.frames[20]), 0.024, 0.0005);
}

TEST(BelievedFrames, EndBeforeTheFirstErrorAboveTheBound) {
    Reference truth;
    truth.error = {0.0, 1e-12, 1e-8, 1e-10};
    EXPECT_EQ(believed_frames(truth, 1e-9), 2);
    EXPECT_EQ(believed_frames(truth, 1e-8), 4);
    EXPECT_EQ(believed_frames(truth, 0.0), 1);
    truth.error[1] = std::numeric_limits<double>::quiet_NaN();
    EXPECT_EQ(believed_frames(truth, 1.0), 1);
}

std::string refusal(const Rope& rope, Model model) {
    try {
        reference(rope, model, 1.0, 2);
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "";
}

TEST(Reference, RefusesWhatHasNoMotion) {
    using testing::HasSubstr;
    Rope straight = straight_rope(5, {1.0, 0.0}, {0.0, -1.0});
    straight.pinned = {0, 4};
    EXPECT_THAT(refusal(finished(straight), Model::inextensible),
                HasSubstr("between pinned masses 0 and 4 of the inextensible rope lie on one line"));
    EXPECT_EQ(refusal(finished(straight), Model::elastic), "");
    straight.pinned = {0, 1};
    EXPECT_EQ(refusal(finished(straight), Model::inextensible), "");

    Rope folded = straight_rope(3, {1.0, 0.0}, {0.0, -1.0});
    folded.start.row(2) = 0.0;
    folded.pinned = {2, 0};
    EXPECT_THAT(refusal(finished(folded), Model::inextensible), HasSubstr("on one line"));

    Rope slack = straight_rope(3, {1.0, 0.0}, {0.0, -1.0});
    slack.rest_length = 1.25;
    EXPECT_THAT(
        refusal(finished(slack), Model::inextensible),
        HasSubstr(
            "link 0 of the inextensible rope starts at length 1.000000; expected its rest length, 1.25"));

    Rope point = straight_rope(3, {1.0, 0.0}, {0.0, -1.0});
    point.start.row(2) = point.start.row(1);
    EXPECT_THAT(refusal(finished(point), Model::elastic), HasSubstr("link 1 of the elastic rope"));
}

// A spring pressed together along its own line until it has no length has no direction there.
TEST(Reference, EndsWhereALinkPassesThroughNoLength) {
    Rope rope = straight_rope(2, {0.0, 1.0}, {0.0, -1.0});
    rope.start.row(1) << 0.0, 3.0;
    const Reference truth = reference(finished(rope), Model::elastic, 1.0, 21);
    EXPECT_LT(believed_frames(truth, 1e-6), 21);
}

}  // namespace
}  // namespace ropesim
