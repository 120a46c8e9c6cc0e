#include "cli/joint/tilted_pins.hpp"

#include <fmt/format.h>

#include <limits>
#include <variant>

#include "cli/joint/joint_reports.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/report.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/finite_pin/finite_pin.hpp"
#include "libcontact/joint/contact_notes.hpp"
#include "libcontact/quantities/finite_pin.hpp"
#include "libcontact/quantities/tables.hpp"

namespace cli {

using contact::Dimension;
using contact::JointSolution;
using contact::PinLie;
using Eigen::Vector3d;

void add_tilt_options(Program& program, TiltOptions& o, std::string_view needs,
                      std::string_view excludes) {
  program.add_check([&program] {
    if (program.has("--tilt") && program.has("--load-at")) {
      refuse_beside("--tilt", "--load-at");
    }
  });
  program.add(
      "Tilt",
      {{"--tilt", &o.tilt, "ANGLES",
        "tilt of a finite-length pin in the plane of the load, deg, -10 to 10",
        needs, excludes},
       {"--twist", number("--twist", o.twist, Dimension::angle, allowed_tilt),
        "ANGLE", "tilt across that plane, deg; default 0", "--tilt"},
       {"--load-at", &o.load_at, "VALUES",
        "place of the load along a pin, m from its middle", needs, excludes}});
}

namespace {

const Joint& checked(const Joint& joint, const char* flag) {
  if (!joint.has_size) refuse_without(flag, "--radius and --clearance");
  if (joint.is_pin() && !joint.has_length) refuse_without(flag, "--length");
  const std::string why = contact::FinitePin::refusal(joint.spec, flag);
  if (!why.empty()) throw contact::Error(said_of(joint, why));
  return joint;
}

Sweep sweep_of(const TiltOptions& options, const Joint& joint) {
  const double half = joint.spec.geometry.length() / 2;
  if (!options.is_placed()) {
    return {"--tilt", options.tilt, allowed_tilt, Dimension::angle};
  }
  return {"--load-at", options.load_at, {-half, half, "m"}, Dimension::length};
}

}  // namespace

Placements::Placements(const TiltOptions& options, const Joint& joint)
    : is_placed_(options.is_placed()),
      twist_(options.twist.value_or(0) * contact::degree),
      sweep_(sweep_of(options, checked(joint, options.flag()))) {}

contact::Placement Placements::operator[](std::size_t index) const {
  contact::Placement placement;
  if (is_placed_) {
    placement.place = sweep_[index];
  } else {
    placement.tilt = Vector3d(contact::degree * sweep_[index], twist_, 0);
  }
  return placement;
}

}  // namespace cli
