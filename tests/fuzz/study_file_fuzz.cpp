// Study files: any text either gives a plan whose distributions have quantiles
// and which gives each run its numbers, or one contact::Error.
#include <cmath>
#include <string>
#include <vector>

#include "fuzz.hpp"
#include "study/plan/design.hpp"
#include "study/plan/plan.hpp"

using contact::test::check;

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  contact::test::read_or_one_line(
      [&] {
        const study::Plan plan = study::parse_plan(text, "fuzz");
        check(plan.runs > 0 && !plan.dispersions.empty());
        for (const study::Dispersion& d : plan.dispersions) {
          double last = d.quantile(study::lowest_uniform);
          for (const double u : {0.25, 0.5, 0.75, study::highest_uniform}) {
            const double x = d.quantile(u);
            check(std::isfinite(x) && x >= last);
            last = x;
          }
        }
      },
      "fuzz");
  return 0;
}
