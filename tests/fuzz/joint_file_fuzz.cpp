// Joint and material pair files: any text either gives an object that can be
// used or one contact::Error with a message of one line that starts with the
// file's name.
#include <cmath>
#include <cstdint>
#include <cstdlib>
#include <string_view>

#include "fuzz.hpp"
#include "libcontact/files/joint_file.hpp"

using contact::test::check;

namespace {

template <class Read>
void read_or_one_line(const Read& read) {
  contact::test::read_or_one_line(read, "fuzz:");
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  read_or_one_line([&] {
    const contact::JointSpec joint = contact::parse_joint(text, "fuzz");
    const auto law = joint.make_half_angle_law();
    // Without clearance contact ends nowhere, and no load is load parameter
    // 0 from below.
    const double clearance = joint.geometry.relative_clearance();
    check(std::isfinite(clearance) && clearance < 1);
    if (clearance > 0) check(law->half_angle(0).half_angle == 0);
    check(joint.make_pressure_law()->peak(0.5) > 0);
    joint.validity_notes();
  });
  read_or_one_line([&] {
    const auto pair = contact::parse_material_pair(text, "fuzz");
    check(pair.elastic.contact_modulus() > 0);
    check(pair.elastic.modulus_ratio() >= 0);
  });
  return 0;
}
