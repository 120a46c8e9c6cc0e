#include "libcontact/base/instruction_set.hpp"

#include <initializer_list>

#include "libcontact/base/kernel_sets.hpp"

namespace contact {

bool is_supported(InstructionSet set) {
#ifdef CONTACT_AVX2_KERNELS
  if (set == InstructionSet::avx2) {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  }
#endif
#ifdef CONTACT_AVX512_KERNELS
  if (set == InstructionSet::avx512) {
    return __builtin_cpu_supports("avx512f") &&
           __builtin_cpu_supports("avx512dq") &&
           __builtin_cpu_supports("avx512vl") &&
           __builtin_cpu_supports("avx512bw");
  }
#endif
  return set == InstructionSet::baseline;
}

const std::vector<InstructionSet>& supported_instruction_sets() {
  static const std::vector<InstructionSet> sets = [] {
    std::vector<InstructionSet> all;
    for (const InstructionSet set :
         {InstructionSet::baseline, InstructionSet::avx2,
          InstructionSet::avx512}) {
      if (is_supported(set)) all.push_back(set);
    }
    return all;
  }();
  return sets;
}

InstructionSet best_instruction_set() {
  return supported_instruction_sets().back();
}

const char* name(InstructionSet set) {
  switch (set) {
    case InstructionSet::avx512:
      return "avx512";
    case InstructionSet::avx2:
      return "avx2";
    default:
      return "baseline";
  }
}

}  // namespace contact
