#pragma once

#include <string>
#include <vector>

#include "cli/joint/joint_options.hpp"
#include "cli/stream/report.hpp"
#include "libcontact/base/error.hpp"

/// Reports on each of several joints.
namespace cli {

/// The report of the only joint, a line for each of its numbers, or of several
/// joints a row for each: its differences, then the numbers under their names,
/// and the numbers beside them as NAME_COLUMN. Throws contact::Error if the
/// reports have different lines.
void write_reports(const std::vector<Joint>& joints,
                   const std::vector<Report>& reports, Output& output,
                   const TableStyle& style);

/// Message on one joint, which is named if there are several.
std::string said_of(const Joint& joint, const std::string& text);

/// Result of `make`; its contact::Error names the joint.
template <class Make>
auto made_of(const Joint& joint, const Make& make) {
  try {
    return make();
  } catch (const contact::Error& error) {
    throw contact::Error(said_of(joint, error.what()));
  }
}

/// Throws contact::Error if joints that share an input are not of one kind.
void check_one_kind(const std::vector<Joint>& joints);

}  // namespace cli
