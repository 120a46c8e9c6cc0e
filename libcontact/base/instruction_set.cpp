#include "libcontact/base/instruction_set.hpp"

#include <initializer_list>

namespace contact {

bool is_supported(InstructionSet set) {
#if defined(__x86_64__)
  switch (set) {
    case InstructionSet::baseline:
      return true;
    case InstructionSet::avx2:
      return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
    case InstructionSet::avx512:
      return __builtin_cpu_supports("avx512f") &&
             __builtin_cpu_supports("avx512dq") &&
             __builtin_cpu_supports("avx512vl") &&
             __builtin_cpu_supports("avx512bw");
  }
  return false;
#else
  return set == InstructionSet::baseline;
#endif
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
