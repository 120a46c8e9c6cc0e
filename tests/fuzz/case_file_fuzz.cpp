// Case files: any text either gives a case whose bodies make a system or one
// contact::Error with a message of one line that starts with the file's name.
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "fuzz.hpp"
#include "separation/case/case_reader.hpp"
#include "separation/case/system_of.hpp"
#include "separation/simulation/case_forces.hpp"

using contact::test::check;

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  contact::test::read_or_one_line(
      [&] {
        const separation::Case c = separation::parse_case(text, "fuzz");
        check(separation::system_of(c).size() ==
              static_cast<int>(c.bodies.size()));
        check(c.end_time > 0 && c.output_step > 0);
        const separation::CaseForces forces(c, separation::History(c));
        check(forces.next_break(0) > 0);
        for (const separation::WatchedPair& pair : c.clearance) {
          check(pair.a < pair.b && !c.rigid_body(pair.a).shapes.empty() &&
                !c.rigid_body(pair.b).shapes.empty());
        }
      },
      "fuzz:");
  return 0;
}
