#pragma once

#include <optional>
#include <string>
#include <vector>

#include "cli/program.hpp"
#include "libcontact/duty/joint_cycle.hpp"
#include "libcontact/duty/wear_in.hpp"
#include "libcontact/duty/wear_map.hpp"

namespace hinge_duty {

/// The wear of one body over one period.
struct BodyWear {
  contact::JointBody part;
  std::string body;         ///< "carrier" or "body"
  std::string surface;      ///< "seat" or "inner"
  std::optional<double> k;  ///< mm^3/(N m), if it was given
  std::vector<Eigen::Vector3d> points;
  std::vector<contact::WearMap::Wear> wear;
  contact::WearMap::Deepest deepest;
  double volume_defect;
};

/// What wore off a body that was weighed.
struct MeasuredWear {
  double volume;                ///< mm^3
  std::optional<double> error;  ///< standard error of it
  double cycles;
};

/// A line for each quantity of the cycle.
/// @param measured  for k, if there is one
/// @param worn      of wear_in(); may be empty
void write_summary(const contact::JointCycle& cycle,
                   const std::vector<BodyWear>& wear,
                   const std::optional<MeasuredWear>& measured,
                   const std::vector<contact::WornState>& worn,
                   cli::Output& output, const cli::OutputOptions& options);
/// A row for each block of cycles, and one for the end.
void write_blocks(const std::vector<contact::WornState>& worn,
                  cli::Output& output, const cli::OutputOptions& options);
/// A row for each row of the cycle's file.
void write_states(const contact::JointCycle& cycle, cli::Output& output,
                  const cli::OutputOptions& options);
/// A row for each point that wears.
void write_map(const std::vector<BodyWear>& wear, bool is_pin,
               cli::Output& output, const cli::OutputOptions& options);
/// Draws reaction, friction moment, and the largest p and p v over the contact.
/// @return "" or why there is no picture
std::string draw_cycle(const contact::JointCycle& cycle,
                       const std::string& title, const std::string& file);

}  // namespace hinge_duty
