// Study files: any text either gives a plan whose distributions have quantiles
// and which gives each run its numbers, or one contact::Error.
#include <cmath>

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
          for (const double u :
               {study::lowest_uniform, 0.5, study::highest_uniform}) {
            check(std::isfinite(d.quantile(u)));
          }
        }
      },
      "fuzz");
  return 0;
}
