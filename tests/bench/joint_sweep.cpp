// The joint solver on random inputs, a million unless the first argument says
// another number (the second one: the seed); fails as the test does.
#include "support/joint_sweep.hpp"

#include <cstdio>
#include <cstdlib>

#include "libcontact/base/units.hpp"

namespace {

void print(const char* what, double value) {
  std::printf("%-58s %.2e\n", what, value);
}

void print_count(const char* what, std::uint64_t value) {
  std::printf("%-58s %llu\n", what, static_cast<unsigned long long>(value));
}

void print_histogram(const char* what,
                     const contact::test::Histogram& histogram) {
  std::printf("%s: mean %.2f, largest %d\n  %s\n", what, histogram.mean(),
              histogram.max(), histogram.text().c_str());
}

// Shares on which the fixed point fails (leaves g <= b) or needs over 50 steps.
void print_map(const contact::test::JointSweep& s) {
  std::printf("fixed point: %% that fail / %% that need more than 50 steps\n");
  std::printf("  f \\ |b - 90 deg|");
  for (const double edge : s.b_edges_deg) std::printf("   to %-6g", edge);
  std::printf("\n");
  for (std::size_t i = 0; i < s.f_edges.size(); ++i) {
    std::printf("  to %-14g", s.f_edges[i]);
    for (const auto& bin : s.map[i]) {
      if (bin.inputs == 0) {
        std::printf("     -      ");
        continue;
      }
      const double all = 0.01 * static_cast<double>(bin.inputs);
      std::printf(" %5.1f/%-5.1f", static_cast<double>(bin.fails) / all,
                  static_cast<double>(bin.slow) / all);
    }
    std::printf("\n");
  }
}

}  // namespace

int main(int argc, char** argv) {
  const std::uint64_t inputs =
      argc > 1 ? std::strtoull(argv[1], nullptr, 10) : 1'000'000;
  const std::uint64_t seed =
      argc > 2 ? std::strtoull(argv[2], nullptr, 10) : 11;
  const contact::test::JointSweep s = contact::test::joint_sweep(inputs, seed);
  print_count("random inputs, each cold and warm", s.inputs);
  print_count("not converged", s.not_ok);
  print("largest |f/tan g - 1| of the contact returned", s.residual);
  print("largest |R - R_n n - R_t|/R", s.reaction);
  print("largest friction power above 0, over rho R |Dw|", s.power);
  print("largest g - min(b, 180 deg - b), rad, above 0", s.angle_excess);
  print_histogram("evaluations, cold", s.cold);
  print_histogram("evaluations, warm, moved by 1e-3", s.warm);
  print_count("inputs scanned for further roots", s.scanned);
  print_count("with several roots", s.several_roots);
  if (s.several_roots > 0) {
    print("smallest limit half-angle of them, deg",
          s.several_roots_limit / contact::degree);
  }
  print_count("random paths of 100 steps", s.paths);
  print("largest change of inputs 1e-12 apart on them (scaled)", s.jump);
  print_count("paths that jump from one of several roots to another", s.folds);
  print_count("fixed point: leaves g <= b", s.fixed_point_fails);
  print_count("fixed point: more than 50 steps", s.fixed_point_slow);
  print_count("fixed point: of them not within 500", s.fixed_point_never);
  print_map(s);
  print_histogram("steps of the fixed point where it converges", s.fixed_point);
  const bool good =
      s.not_ok == 0 && s.residual <= 1e-12 && s.reaction <= 1e-12 &&
      s.power == 0 && s.angle_excess <= 5e-16 &&
      s.several_roots_limit > 90 * contact::degree && s.jump <= 1e-11;
  std::printf("%s\n", good ? "all bars met" : "A BAR IS MISSED");
  return good ? 0 : 1;
}
