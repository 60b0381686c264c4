// What a step costs, on one core: against the assignment's own way, and against the floor, which is one
// square root and one division for every spring by the processor's widest instructions. Medians of processor
// time.

#include "benchmarks/measurement.h"
#include "benchmarks/processor.h"
#include "benchmarks/seed_style.h"
#include "simulation/block_tridiagonal.h"
#include "simulation/lanes.h"
#include "simulation/links.h"
#include "simulation/moving_ropes.h"

#include <array>
#include <cstdio>
#include <memory>

#if defined(ROPESIM_LAPACK)
extern "C" void dpbsv_(const char* part, const int* n, const int* bands, const int* right_sides,
                       double* matrix, const int* rows, double* b, const int* rows_of_b, int* info);
#endif

namespace {

using namespace ropesim;

constexpr int sizes[] = {16, 64, 1024, 16384, 1'000'000};
constexpr long steps = 64;
constexpr int many = 1000;

Rope seed_rope(int masses) {
    Rope rope;
    rope.start.resize(masses, 2);
    for (int i = 0; i < masses; ++i) rope.start.row(i) << -400.0 / (masses - 1) * i, 200.0;
    rope.mass = Eigen::ArrayXd::Ones(masses);
    rope.pinned = {0};
    rope.rest_length = 400.0 / (masses - 1);
    return finished(rope);
}

std::string label(std::string_view what, int masses) {
    return std::string(what) + ", " + std::to_string(masses);
}

double springs(int masses) {
    return static_cast<double>((masses - 1) * steps);
}

// The assignment's rope, frame after frame.
void measure_seed_style(int masses) {
    const auto rope = std::make_shared<SeedStyle>(masses);
    measure(label("seed_style", masses), springs(masses), [rope] { rope->advance(steps); });
}

struct Moving {
    Rope rope;
    State state;
    Scratch scratch;
};

void measure_method(const std::string& name, const char* method, int masses, InstructionSet instructions) {
    const auto moving = std::make_shared<Moving>();
    moving->rope = seed_rope(masses);
    moving->state = at_rest(moving->rope);
    moving->scratch.instructions = instructions;
    measure(label(name, masses), springs(masses), [moving, row = &find_method(method)] {
        row->advance(moving->rope, stepping(1.0, steps), moving->state, moving->scratch);
    });
}

void measure_method(const char* method, int masses) {
    measure_method(method, method, masses, widest_instruction_set());
}

void measure_many_ropes() {
    const auto ropes = std::make_shared<std::vector<Rope>>(many, seed_rope(16));
    std::vector<MovingRope> moving;
    for (const Rope& rope : *ropes)
        moving.emplace_back(rope, find_method("symplectic_euler"), stepping(1.0, steps));
    const auto all = std::make_shared<MovingRopes>(std::move(moving));
    measure("many", springs(16) * many, [all, ropes] { all->advance(); });
    const auto bundle = std::make_shared<Bundle>();
    const int width = lanes(widest_instruction_set());
    bundle->resize(16, width);
    for (int i = 0; i < width; ++i) {
        bundle->put(ropes->front(), i);
        bundle->put(at_rest(ropes->front()), i);
    }
    measure("side by side", springs(16) * width, [bundle, ropes] {
        Cost cost;
        leap(find_method("symplectic_euler").leaps(ropes->front(), stepping(1.0, steps)), *bundle,
             widest_instruction_set(), cost);
    });
}

// One cycle each: additions that wait for each other.
void measure_cycle() {
    constexpr long additions = 1 << 14;
    measure("cycle", additions, [] {
        long sum = 0;
        for (long i = 0; i < additions; i += 8) {
#pragma GCC unroll 8
            for (int j = 0; j < 8; ++j) {
                sum += 1;
                asm volatile("" : "+r"(sum));
            }
        }
    });
}

// One square root and one division for each element, of what is in the nearest cache.
void measure_floor() {
    constexpr int elements = 512;
    const auto squares = std::make_shared<std::array<double, elements>>();
    const auto shares = std::make_shared<std::array<double, elements>>();
    squares->fill(2.75);
    measure("floor", elements, [squares, shares] {
        in_lanes(widest_instruction_set(), [&](auto width) {
            for (std::size_t i = 0; i < elements; i += width)
                store(shares->data() + i, 1.5 / square_root(load<width>(squares->data() + i)));
        });
        asm volatile("" ::"r"(shares->data()) : "memory");
    });
}

// The operations of a step on a mass, each waiting for the one before it: no step of one rope is faster.
void measure_chain() {
    constexpr int links = 4096;
    measure("chain", links, [] {
        double x = 1.0;
        double v = 0.0;
        for (int i = 0; i < links; ++i) {
            const double d = 4.0 - x;
            const double length = std::sqrt(d * d + 2.0 + shortest_squared);
            const double force = 100.0 * (1.0 - 3.5 / length) * d;
            v = v + 0.01 * (0.5 * (force - 1.0) + 0.25);
            x = x + 0.01 * v;
            asm volatile("" : "+x"(x));
        }
    });
}

void measure_band_solvers(int masses) {
    const auto matrix = std::make_shared<BlockTridiagonal>();
    const auto right = std::make_shared<Eigen::ArrayX2d>();
    measure(label("our solver", masses), masses, [=] {
        matrix->diagonal.resize(masses, 3);
        matrix->coupling.resize(masses - 1, 3);
        matrix->diagonal.rowwise() = Eigen::Array3d(4.0, 0.5, 5.0).transpose();
        matrix->coupling.rowwise() = Eigen::Array3d(-1.0, 0.25, -1.5).transpose();
        *right = Eigen::ArrayX2d::Ones(masses, 2);
        if (factor(*matrix)) solve(*matrix, *right);
    });
#if defined(ROPESIM_LAPACK)
    const auto bands = std::make_shared<Eigen::ArrayXXd>();
    const auto b = std::make_shared<Eigen::ArrayXd>();
    measure(label("LAPACK", masses), masses, [=] {
        const int n = 2 * masses, below = 3, one = 1, rows = 4;
        int info = 0;
        bands->resize(rows, n);
        for (int i = 0; i < n; i += 2) {
            bands->col(i) << 4.0, 0.5, -1.0, 0.25;
            bands->col(i + 1) << 5.0, 0.25, -1.5, 0.0;
        }
        *b = Eigen::ArrayXd::Ones(n);
        dpbsv_("L", &n, &below, &one, bands->data(), &rows, b->data(), &n, &info);
    });
#endif
}

void measure_all() {
    measure_cycle();
    measure_floor();
    measure_chain();
    for (const int masses : sizes) {
        measure_seed_style(masses);
        measure_method("symplectic_euler", masses);
        measure_method("stormer_verlet", masses);
    }
    for (const InstructionSet instructions : instruction_sets())
        measure_method(std::string(name(instructions)), "symplectic_euler", 512, instructions);
    measure_seed_style(512);
    measure_many_ropes();
    for (const int masses : {16, 64, 1024})
        for (const char* method : {"runge_kutta_4", "blanes_moan_4", "blanes_moan_6"})
            measure_method(method, masses);
    for (const int masses : {16, 64}) {
        for (const char* method : {"constraint_projection", "direct_projection", "implicit_midpoint"})
            measure_method(method, masses);
        measure_band_solvers(masses);
    }
}

void print_springs() {
    const double cycle = nanoseconds("cycle");
    const double floor = nanoseconds("floor");
    std::printf("one square root and one division, %s: %.2f cycles (the floor)\n",
                std::string(name(widest_instruction_set())).c_str(), floor / cycle);
    std::printf("the operations of a step, each waiting for the last: %.0f cycles\n\n",
                nanoseconds("chain") / cycle);
    std::printf("%-28s %9s %10s %10s %12s %10s\n", "per spring and step", "masses", "ns", "cycles",
                "x seed_style", "x floor");
    const auto row = [&](const char* what, int masses, double each, double baseline) {
        if (each == 0.0) return;  // not measured: filtered out
        std::printf("%-28s %9d %10.2f %10.2f %12.2f %10.2f\n", what, masses, each, each / cycle,
                    baseline / each, each / floor);
    };
    for (const int masses : sizes) {
        const double baseline = nanoseconds(label("seed_style", masses));
        for (const char* what : {"seed_style", "symplectic_euler", "stormer_verlet"})
            row(what, masses, nanoseconds(label(what, masses)), baseline);
    }
    const double baseline = nanoseconds(label("seed_style", 16));
    row("one vector of ropes", 16, nanoseconds("side by side"), baseline);
    row("1000 ropes", 16, nanoseconds("many"), baseline);
    for (const InstructionSet instructions : instruction_sets()) {
        const std::string what(name(instructions));
        row(("symplectic_euler, " + what).c_str(), 512, nanoseconds(label(what, 512)),
            nanoseconds(label("seed_style", 512)));
    }
}

void print_stages() {
    std::printf("\n%-28s %9s %34s\n", "per stage", "masses", "x a step of symplectic_euler");
    const std::pair<const char*, int> methods[] = {
        {"runge_kutta_4", 4}, {"blanes_moan_4", 6}, {"blanes_moan_6", 14}};
    for (const int masses : {16, 64, 1024})
        for (const auto& [method, stages] : methods)
            std::printf(
                "%-28s %9d %34.2f\n", method, masses,
                nanoseconds(label(method, masses)) / stages / nanoseconds(label("symplectic_euler", masses)));
}

// Newton iterations in a step, over the frames that are timed.
double iterations(int masses) {
    const Trajectory trajectory =
        simulate(seed_rope(masses), find_method("implicit_midpoint"), stepping(1.0, steps), 60);
    return static_cast<double>(trajectory.cost.solves) / static_cast<double>(59 * steps);
}

void print_solvers() {
    std::printf("\n%-28s %9s\n", "per step", "masses");
    for (const int masses : {16, 64})
        std::printf("%-28s %9d %34.2f x a sweep of constraint_projection\n", "direct_projection", masses,
                    nanoseconds(label("direct_projection", masses)) /
                        nanoseconds(label("constraint_projection", masses)));
    for (const int masses : {16, 64}) {
        const double solver = nanoseconds(label("our solver", masses));
        const double iteration =
            nanoseconds(label("implicit_midpoint", masses)) * (masses - 1) / masses / iterations(masses);
        std::printf("%-28s %9d %24.1f ns a mass", "a Newton iteration", masses, iteration);
        std::printf(", of which factor and solve %.1f", solver);
        const double lapack = nanoseconds(label("LAPACK", masses));
        if (lapack > 0.0) std::printf("; LAPACK's dpbsv alone %.1f", lapack);
        std::printf("\n");
    }
}

}  // namespace

int main(int count, char** values) {
    measure_all();
    if (!take_turns(count, values)) return 1;
    std::printf("%s, one core\n", processor().c_str());
    print_springs();
    print_stages();
    print_solvers();
}
