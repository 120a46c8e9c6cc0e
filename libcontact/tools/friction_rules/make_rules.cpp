#include <cstdio>
#include <stdexcept>
#include <utility>

#include "libcontact/friction/kernel/cap_rule.hpp"
#include "libcontact/tools/friction_rules/families.hpp"

namespace {

using contact::detail::CapRule;
using namespace contact::detail::rules;

constexpr std::pair<const char*, Rules (*)()> families[] = {
    {"cap_rules", cap_rules},
    {"smooth_arc_rules", smooth_arc_rules},
    {"logarithm_arc_rules", logarithm_arc_rules},
    {"large_logarithm_arc_rules", large_logarithm_arc_rules},
    {"high_order_arc_rules", high_order_arc_rules},
    {"short_rules", short_rules},
    {"high_order_short_rules", high_order_short_rules},
    {"chord_rules", chord_rules},
    {"high_order_chord_rules", high_order_chord_rules},
    {"whole_chord_rules", whole_chord_rules},
    {"high_order_whole_chord_rules", high_order_whole_chord_rules}};

/// The arrays of one CapRule; the padding repeats the last node.
void print_numbers(const char* name, int index, Rule rule) {
  while (rule.size() % CapRule::lanes != 0) {
    rule.push_back(rule.back());
    rule.back().weight = 0;
  }
  if (rule.size() > CapRule::longest) {
    throw std::length_error("CapRule::longest is too small");
  }
  std::printf("constexpr double %s_%d[][%zu] = {", name, index, rule.size());
  const auto print_row = [&](auto number) {
    std::printf("\n{");
    for (const Node& node : rule) {
      std::printf("%a,", static_cast<double>(number(node)));
    }
    std::printf("},");
  };
  print_row([](const Node& n) { return n.cosine * n.cosine; });
  print_row([](const Node& n) { return 1 - n.cosine * n.cosine; });
  print_row([](const Node& n) { return n.weight; });
  print_row([](const Node& n) { return n.log_cosine_squared; });
  std::printf("};\n");
}

void print_family(const char* name, const Rules& family) {
  std::printf("namespace {\n");
  int count = 0;
  for (const Rule& rule : family) print_numbers(name, count++, rule);
  std::printf("constexpr CapRule %s_table[] = {\n", name);
  count = 0;
  for (const Rule& rule : family) {
    std::printf("make(%zu, %s_%d),\n", rule.size(), name, count++);
  }
  std::printf("};\n}\nconstinit const CapRules %s(%s_table);\n", name, name);
}

}  // namespace

/// Prints the constants of kernel/cap_rule.hpp and kernel/arc_rule.hpp.
int main() {
  std::printf(R"(#include "libcontact/friction/kernel/arc_rule.hpp"
namespace contact::detail {
namespace {
template <std::size_t padded>
constexpr CapRule make(int size, const double (&row)[4][padded]) {
  return {size, padded, row[0], row[1], row[2], row[3]};
}
}
)");
  for (const auto& [name, make] : families) print_family(name, make());
  std::printf("}\n");
}
