// hinge-angle --impact: impacts in a joint with play.
#include <fmt/format.h>

#include <limits>
#include <set>
#include <string>

#include "cli/output.hpp"
#include "cli/stream/report.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/play/hunt_crossley.hpp"
#include "libcontact/play/impact.hpp"
#include "programs/angle/play.hpp"

namespace hinge_angle {

cli::ExitStatus run_impact(const PlayOptions& options,
                           const cli::JointOptions& joint_options,
                           const cli::OutputOptions& output) {
  const cli::Joint joint = sized_joint(joint_options, "--impact");
  const cli::Sweep speeds("--speed", options.speed,
                          {0, std::numeric_limits<double>::infinity(), "m/s"},
                          contact::Dimension::velocity);
  const contact::JointImpact impact(joint.spec);
  cli::warn_of_validity("hinge-angle", {joint});
  const contact::ApproximateRestitution others =
      contact::approximate_restitution(options.restitution);
  std::set<std::string> notes;
  std::size_t without = 0;
  cli::write_table(
      output,
      {"speed_m_per_s", "restitution", "damping_s_per_m", "penetration_m",
       "elastic_force_N", "peak_force_N", "theta0_deg", "p_peak_Pa",
       "compression_s", "restitution_s", "restitution_lankarani_nikravesh",
       "restitution_hunt_crossley", "restitution_flores"},
      [&](cli::RowWriter& row) {
        for (std::size_t i = 0; i < speeds.size(); ++i) {
          const double speed = speeds[i];
          const auto damping = contact::HuntCrossley::from_restitution(
              options.restitution, options.reference_speed.value_or(speed));
          const contact::Impact is = impact(damping, options.mass, speed);
          if (std::isnan(is.penetration)) ++without;
          for (const std::string& note : impact.notes(is, options.density)) {
            notes.insert(speeds.size() == 1
                             ? note
                             : fmt::format("at {:.4g} m/s: {}", speed, note));
          }
          for (const double value :
               {speed, is.restitution, damping.damping(), is.penetration,
                is.elastic_force, is.peak_force,
                is.half_angle / contact::degree, is.peak_pressure,
                is.compression_time, is.restitution_time,
                others.lankarani_nikravesh, others.hunt_crossley,
                others.flores}) {
            row.number(value);
          }
          row.end();
        }
      });
  cli::note("hinge-angle",
            options.reference_speed
                ? fmt::format("restitution {} at {} m/s: with this damping the "
                              "restitution falls with the speed",
                              options.restitution, *options.reference_speed)
                : fmt::format("restitution {} at every speed: each impact has "
                              "a damping of its own",
                              options.restitution));
  for (const std::string& note : notes) cli::warn("hinge-angle", note);
  return without > 0 ? cli::some_bad : cli::all_good;
}

}  // namespace hinge_angle
