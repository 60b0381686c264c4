#include "simulation/instruction_set.h"

namespace ropesim {
namespace {

constexpr InstructionSet all[] = {InstructionSet::baseline, InstructionSet::avx2, InstructionSet::avx512};

std::size_t supported() {
#if defined(__x86_64__)
    if (!__builtin_cpu_supports("avx2")) return 1;
    const bool avx512 = __builtin_cpu_supports("avx512f") && __builtin_cpu_supports("avx512vl") &&
                        __builtin_cpu_supports("avx512dq");
    return avx512 ? 3 : 2;
#else
    return 1;
#endif
}

}  // namespace

std::span<const InstructionSet> instruction_sets() {
    static const std::size_t count = supported();
    return {all, count};
}

InstructionSet widest_instruction_set() {
    return instruction_sets().back();
}

std::string_view name(InstructionSet instructions) {
    switch (instructions) {
        case InstructionSet::avx512:
            return "AVX-512";
        case InstructionSet::avx2:
            return "AVX2";
        default:
            return "baseline";
    }
}

}  // namespace ropesim
