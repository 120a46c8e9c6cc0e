#pragma once

#include <vector>

namespace contact {

/// Vector instruction sets the batch and exact kernels are compiled for. The
/// widest of the machine is chosen at run time; results agree to rounding.
/// CONTACT_INSTRUCTION_SET in the environment of a process names another one,
/// whose numbers are the same, bit for bit, on any machine that has it.
enum class InstructionSet { baseline, avx2, avx512 };

/// Whether this machine and this build can run `set`;
/// always true for `baseline`.
bool is_supported(InstructionSet set);

/// Sets that this machine can run, `baseline` first, the widest last.
const std::vector<InstructionSet>& supported_instruction_sets();

/// "baseline", "avx2" or "avx512".
const char* name(InstructionSet set);

/// The one that the kernels of this process take; the widest where
/// CONTACT_INSTRUCTION_SET is unset or no supported one.
InstructionSet instruction_set() noexcept;

namespace detail {

/// @throws Error if CONTACT_INSTRUCTION_SET is no supported instruction set.
void check_instruction_set();

/// Another instruction set, supported, for as long as this lives: for tests and
/// benchmarks, which compare them. What holds a kernel keeps it.
class WithInstructionSet {
 public:
  explicit WithInstructionSet(InstructionSet set);
  ~WithInstructionSet();
  WithInstructionSet(const WithInstructionSet&) = delete;
  WithInstructionSet& operator=(const WithInstructionSet&) = delete;

 private:
  InstructionSet before_;
};

}  // namespace detail
}  // namespace contact
