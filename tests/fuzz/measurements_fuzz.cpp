// Measured moments for hinge-identify: any text is a list of finite moments
// with errors above 0, or one contact::Error. Input whose first byte is odd is
// of a pin.

#include "fuzz.hpp"
#include "programs/identify/data.hpp"

using contact::test::check;

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  if (size == 0) return 0;
  hinge_identify::Options options;
  options.data = contact::test::written(
      {reinterpret_cast<const char*>(data) + 1, size - 1}, ".csv");
  if ((data[0] & 2U) != 0) options.sigma_rel = 0.01;
  contact::test::read_or_one_line(
      [&] {
        contact::IdentifyOptions of_fit;
        for (const contact::MeasuredMoment& m :
             hinge_identify::read_data(options, (data[0] & 1U) != 0, of_fit)) {
          check(m.sigma > 0);
        }
      },
      "");
  return 0;
}
