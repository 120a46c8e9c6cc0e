// Cycles for hinge-duty: any text gives either a cycle with forces and rates,
// or one contact::Error. If the first byte of the input is odd, the joint is a
// pin; the next bit selects an OpenSim table.

#include "fuzz.hpp"
#include "programs/duty/cycle_file.hpp"

using contact::test::check;

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  if (size == 0) return 0;
  const bool is_pin = (data[0] & 1U) != 0;
  const bool is_sto = (data[0] & 2U) != 0;
  hinge_duty::Options options;
  options.cycle = contact::test::written(
      {reinterpret_cast<const char*>(data) + 1, size - 1},
      is_sto ? ".sto" : ".csv");
  if (!is_pin && (data[0] & 4U) != 0) options.euler = "XYZ";
  if (is_sto) {
    options.force_columns = "fx,fy,fz";
    options.angle_columns = is_pin ? "a" : "a,b,c";
    options.euler = is_pin ? "" : "XYZ";
  }
  try {
    const contact::DutyCycle cycle =
        hinge_duty::read_cycle(options, is_pin).cycle;
    check(cycle.period() > 0);
  } catch (const contact::Error&) {
    // Its names are the file's own: cli::Program prints them on one line.
  }
  return 0;
}
