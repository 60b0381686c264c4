#include "simulation/leaps.h"

#include "simulation/bundle_steps.h"
#include "simulation/method.h"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

namespace ropesim {
namespace {

bool moves(const Leap& leap) {
    return leap.kick != 0.0 || leap.drift != 0.0;
}

bool damps(const Leap& leap) {
    return leap.before != 1.0 || leap.after != 1.0 || leap.kept != 1.0;
}

bool damps(const Leaps& leaps) {
    return damps(leaps.opening) ||
           std::ranges::any_of(leaps.of_step, [](const Leap& leap) { return damps(leap); });
}

// Loops that need the accelerations.
long evaluations(const Leaps& leaps) {
    return (leaps.opening.kick != 0.0 ? 1 : 0) +
           leaps.steps *
               std::ranges::count_if(leaps.of_step, [](const Leap& leap) { return leap.kick != 0.0; });
}

// What a loop does: where it is known, nothing need be asked for every mass.
enum class Moves { kick_drift, kick_kick_drift, any };

// A loop over the masses: what goes by one and the same acceleration.
struct Stage {
    Leap first;
    Leap second;
    Moves moves = moves_of(first, second);

    static Moves moves_of(const Leap& first, const Leap& second) {
        if (first.kick == 0.0) return Moves::any;
        if (first.drift != 0.0 && !ropesim::moves(second)) return Moves::kick_drift;
        if (first.drift == 0.0 && second.kick != 0.0 && second.drift != 0.0) return Moves::kick_kick_drift;
        return Moves::any;
    }
};

// The loops of all steps: the opening of the first step, where there is one; then every leap, the last of
// each step with the opening of the next.
class Stages {
  public:
    explicit Stages(const Leaps& leaps)
        : opening_(moves(leaps.opening) ? 1 : 0),
          size_(opening_ + std::ssize(leaps.of_step) * leaps.steps),
          first_{leaps.opening, {}},
          last_{leaps.of_step.back(), {}} {
        assert(leaps.opening.kick == 0.0 || last_.first.kick != 0.0);
        of_step_.reserve(leaps.of_step.size());
        for (const Leap& leap : leaps.of_step) of_step_.push_back({leap, {}});
        of_step_.back() = {last_.first, leaps.opening};
    }

    long size() const { return size_; }

    const Stage& operator[](long j) const {
        if (j == 0 && opening_ == 1) return first_;
        if (j == size_ - 1) return last_;
        return of_step_[static_cast<std::size_t>((j - opening_) % std::ssize(of_step_))];
    }

  private:
    long opening_;
    long size_;
    Stage first_;
    Stage last_;
    std::vector<Stage> of_step_;
};

enum class Sums { plain, damped, compensated };

// What rounding has taken from places and velocities.
template <int width>
struct Lost {
    VectorLanes<width> x{};
    VectorLanes<width> v{};
};

template <Sums sums, class L>
void add(L& sum, L& lost, const L& term) {
    if constexpr (sums != Sums::compensated) {
        sum = sum + term;
    } else {
        const L whole = term - lost;
        const L next = sum + whole;
        lost = (next - sum) - whole;
        sum = next;
    }
}

template <Sums sums, class L>
void kick(const Leap& leap, const L& a, L& v, L& v_lost) {
    if constexpr (sums == Sums::damped)
        v = leap.after * (leap.before * v + leap.kick * a);
    else
        add<sums, L>(v, v_lost, leap.kick * a);
}

template <Sums sums, class L>
void drift(const Leap& leap, L& x, L& v, L& x_lost) {
    add<sums, L>(x, x_lost, leap.drift * v);
    if (sums == Sums::damped) v = leap.kept * v;
}

// Some masses, and what rounding has taken from them.
template <int width>
struct Moving {
    VectorLanes<width> x;
    VectorLanes<width> v;
    Lost<width> lost;
};

template <Sums sums, int width>
void kick(const Leap& leap, const VectorLanes<width>& a, Moving<width>& masses) {
    kick<sums>(leap, a.x, masses.v.x, masses.lost.v.x);
    kick<sums>(leap, a.y, masses.v.y, masses.lost.v.y);
}

template <Sums sums, int width>
void drift(const Leap& leap, Moving<width>& masses) {
    drift<sums>(leap, masses.x.x, masses.v.x, masses.lost.x.x);
    drift<sums>(leap, masses.x.y, masses.v.y, masses.lost.x.y);
}

template <Sums sums, int width>
void move(const Leap& leap, const VectorLanes<width>& a, Moving<width>& masses) {
    if (leap.kick != 0.0) kick<sums>(leap, a, masses);
    if (leap.drift != 0.0) drift<sums>(leap, masses);
}

template <Sums sums, Moves moves, int width>
void move(const Stage& stage, const VectorLanes<width>& a, Moving<width>& masses) {
    if constexpr (moves == Moves::any) {
        move<sums>(stage.first, a, masses);
        move<sums>(stage.second, a, masses);
    } else {
        kick<sums>(stage.first, a, masses);
        if constexpr (moves == Moves::kick_kick_drift) kick<sums>(stage.second, a, masses);
        drift<sums>(moves == Moves::kick_drift ? stage.first : stage.second, masses);
    }
}

// Fields of a bundle that compensated sums need behind the others: what is lost of x, y, vx and vy.
constexpr int lost_fields = 4;

// The masses of a bundle.
template <int width, Sums sums>
class Masses {
  public:
    explicit Masses(Bundle& bundle)
        : x_(bundle[Bundle::x]), y_(bundle[Bundle::y]), vx_(bundle[Bundle::vx]), vy_(bundle[Bundle::vy]) {
        if constexpr (sums == Sums::compensated)
            for (std::size_t i = 0; i < lost_fields; ++i)
                lost_[i] = bundle[Bundle::fields + static_cast<int>(i)];
    }

    // Moves those from element i by a stage, and returns where they are then.
    template <Moves moves>
    VectorLanes<width> move(const Stage& stage, Eigen::Index i, const VectorLanes<width>& a) const {
        Moving<width> masses{load<width>(x_ + i, y_ + i), load<width>(vx_ + i, vy_ + i), {}};
        if constexpr (sums == Sums::compensated)
            masses.lost = {load<width>(lost_[0] + i, lost_[1] + i), load<width>(lost_[2] + i, lost_[3] + i)};
        ropesim::move<sums, moves>(stage, a, masses);
        store(x_ + i, y_ + i, masses.x);
        store(vx_ + i, vy_ + i, masses.v);
        if constexpr (sums == Sums::compensated) {
            store(lost_[0] + i, lost_[1] + i, masses.lost.x);
            store(lost_[2] + i, lost_[3] + i, masses.lost.v);
        }
        return masses.x;
    }

  private:
    double* x_;
    double* y_;
    double* vx_;
    double* vy_;
    std::array<double*, lost_fields> lost_{};
};

// Calls task(moves), the moves a constant.
template <class Task>
void with_moves(Moves moves, const Task& task) {
    switch (moves) {
        case Moves::kick_drift:
            return task(std::integral_constant<Moves, Moves::kick_drift>());
        case Moves::kick_kick_drift:
            return task(std::integral_constant<Moves, Moves::kick_kick_drift>());
        case Moves::any:
            return task(std::integral_constant<Moves, Moves::any>());
    }
}

template <int width, Layout layout, Sums sums>
void leap_in_loops(const Stages& stages, Bundle& bundle) {
    const Loops<width, layout> loops(bundle);
    const Masses<width, sums> masses(bundle);
    in_blocks<width>(
        bundle, stages.size(), [&](long j, Eigen::Index begin, Eigen::Index end, Edge<width>& edge) {
            const Stage& now = stages[j];
            if (now.first.kick == 0.0)
                return loops.each(begin, end, edge, [&](Eigen::Index i) {
                    return masses.template move<Moves::any>(now, i, {});
                });
            with_moves(now.moves, [&](auto moves) {
                loops.accelerate(begin, end, edge, [&](Eigen::Index i, const VectorLanes<width>& a) {
                    return masses.template move<moves>(now, i, a);
                });
            });
        });
}

// A rope of that many vectors stays in registers through all leaps.
template <int width, int vectors, Sums sums>
void leap_in_registers(const Stages& stages, Bundle& bundle) {
    const SpringLanes<width> spring(bundle);
    const auto links = static_cast<std::size_t>(bundle.masses() - 1);
    std::array<Lanes<width>, vectors> weight;
    std::array<VectorLanes<width>, vectors> fall;
    std::array<VectorLanes<width>, vectors + 1> force_before;
    std::array<Moving<width>, vectors + 1> masses;
    for (std::size_t i = 0; i < vectors; ++i) {
        weight[i] = load<width>(bundle[Bundle::weight] + i * width);
        fall[i] = load<width>(bundle[Bundle::fall_x] + i * width, bundle[Bundle::fall_y] + i * width);
        masses[i].x = load<width>(bundle[Bundle::x] + i * width, bundle[Bundle::y] + i * width);
        masses[i].v = load<width>(bundle[Bundle::vx] + i * width, bundle[Bundle::vy] + i * width);
    }
    for (long j = 0; j < stages.size(); ++j) {
        const Stage& now = stages[j];
        for (std::size_t i = 0; i < vectors; ++i) {
            const LinkLanes<width> link = link_lanes(masses[i].x, shifted_down(masses[i].x, masses[i + 1].x));
            force_before[i + 1] = force_lanes<width>(pull_lanes(spring, link.length), link.d,
                                                     static_cast<Eigen::Index>(links - i * width));
        }
        for (std::size_t i = 0; i < vectors; ++i) {
            const VectorLanes<width>& force = force_before[i + 1];
            move<sums, Moves::any>(
                now, acceleration_lanes<width>(weight[i], force, shifted_up(force_before[i], force), fall[i]),
                masses[i]);
        }
    }
    for (std::size_t i = 0; i < vectors; ++i) {
        store(bundle[Bundle::x] + i * width, bundle[Bundle::y] + i * width, masses[i].x);
        store(bundle[Bundle::vx] + i * width, bundle[Bundle::vy] + i * width, masses[i].v);
    }
}

template <int width, Sums sums>
void leap_in_lanes(const Stages& stages, Bundle& bundle) {
    if (bundle.ropes() > 1) return leap_in_loops<width, Layout::side_by_side, sums>(stages, bundle);
    if (bundle.masses() <= width) return leap_in_registers<width, 1, sums>(stages, bundle);
    if (bundle.masses() <= 2L * width) return leap_in_registers<width, 2, sums>(stages, bundle);
    leap_in_loops<width, Layout::one_rope, sums>(stages, bundle);
}

template <Sums sums>
void leap(const Leaps& leaps, Bundle& bundle, InstructionSet instructions) {
    const Stages stages(leaps);
    in_lanes(instructions, [&](auto width) { leap_in_lanes<width, sums>(stages, bundle); });
}

}  // namespace

int fields(const Leaps& leaps) {
    return Bundle::fields + (leaps.compensated ? lost_fields : 0);
}

void leap(const Leaps& leaps, Bundle& bundle, InstructionSet instructions, Cost& cost) {
    assert(!leaps.of_step.empty() && (bundle.ropes() == 1 || bundle.ropes() == lanes(instructions)));
    cost.evaluations += evaluations(leaps);
    if (damps(leaps)) return leap<Sums::damped>(leaps, bundle, instructions);
    if (!leaps.compensated) return leap<Sums::plain>(leaps, bundle, instructions);
    for (int field = Bundle::fields; field < fields(leaps); ++field) bundle.clear(field);
    leap<Sums::compensated>(leaps, bundle, instructions);
}

void leap(const Leaps& leaps, const Rope& rope, State& state, Scratch& scratch) {
    Bundle& bundle = scratch.bundle;
    bundle.resize(rope.start.rows(), 1, fields(leaps));
    bundle.put(rope, 0);
    bundle.put(state, 0, leaps.velocity_unit);
    leap(leaps, bundle, scratch.instructions, scratch.cost);
    bundle.take(state, 0, leaps.velocity_unit);
}

}  // namespace ropesim
