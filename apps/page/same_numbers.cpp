#include "page/same_numbers.hpp"

#include "libcontact/base/text.hpp"

namespace page {
namespace {

using contact::detail::message;

std::string listed(const Eigen::Vector3d& v) {
  return message("{}, {}, {}", v[0], v[1], v[2]);
}

constexpr std::string_view python = R"(import libcontact

joint = libcontact.Joint.from_file("joint.toml"){}
s = joint.solve([{}], [{}])  # N, rad/s
print(s.half_angle, "rad", s.peak_pressure, "Pa", s.friction_moment, "N m")
)";

constexpr std::string_view cpp = R"(#include <cstdio>
#include <libcontact/{}.hpp>
#include <libcontact/{}.hpp>

int main() {{
  const contact::Joint joint(contact::read_joint("joint.toml"){});
  const contact::JointSolution s = joint.solve(
      {{.reaction = {{{}}},             // N
       .angular_velocity = {{{}}}}});  // rad/s
  std::printf("%.17g rad %.17g Pa %.17g N m\n", s.half_angle, s.peak_pressure,
              s.friction_moment.norm());
}}
)";

}  // namespace

SameNumbers same_numbers(const hinge_joint::Input& input, bool is_pin,
                         std::string_view left_out) {
  const std::string without =
      left_out.empty() ? "" : message(".without_{}()", left_out);
  const std::string force = listed(input.force);
  const std::string turn = listed(input.turn);
  return {message("hinge-joint --joint joint.toml --reaction {}{} --rate {} "
                  "--pv --summary{}",
                  input.given->force,
                  is_pin ? "" : message(" --beta {}", input.given->angle_deg),
                  input.turn[2],
                  left_out.empty() ? "" : message(" --without-{}", left_out)),
          message(python, without, force, turn),
          message(cpp, "contact", "files", without, force, turn)};
}

}  // namespace page
