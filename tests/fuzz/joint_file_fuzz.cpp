// Joint and material pair files: any text either gives an object that can be
// used or one contact::Error with a message of one line that starts with the
// file's name.
#include <cstdint>
#include <cstdlib>
#include <string>
#include <string_view>

#include "libcontact/base/error.hpp"
#include "libcontact/files/joint_file.hpp"

namespace {

void check(bool holds) {
  if (!holds) std::abort();
}

template <class Read>
void read_or_one_line(const Read& read) {
  try {
    read();
  } catch (const contact::Error& error) {
    const std::string message = error.what();
    check(message.starts_with("fuzz:"));
    check(message.find_first_of("\n\r") == message.npos);
  }
}

}  // namespace

// NOLINTNEXTLINE(readability-identifier-naming): libFuzzer calls it so.
extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data,
                                      std::size_t size) {
  const std::string_view text(reinterpret_cast<const char*>(data), size);
  read_or_one_line([&] {
    const contact::JointSpec joint = contact::parse_joint(text, "fuzz");
    const auto law = joint.make_half_angle_law();
    check(law->half_angle(0).half_angle == 0);
    check(joint.make_pressure_law()->peak(0.5) > 0);
    check(joint.geometry.relative_clearance() > 0);
    joint.validity_notes();
  });
  read_or_one_line([&] {
    const auto pair = contact::parse_material_pair(text, "fuzz");
    check(pair.elastic.contact_modulus() > 0);
    check(pair.elastic.modulus_ratio() >= 0);
  });
  return 0;
}
