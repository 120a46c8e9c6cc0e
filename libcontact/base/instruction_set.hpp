#pragma once

namespace contact {

/// Vector instruction sets the batch and exact kernels are compiled for. The
/// best one of the machine is chosen at run time; results agree to rounding.
enum class InstructionSet { baseline, avx2, avx512 };

/// Whether this machine (and this build) can run `set`; always true for
/// `baseline`.
bool is_supported(InstructionSet set);

/// The widest supported instruction set.
InstructionSet best_instruction_set();

/// "baseline", "avx2" or "avx512".
const char* name(InstructionSet set);

}  // namespace contact
