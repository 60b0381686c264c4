#pragma once

#include "simulation/instruction_set.h"

#include <cmath>
#include <cstring>
#include <type_traits>

namespace ropesim {

// `width` doubles that one instruction computes, in the compiler's own notation (vector extensions of GCC and
// Clang): + - * / < and ?: work lane by lane, a double among them stands for itself in every lane, and [i] is
// lane i.
template <int width>
struct LanesOf {
    typedef double type __attribute__((vector_size(width * sizeof(double))));
};
template <int width>
using Lanes = typename LanesOf<width>::type;

// All that works on lanes is inlined into the functions that `in_lanes` chooses from, so that no lanes are
// ever passed between functions, whose convention for them differs from one instruction set to the next.
#pragma GCC diagnostic ignored "-Wpsabi"

template <int width>
Lanes<width> load(const double* from) {
    Lanes<width> lanes;
    std::memcpy(&lanes, from, sizeof lanes);
    return lanes;
}

template <class L>
void store(double* to, const L& lanes) {
    std::memcpy(to, &lanes, sizeof lanes);
}

inline Lanes<2> square_root(const Lanes<2>& s) {
    return Lanes<2>{std::sqrt(s[0]), std::sqrt(s[1])};
}

inline Lanes<4> square_root(const Lanes<4>& s) {
    return Lanes<4>{std::sqrt(s[0]), std::sqrt(s[1]), std::sqrt(s[2]), std::sqrt(s[3])};
}

inline Lanes<8> square_root(const Lanes<8>& s) {
    return Lanes<8>{std::sqrt(s[0]), std::sqrt(s[1]), std::sqrt(s[2]), std::sqrt(s[3]),
                    std::sqrt(s[4]), std::sqrt(s[5]), std::sqrt(s[6]), std::sqrt(s[7])};
}

// The last lane of `before`, then all but the last of `lanes`.
template <int width>
Lanes<width> shifted_up(const Lanes<width>& before, const Lanes<width>& lanes) {
    if constexpr (width == 2)
        return __builtin_shufflevector(before, lanes, 1, 2);
    else if constexpr (width == 4)
        return __builtin_shufflevector(before, lanes, 3, 4, 5, 6);
    else
        return __builtin_shufflevector(before, lanes, 7, 8, 9, 10, 11, 12, 13, 14);
}

// All but the first of `lanes`, then the first lane of `after`.
template <int width>
Lanes<width> shifted_down(const Lanes<width>& lanes, const Lanes<width>& after) {
    if constexpr (width == 2)
        return __builtin_shufflevector(lanes, after, 1, 2);
    else if constexpr (width == 4)
        return __builtin_shufflevector(lanes, after, 1, 2, 3, 4);
    else
        return __builtin_shufflevector(lanes, after, 1, 2, 3, 4, 5, 6, 7, 8);
}

// 0, 1, 2, ...
template <int width>
Lanes<width> numbers() {
    Lanes<width> lanes;
    for (int i = 0; i < width; ++i) lanes[i] = i;
    return lanes;
}

#if defined(__x86_64__)
template <class Task>
[[gnu::target("avx2"), gnu::flatten]] void in_avx2_lanes(const Task& task) {
    task(std::integral_constant<int, lanes(InstructionSet::avx2)>());
}

// GCC would make eight lanes twice four; Clang would not, and knows no such wish.
#if defined(__clang__)
#define ROPESIM_AVX512 "avx512f,avx512vl,avx512dq"
#else
#define ROPESIM_AVX512 "avx512f,avx512vl,avx512dq,prefer-vector-width=512"
#endif
template <class Task>
[[gnu::target(ROPESIM_AVX512), gnu::flatten]] void in_avx512_lanes(const Task& task) {
    task(std::integral_constant<int, lanes(InstructionSet::avx512)>());
}
#endif

template <class Task>
[[gnu::flatten]] void in_baseline_lanes(const Task& task) {
    task(std::integral_constant<int, lanes(InstructionSet::baseline)>());
}

// Calls task(width), the width a constant, with all that it calls compiled for these instructions.
template <class Task>
void in_lanes([[maybe_unused]] InstructionSet instructions, const Task& task) {
#if defined(__x86_64__)
    if (instructions == InstructionSet::avx512) return in_avx512_lanes(task);
    if (instructions == InstructionSet::avx2) return in_avx2_lanes(task);
#endif
    in_baseline_lanes(task);
}

}  // namespace ropesim
