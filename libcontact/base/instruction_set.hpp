#pragma once

#include <vector>

namespace contact {

/// Vector instruction sets the batch and exact kernels are compiled for. The
/// best one of the machine is chosen at run time; results agree to rounding.
/// Who asks for another one gets its numbers, bit for bit, on any machine that
/// has it.
enum class InstructionSet { baseline, avx2, avx512 };

/// Whether this machine and this build (clang: without `avx512`) can run `set`;
/// always true for `baseline`.
bool is_supported(InstructionSet set);

/// Those that this machine can run, `baseline` first, the widest last.
const std::vector<InstructionSet>& supported_instruction_sets();

/// The widest supported instruction set.
InstructionSet best_instruction_set();

/// "baseline", "avx2" or "avx512".
const char* name(InstructionSet set);

}  // namespace contact
