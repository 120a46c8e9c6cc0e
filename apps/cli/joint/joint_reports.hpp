#pragma once

#include <string>
#include <vector>

#include "cli/joint/joint_options.hpp"
#include "cli/stream/report.hpp"
#include "libcontact/base/error.hpp"

/// Reports on several joints.
namespace cli {

/// Writes the report of a single joint with a line for each number. With
/// several joints it has a row for each: the differences, the numbers under
/// their names, and the numbers beside them as NAME_COLUMN. Throws
/// contact::Error if the reports have different lines.
void write_reports(const std::vector<Joint>& joints,
                   const std::vector<Report>& reports, Output& output,
                   const TableStyle& style);

/// Message on one joint; names the joint if there are several.
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

/// Throws contact::Error if joints that share an input differ in kind.
void check_one_kind(const std::vector<Joint>& joints);

}  // namespace cli
