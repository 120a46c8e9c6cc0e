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

/// A joint as all programs take it from the command line.
namespace cli {

/// Parts of a joint that a program uses; each includes all before it.
enum class JointUse {
  pressure,  ///< a ball's pressure law, and materials if that needs them
  contact,   ///< half-angles: materials, with a size or dimensionless
  friction,  ///< all
};

/// How many laws of a kind a program takes.
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

  // Without these: what the joint file says, or the library's defaults.
  std::vector<std::string> laws = {};
  std::string limit_angle = {};
  std::vector<std::string> pressures = {};
  /// A bearing by its designation alone, of steel in steel and greased.
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
/// Adds what describes a joint without a file.
void add_fileless_joint_options(Program& program, JointOptions& options);
/// Adds --law, --limit-angle (but for JointUse::pressure) and --pressure.
void add_law_options(Program& program, JointOptions& options, Laws half_angle,
                     Laws pressure);

/// Difference of a joint from the others of a run: a cell of tables.
struct Difference {
  std::string column;  ///< "joint" or a key of --set
  std::string value;   ///< name of the file without its ending, or the key's
};

/// "radius_mm = 20, ..."; "" for the only joint.
std::string difference_text(const std::vector<Difference>& differences);
/// The same for pictures: "radius 20 mm, ..."
std::string difference_label(const std::vector<Difference>& differences);

/// A joint, and the laws that are asked for.
struct Joint {
  contact::JointSpec spec;
  /// The spec's; of --modulus-ratio with this ratio to the last digit.
  contact::ElasticPair pair;
  /// Without a size, which is 1 m then, only dimensionless loads and pressures.
  bool has_size = true;
  /// False for a pin without a length, which is 1 m then: loads are per length.
  bool has_length = true;
  std::string title = {};  ///< title of pictures
  std::vector<Difference> differences = {};
  std::string among_several = {};  ///< its name in messages; "" if it is alone
  std::vector<std::string> notes = {};  ///< on options that are hardly meant
  std::vector<NamedLaw> laws = {};      ///< not for JointUse::pressure
  std::vector<NamedPressure> pressures = {};

  contact::JointKind kind() const { return spec.geometry.kind(); }
  bool is_pin() const { return kind() == contact::JointKind::pin; }
  /// With a friction, and the first or other laws.
  contact::JointContact contact(contact::FrictionModel friction,
                                std::size_t law = 0,
                                std::size_t pressure = 0) const;
};

/// Text above pictures of joints: their common title, and the rest behind it.
std::string shared_title(const std::vector<Joint>& joints,
                         const std::string& behind);

/// The joints that the options describe: one, or one for each file of --joint
/// and combination of the values of --set. Throws contact::Error if they do
/// not fit together or a value is not allowed.
std::vector<Joint> make_joints(const JointOptions& options);
/// The only one.
Joint make_joint(const JointOptions& options);

/// Columns of the differences, then the columns of the tables of some joints,
/// which must be the same. Throws contact::Error if they are not.
std::vector<std::string> joint_columns(
    const std::vector<Joint>& joints,
    const std::vector<std::vector<std::string>>& columns);
/// The cells of a joint's differences.
void write_differences(const std::vector<Difference>& differences,
                       RowWriter& row);

/// Area of the nominal pressure in units of rho^2 (ball) or of rho times the
/// length (pin): from pressures in pressure units to those over the nominal.
inline double nominal_area(contact::JointKind kind) {
  return kind == contact::JointKind::ball ? std::numbers::pi : 2;
}

/// Says which clearances fits give; warns of the use of joints and of their
/// half-angle laws outside their ranges, once for each reason.
void warn_of_validity(std::string_view program,
                      const std::vector<Joint>& joints);

}  // namespace cli
