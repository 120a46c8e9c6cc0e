#pragma once

#include <numbers>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "cli/joint/joint_size.hpp"
#include "cli/joint/laws.hpp"
#include "cli/table.hpp"
#include "libcontact/pair/friction_law.hpp"

namespace CLI {
class App;
}  // namespace CLI

/// A joint as all programs take it from the command line.
namespace cli {

/// What a program has use for.
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
  std::vector<std::string> settings = {};  ///< of --set
  /// The one of `joints` that is made.
  std::string joint = {};
  std::string pair = {};
  std::string modulus_ratio = {};
  std::string poisson1 = "0.3";
  std::string poisson2 = "0.3";
  SizeOptions size = {};
  std::string length = {};
  std::string inner_body = {};
  std::string wall = {};
  std::string backing = {};
  std::string loading = {};

  // Without these: what the joint file says, or the library's defaults.
  std::vector<std::string> laws = {};
  std::string limit_angle = {};
  std::vector<std::string> pressures = {};
  bool one_law = false;
  bool one_pressure = false;

  bool names_file() const { return joint.ends_with(".toml"); }
  /// Where the materials are from, for messages: "--pair FILE"; "" if from
  /// nowhere.
  std::string materials() const;
};

/// Adds --joint and what describes a joint without a file.
void add_joint_options(CLI::App& app, JointOptions& options);
/// Adds --law, --limit-angle (but for JointUse::pressure) and --pressure.
void add_law_options(CLI::App& app, JointOptions& options, Laws half_angle,
                     Laws pressure);

/// What --help says of numbers, --loading and --wall.
inline constexpr std::string_view joint_help =
    R"(Numbers are in SI units, angles in degrees, or carry a unit: 50mm, 1.5cm,
0.5in, 2kN, 4MPa, 3N*m, 0.5rad, 100rpm, 5ms; of a list or range all but 0 do, or
none: 1kN:10kN:log5.
Loading: centre (the force enters the ball or pin by a stem or shaft, or is its
own weight; the default) or back:PSI (a loose ball or roller pressed from behind
on a patch of half-angle PSI, 0 to 90 deg, by a uniform pressure). Only the
half-angle law exact knows the latter, its name in the output is then
exact_back:PSI; the pressure law exact follows it, mixture is refused.
Wall: --wall T makes the seat or hole a layer of its material, T thick, on
--backing rigid, held (free, but for a traction that balances the load) or a
material's .toml file. Without a radius T is a number, thickness over radius.
More layers and coatings are in joint files: [wall] and [[coating]]. With them
all laws are exact, others are refused.
Seat: it has no end here. Compare the half-angle with what the real one covers:
asin(C/d) on each side by a ring of width C on a ball of diameter d, 20 to 30 deg
of spherical plain bearings. A wider contact is pressed harder than printed.
)";

/// In what a joint differs from the others of a run: a cell of tables.
struct Difference {
  std::string column;  ///< "joint" or a key of --set
  std::string value;   ///< name of the file without its ending, or the key's
};

/// "radius_mm = 20, ..."; "" for the only joint.
std::string difference_text(const std::vector<Difference>& differences);

/// What is known of a joint, and its laws.
struct Joint {
  contact::JointKind kind;
  contact::ElasticPair pair;
  /// Without it only dimensionless loads and pressures.
  std::optional<contact::JointGeometry> geometry = {};
  /// Of a pin without one loads are per length; its geometry has 1 m.
  bool has_length = true;
  /// What that is from, if a fit.
  std::optional<contact::Fit> fit = {};
  std::optional<contact::FrictionModel> friction = {};
  std::string half_angle_law = std::string(contact::default_half_angle_law);
  contact::HalfAngleOptions half_angle_options = {};
  std::string pressure_law = std::string(contact::default_pressure_law);
  std::vector<Difference> differences = {};
  contact::ContactConditions conditions = {};
  std::vector<std::string> notes = {};  ///< on options that are hardly meant
  std::string name = {};                ///< of a joint file
  std::string materials = {};           ///< of a file of materials

  /// Those that are asked for; half-angle laws not for JointUse::pressure.
  std::vector<NamedLaw> laws = {};
  std::vector<NamedPressure> pressures = {};

  /// Of pictures.
  std::string title() const;
};

/// The joints that the options describe: one, or one for each file of --joint
/// and combination of the values of --set. Throws contact::Error if they do
/// not fit together or a value is not allowed.
std::vector<Joint> make_joints(const JointOptions& options);
/// The only one.
Joint make_joint(const JointOptions& options);

/// Columns of the differences, then those of the tables of some joints, which
/// have to be the same. Throws contact::Error if they are not.
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
