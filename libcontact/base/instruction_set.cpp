#include "libcontact/base/instruction_set.hpp"

#include <algorithm>
#include <atomic>
#include <cstdlib>
#include <initializer_list>
#include <string>
#include <string_view>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"

namespace contact {

bool is_supported(InstructionSet set) {
#ifdef __x86_64__
  if (set == InstructionSet::avx2) {
    return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma");
  }
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
  static const auto& sets = *new auto([] {
    std::vector<InstructionSet> all;
    for (const InstructionSet set :
         {InstructionSet::baseline, InstructionSet::avx2,
          InstructionSet::avx512}) {
      if (is_supported(set)) all.push_back(set);
    }
    return all;
  }());
  return sets;
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

namespace {

constexpr const char* variable = "CONTACT_INSTRUCTION_SET";

// Value of the environment variable, "" if it is not set.
std::string_view asked() {
  const char* const text = std::getenv(variable);
  return text ? text : "";
}

std::atomic<InstructionSet>& of_process() {
  static std::atomic<InstructionSet> chosen = [] {
    const std::vector<InstructionSet>& sets = supported_instruction_sets();
    const auto found = std::ranges::find(sets, asked(), name);
    return found == sets.end() ? sets.back() : *found;
  }();
  return chosen;
}

}  // namespace

InstructionSet instruction_set() noexcept {
  return of_process().load(std::memory_order_relaxed);
}

namespace detail {

void check_instruction_set() {
  if (asked().empty()) return;
  const std::vector<InstructionSet>& sets = supported_instruction_sets();
  // Batches come here: a good one allocates nothing.
  if (std::ranges::find(sets, asked(), name) != sets.end()) return;
  std::vector<std::string> names;
  for (const InstructionSet set : sets) names.emplace_back(name(set));
  throw Error(must_be(message("{} = {}", variable, printable(asked())),
                      message("{} on this machine", either(names))));
}

WithInstructionSet::WithInstructionSet(InstructionSet set)
    : before_(of_process().exchange(set)) {}

WithInstructionSet::~WithInstructionSet() { of_process() = before_; }

}  // namespace detail
}  // namespace contact
