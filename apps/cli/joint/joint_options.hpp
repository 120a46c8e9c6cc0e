#pragma once

#include <map>
#include <numbers>
#include <string>
#include <string_view>
#include <vector>

#include "cli/joint/laws.hpp"
#include "cli/program.hpp"
#include "cli/table.hpp"
#include "libcontact/joint/spec.hpp"

/// Describes a joint on the command line, alike in all programs.
namespace cli {

/// Parts of a joint that a program uses; each includes the parts before it.
enum class JointUse {
  pressure,  ///< a ball's pressure law, and materials if that needs them
  contact,   ///< half-angles: materials, with a size or dimensionless
  friction,  ///< all
};

/// Number of laws of one kind that a program takes.
enum class Laws { one, several };

/// The command line as it was written; "" for options that were not given.
struct JointOptions {
  JointUse use;
  std::vector<std::string> joints = {};
  std::vector<std::string> settings = {};  ///< texts of --set
  std::string pair = {};
  std::string modulus_ratio = {};
  std::string poisson1 = "0.3";
  std::string poisson2 = "0.3";
  /// Options that are keys of a joint file, by their flags.
  std::map<std::string_view, std::string> keys = {};
  std::string loading = {};

  // Empty or none: the joint file decides, else the library's defaults.
  std::vector<std::string> laws = {};
  std::string limit_angle = {};
  std::vector<std::string> pressures = {};
  /// True for a bearing given by its designation alone: steel on steel,
  /// greased.
  bool is_plain_bearing = false;
  bool one_law = false;
  bool one_pressure = false;

  /// The first joint: "ball", "pin" or a file.
  std::string joint() const { return joints.empty() ? "" : joints[0]; }
  bool has(std::string_view flag) const { return !key(flag).empty(); }
  std::string key(std::string_view flag) const {
    const auto found = keys.find(flag);
    return found == keys.end() ? "" : found->second;
  }
  /// Source of the materials, for messages: "--pair FILE"; "" if there is none.
  std::string materials() const;
};

/// Adds --joint, --set and --loading.
void add_joint_options(Program& program, JointOptions& options);
/// Adds the options that describe a joint without a file.
void add_fileless_joint_options(Program& program, JointOptions& options);
/// Adds --law, --limit-angle (except for JointUse::pressure) and --pressure.
void add_law_options(Program& program, JointOptions& options, Laws half_angle,
                     Laws pressure);

/// How a joint differs from the others of a run: a cell of tables.
struct Difference {
  std::string column;  ///< "joint" or a key of --set
  std::string value;   ///< name of the file without its ending, or the key's
};

/// "radius_mm = 20, ..."; "" for the only joint.
std::string difference_text(const std::vector<Difference>& differences);
/// The same for pictures: "radius 20 mm, ..."
std::string difference_label(const std::vector<Difference>& differences);

/// A joint, and the laws asked for.
struct Joint {
  contact::JointSpec spec;
  /// As in the spec; with --modulus-ratio this ratio to the last digit.
  contact::ElasticPair pair;
  /// Without a size (taken as 1 m) only dimensionless loads and pressures
  /// exist.
  bool has_size = true;
  /// False for a pin without a length (taken as 1 m): its loads are per length.
  bool has_length = true;
  std::string title = {};  ///< title of pictures
  std::vector<Difference> differences = {};
  std::string among_several = {};  ///< its name in messages; "" if it is alone
  std::vector<std::string> notes = {};  ///< on options probably mistaken
  std::vector<NamedLaw> laws = {};      ///< not for JointUse::pressure
  std::vector<NamedPressure> pressures = {};

  contact::JointKind kind() const { return spec.geometry.kind(); }
  bool is_pin() const { return kind() == contact::JointKind::pin; }
  /// With a friction, and the first laws or others.
  contact::JointContact contact(contact::FrictionModel friction,
                                std::size_t law = 0,
                                std::size_t pressure = 0) const;
};

/// Title of pictures of several joints: the common part, then the differences.
std::string shared_title(const std::vector<Joint>& joints,
                         const std::string& behind);

/// The joints that the options describe: one for each file of --joint and each
/// combination of the values of --set. Throws contact::Error for options that
/// conflict and values that are not allowed.
std::vector<Joint> make_joints(const JointOptions& options);
/// The only joint.
Joint make_joint(const JointOptions& options);

/// Columns of the differences, then the columns of the joints' tables. Throws
/// contact::Error if these tables have different columns.
std::vector<std::string> joint_columns(
    const std::vector<Joint>& joints,
    const std::vector<std::vector<std::string>>& columns);
/// Writes the cells of a joint's differences.
void write_differences(const std::vector<Difference>& differences,
                       RowWriter& row);

/// Area of the nominal pressure in units of rho^2 (ball) or rho times length
/// (pin); converts pressures in pressure units to multiples of the nominal one.
inline double nominal_area(contact::JointKind kind) {
  return kind == contact::JointKind::ball ? std::numbers::pi : 2;
}

/// Prints the clearances that fits give. Warns once for each reason if joints
/// or their half-angle laws are used outside their ranges.
void warn_of_validity(std::string_view program,
                      const std::vector<Joint>& joints);

}  // namespace cli
