#pragma once

#include <span>
#include <string_view>

namespace ropesim {

// The instructions that the loops over masses are compiled for, each a copy of the same source. Square root
// and division are rounded correctly in all of them, and nothing is contracted: positions are the same bits.
enum class InstructionSet { baseline, avx2, avx512 };

// Those that this machine has, the narrowest first.
std::span<const InstructionSet> instruction_sets();

InstructionSet widest_instruction_set();

// As the processor's makers call it: "AVX2"; "baseline" is what every machine of the architecture has.
std::string_view name(InstructionSet instructions);

// How many doubles one instruction computes.
constexpr int lanes(InstructionSet instructions) {
    return instructions == InstructionSet::avx512 ? 8 : instructions == InstructionSet::avx2 ? 4 : 2;
}

}  // namespace ropesim
