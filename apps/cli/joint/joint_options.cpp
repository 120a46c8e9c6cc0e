#include "cli/joint/joint_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <iterator>
#include <set>

#include "cli/joint/key_settings.hpp"
#include "cli/joint/shipped.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/files/joint_tables.hpp"
#include "libcontact/files/tables/material_table.hpp"

namespace cli {
namespace {

using contact::Dimension;
using contact::JointKind;

bool is_file(const std::string& name) { return name.ends_with(".toml"); }

// An option that is a key of a joint file in memory.
struct KeyOption {
  const char* flag;
  std::string_view key;
  Dimension dimension;  ///< number: a text
  /// Largest plausible length, m: a larger number without a unit is a slip.
  double most;
  JointUse use;  ///< and later ones
  const char* kind;
  const char* meaning;
  std::string_view needs = {};
  std::string_view excludes = {};

  std::string_view flag_name() const { return flag; }
};

constexpr std::string_view wall_key = "wall.layer";

constexpr Dimension as_text = Dimension::number;
constexpr Dimension as_length = Dimension::length;
constexpr Dimension as_temperature = Dimension::temperature;

constexpr KeyOption key_options[] = {
    {"--radius", "geometry.radius", as_length, 1, JointUse::contact, "LENGTH",
     "radius of the ball or pin",
     "--pair; --clearance, --diametral-clearance or --interference",
     "--diameter --hole"},
    {"--diameter", "geometry.diameter", as_length, 2, JointUse::contact,
     "LENGTH", "diameter instead of --radius; nominal size of a fit",
     "--pair; --clearance, --diametral-clearance, --interference, or --hole "
     "and "
     "--shaft"},
    {"--clearance", "geometry.radial_clearance", as_length, 1,
     JointUse::contact, "LENGTH", "difference of the radii",
     "--pair; --radius or --diameter",
     "--diametral-clearance --hole --interference"},
    {"--diametral-clearance", "geometry.diametral_clearance", as_length, 2,
     JointUse::contact, "LENGTH", "difference of the diameters",
     "--pair; --radius or --diameter", "--hole --interference"},
    {"--interference", "geometry.radial_interference", as_length, 1,
     JointUse::contact, "LENGTH",
     "instead of a clearance: overlap of the radii, positive",
     "--pair; --radius or --diameter", "--hole"},
    {"--hole", "geometry.hole", as_text, 0, JointUse::contact, "NAME",
     "instead of a clearance: hole of a fit by ISO 286, such as H7",
     "--pair; --shaft; --diameter"},
    {"--shaft", "geometry.shaft", as_text, 0, JointUse::contact, "NAME",
     "the ball or pin in this hole, such as g6", "--pair; --hole"},
    {"--fit-clearance", "geometry.clearance", as_text, 0, JointUse::contact,
     "NAME",
     "of a fit or bearing: minimum, mean (default) or maximum clearance",
     "--pair; --hole or --bearing"},
    {"--bearing", "geometry.designation", as_text, 0, JointUse::contact, "NAME",
     "instead of size and clearance: a spherical plain bearing, such as GE50ES",
     "",
     "--radius --diameter --clearance --diametral-clearance --interference "
     "--hole"},
    {"--group", "geometry.clearance_group", as_text, 0, JointUse::contact,
     "NAME", "of a bearing: C2, CN (default) or C3", "--bearing"},
    {"--length", "geometry.length", as_length, 2, JointUse::contact, "LENGTH",
     "length of a pin", "--radius or --diameter"},
    {"--temperature", "temperature", as_temperature, 0, JointUse::contact,
     "TEMPERATURE", "temperature of both bodies, C; their materials expand",
     "--radius or --diameter", "--inner-temperature --outer-temperature"},
    {"--inner-temperature", "inner_temperature", as_temperature, 0,
     JointUse::contact, "TEMPERATURE", "temperature of the ball or pin",
     "--radius or --diameter; --outer-temperature"},
    {"--outer-temperature", "outer_temperature", as_temperature, 0,
     JointUse::contact, "TEMPERATURE", "temperature of the seat or hole",
     "--radius or --diameter; --inner-temperature"},
    {"--reference-temperature", "reference_temperature", as_temperature, 0,
     JointUse::contact, "TEMPERATURE",
     "temperature at which the clearance is given; default 20 C",
     "--temperature or --inner-temperature"},
    {"--inner-body", "inner_body", as_text, 0, JointUse::friction, "NAME",
     "body with the ball or pin: carrier (default) or body"},
    {"--wall", wall_key, as_length, 2, JointUse::pressure, "LENGTH",
     "thickness of the seat or hole; default: unbounded", "--backing"},
    {"--backing", "wall.backing", as_text, 0, JointUse::pressure, "NAME|FILE",
     "body behind the wall: rigid, held or a material", "--wall"}};

// The key of a joint file that corresponds to an option.
contact::KeySetting setting_of(const KeyOption& option, const std::string& text,
                               bool has_size) {
  const bool wall = option.key == wall_key;
  if (option.dimension == Dimension::number) {
    return {std::string(option.key), fmt::format("'{}'", text),
            given(option.flag, text)};
  }
  if (wall && !has_size && !parse_number(text)) {
    refuse(option.flag, text, "a number, thickness over radius");
  }
  contact::KeySetting number = quantity_key(
      option.flag, text, wall ? "thickness" : option.key, option.dimension);
  if (!wall) return number;
  return {std::string(wall_key),
          fmt::format("[{{ {} = {} }}]", number.key, number.value),
          number.origin};
}

// Notes on large numbers without a unit, which are in m.
std::vector<std::string> length_notes(const JointOptions& o) {
  std::vector<std::string> notes;
  for (const KeyOption& option : key_options) {
    const std::string text = o.key(option.flag);
    const auto plain = parse_number(text);
    if (!plain || option.dimension != Dimension::length) continue;
    if (*plain <= option.most) continue;
    notes.push_back(
        fmt::format("{0} {1} is {1} m; {1}mm is {1} mm", option.flag, text));
  }
  return notes;
}

// Moduli for a known ratio alone, which no joint file can express.
contact::ElasticPair pair_of_modulus_ratio(const JointOptions& o) {
  using contact::detail::infinity;
  constexpr Allowed poisson{0, 0.5, ""};
  return contact::ElasticPair::from_modulus_ratio(
      parse_value("--modulus-ratio", o.modulus_ratio, {0, infinity, ""}),
      parse_value("--poisson1", o.poisson1, poisson),
      parse_value("--poisson2", o.poisson2, poisson));
}

contact::MaterialPair materials_of(const JointOptions& o) {
  if (!o.modulus_ratio.empty()) return {"", pair_of_modulus_ratio(o), {}};
  if (!o.pair.empty()) {
    const std::string file = shipped_file(Shipped::materials, o.pair);
    if (!is_file(file) && !std::filesystem::exists(file)) {
      throw contact::Error(contact::detail::unknown(
          "pair", o.pair, shipped_names(Shipped::materials)));
    }
    return contact::read_material_pair(file);
  }
  const char* either =
      o.use == JointUse::friction ? "--pair" : "--pair or --modulus-ratio";
  if (!o.joints.empty()) refuse_without(given("--joint", o.joint()), either);
  if (o.has("--wall")) refuse_without("--wall", either);
  // A pressure law without materials accepts any pair.
  return {"", contact::ElasticPair::from_modulus_ratio(1, 0.3, 0.3), {}};
}

// hinge-table uses a ball by default.
bool is_pin(const JointOptions& o) {
  const std::string& kind = o.joint();
  if (kind == "pin" || kind == "ball" || kind.empty()) return kind == "pin";
  refuse("--joint", kind,
         "ball, pin or a .toml file" +
             shipped_hint(Shipped::joints, kind, {"ball", "pin"}));
}

// Checks the size of a joint without a file; false if it has none.
bool check_size(const JointOptions& o, bool pin) {
  const bool has_size =
      o.has("--radius") || o.has("--diameter") || o.has("--bearing");
  const bool friction = o.use == JointUse::friction;
  if (friction && !has_size) {
    refuse_without(given("--joint", o.joint()),
                   "a size: --radius and --clearance, --diameter, or "
                   "--bearing");
  }
  if (friction && pin && !o.has("--length")) {
    refuse_without("--joint pin", "--length");
  }
  if (!pin && o.has("--length")) refuse_without("--length", "--joint pin");
  return has_size;
}

// The table of a joint file that holds a material's file; "" for a word.
std::string backing_table(const JointOptions& o) {
  const std::string backing =
      shipped_file(Shipped::backings, o.key("--backing"));
  if (is_file(backing)) {
    if (!o.modulus_ratio.empty()) {
      refuse_beside(given("--backing", backing), "--modulus-ratio");
    }
    contact::read_material(backing);  // its messages name the file
    return "[wall.backing]\n" +
           contact::TomlTable::from_file(backing, contact::material_keys())
               .toml_text();
  }
  if (!backing.empty() && backing != "rigid" && backing != "held") {
    refuse("--backing", backing,
           "rigid, held or a material's .toml file" +
               shipped_hint(Shipped::backings, backing, {"rigid", "held"}));
  }
  return "";
}

// The unit of a rejected number may be wrong.
contact::JointSpec spec_of(const std::string& text,
                           const contact::KeySettings& settings,
                           const contact::MaterialPair& materials,
                           const JointOptions& o) {
  try {
    return contact::joint_of_file(
        contact::TomlTable::from_text(text, "", contact::joint_keys(), {},
                                      settings),
        &materials);
  } catch (const contact::Error& error) {
    const std::vector<std::string> notes = length_notes(o);
    if (notes.empty()) throw;
    throw contact::Error(fmt::format("{}; {}", error.what(), notes[0]));
  }
}

// A joint file in memory; its keys are the options.
Joint joint_from_options(const JointOptions& o) {
  const bool pin = is_pin(o);
  const contact::MaterialPair materials = materials_of(o);
  const bool has_size = check_size(o, pin);
  const std::string backing = backing_table(o);
  std::string text = fmt::format(
      "name = \"joint\"\nkind = \"{}\"\n[geometry]\n", pin ? "pin" : "ball");
  if (pin) text += "length_m = 1\n";
  if (!has_size) text += "radius_m = 1\nradial_clearance_m = 1e-3\n";
  text += backing;
  contact::KeySettings settings;
  for (const KeyOption& option : key_options) {
    const std::string given = o.key(option.flag);
    if (given.empty() || (!backing.empty() && option.key == "wall.backing")) {
      continue;
    }
    settings.push_back(setting_of(option, given, has_size));
  }
  contact::JointSpec spec = spec_of(text, settings, materials, o);
  if (o.materials().empty()) spec.pressure_law = "cosine";  // the paper's
  const std::string& of = materials.name;
  Joint joint{.spec = spec,
              .pair = o.has("--wall") ? spec.pair() : materials.elastic,
              .has_size = has_size,
              .has_length = !pin || o.has("--length"),
              .title = to_string(spec.geometry.kind()) + " joint" +
                       (of.empty() ? "" : ", " + of)};
  joint.spec.name = {};
  if (has_size) joint.notes = length_notes(o);
  if (o.is_plain_bearing) {
    joint.notes.push_back(fmt::format(
        "bearing {}: a ball of steel in steel, as --pair steel_steel{}",
        o.key("--bearing"),
        o.use == JointUse::friction ? " --friction steel_steel_greased" : ""));
  }
  return joint;
}

Joint joint_from_file(const std::string& file,
                      const contact::KeySettings& settings) {
  const contact::JointSpec spec = contact::read_joint(file, settings);
  return {.spec = spec, .pair = spec.pair(), .title = spec.name};
}

void refuse_several(std::string_view option,
                    const std::vector<std::string>& names) {
  if (names.size() == 1) return;
  refuse(option, "all", "one law");
}

// True if two joints have the same laws, by name.
bool have_laws_in_common(const Joint& a, const Joint& b) {
  return a.kind() == b.kind() && a.pair == b.pair &&
         a.spec.conditions() == b.spec.conditions() &&
         a.spec.half_angle_law == b.spec.half_angle_law &&
         a.spec.half_angle_options == b.spec.half_angle_options &&
         a.spec.pressure_law == b.spec.pressure_law;
}

void make_laws(const JointOptions& o, Joint& joint) {
  const contact::ContactConditions conditions = joint.spec.conditions();
  contact::HalfAngleOptions options = joint.spec.half_angle_options;
  if (o.use != JointUse::pressure) {
    const auto names = half_angle_laws(
        o.laws, {joint.spec.without_seat().half_angle_law_name()}, conditions);
    if (o.one_law) refuse_several("--law", names);
    set_limit_angle(o.limit_angle, names, options);
    for (const std::string& name : names) {
      joint.laws.push_back(
          {with_loading(name, conditions.loading),
           contact::make_half_angle_law(name, joint.kind(), joint.pair, options,
                                        conditions)});
    }
  }
  const auto names =
      pressure_laws(o.pressures, {joint.spec.pressure_law}, conditions);
  if (o.one_pressure) refuse_several("--pressure", names);
  for (const std::string& name : names) {
    joint.pressures.push_back(
        {with_loading(name, conditions.loading),
         contact::make_pressure_law(name, joint.kind(), joint.pair,
                                    conditions)});
  }
}

Joint joint_of(const JointOptions& o, const std::string& name,
               const contact::KeySettings& settings) {
  Joint joint =
      is_file(name) ? joint_from_file(name, settings) : joint_from_options(o);
  if (o.use == JointUse::pressure && joint.is_pin()) {
    refuse("--joint", name, "a ball joint");
  }
  joint.spec.loading = parse_loading(o.loading, joint.spec.loading);
  return joint;
}

// Resolves the names of shipped joints; a bearing given by its designation
// alone is a steel ball in steel.
void settle_joint(const Program& program, JointOptions& o) {
  for (std::string& name : o.joints) {
    if (name == "ball" || name == "pin" || is_file(name)) continue;
    name = shipped_file(Shipped::joints, name);
    if (!is_file(name)) is_pin(o);  // which refuses it
  }
  if (o.use == JointUse::pressure) return;
  if (o.has("--bearing") && (o.joints.empty() || o.joint() == "ball")) {
    o.joints = {"ball"};
    if (o.pair.empty() && o.modulus_ratio.empty()) {
      o.pair = "steel_steel";
      o.is_plain_bearing = true;
    }
  }
  if (o.joints.empty()) {
    throw contact::Error(
        fmt::format("--joint is required (see {} --help)", program.name()));
  }
}

// Hint for an option that exists only as a key of the file.
std::string key_hint(const JointOptions& o, std::string_view flag) {
  if (o.use == JointUse::pressure) return {};
  const auto option =
      std::ranges::find(key_options, flag, &KeyOption::flag_name);
  if (option == std::end(key_options) || option->key == wall_key) return {};
  const contact::KeySetting key = setting_of(*option, o.key(flag), true);
  return fmt::format(
      ": use --set {}={}", key.key,
      std::string_view(key.value).starts_with('\'') ? o.key(flag) : key.value);
}

}  // namespace

std::string JointOptions::materials() const {
  if (is_file(joint())) return given("--joint", joint());
  if (!pair.empty()) return given("--pair", pair);
  return modulus_ratio.empty() ? "" : given("--modulus-ratio", modulus_ratio);
}

void add_joint_options(Program& program, JointOptions& o) {
  const bool pressure = o.use == JointUse::pressure;
  const Reader one = [&o](const std::string& text) { o.joints = {text}; };
  program.add(
      "Joint",
      {pressure ? Option{"--joint", one, "KIND|FILE",
                         "ball (default) or a ball joint's file;\nthe flag may "
                         "be omitted before a .toml file"}
                : Option{"--joint", &o.joints, "KIND|FILE",
                         "ball, pin, or a joint file; files more than "
                         "once;\nthe flag may be omitted before a .toml file"},
       {"--loading", &o.loading, "NAME",
        "force on the ball or pin: centre (default) or back:PSI"}});
  program.add_check([&program, &o] { settle_joint(program, o); });
  if (!pressure) {
    program.add("Joint", {{"--set", &o.settings, "KEY=VALUES",
                           "a key of the joint file and its values, a list or "
                           "range"}});
  }
}

void add_fileless_joint_options(Program& program, JointOptions& o) {
  std::vector<Option> rows = {
      {"--pair", &o.pair, "NAME|FILE",
       "materials of the two bodies: steel_bronze or another shipped pair,\n"
       "or a TOML file"}};
  if (o.use != JointUse::friction) {
    rows.push_back({"--modulus-ratio", &o.modulus_ratio, "NUMBER",
                    "E1/E2, 0 to inf", "", "--pair"});
    rows.push_back({"--poisson1", &o.poisson1, "NUMBER",
                    "Poisson's ratio of the ball or pin; default 0.3",
                    "--modulus-ratio"});
    rows.push_back({"--poisson2", &o.poisson2, "NUMBER",
                    "Poisson's ratio of the seat or hole; default 0.3",
                    "--modulus-ratio"});
  }
  for (const KeyOption& row : key_options) {
    if (o.use < row.use) continue;
    rows.push_back({row.flag, &o.keys[row.flag], row.kind, row.meaning,
                    row.needs, row.excludes});
  }
  program.add("Joint without a file", rows);
  std::vector<const char*> flags;
  for (const Option& row : rows) flags.push_back(row.flag);
  program.add_check([&program, &o, flags] {
    if (!is_file(o.joint())) return;
    for (const char* flag : flags) {
      if (!program.has(flag)) continue;
      refuse_beside(flag, cli::given("--joint", o.joint()) + key_hint(o, flag));
    }
  });
}

void add_law_options(Program& program, JointOptions& o, Laws half_angle,
                     Laws pressure) {
  const auto names = [](Laws laws, Texts& to) -> decltype(Option::target) {
    if (laws == Laws::several) return List{&to};
    return Reader([&to](const std::string& text) { to = {text}; });
  };
  const auto kind = [](bool one) { return one ? "NAME" : "NAMES"; };
  o.one_law = half_angle == Laws::one;
  o.one_pressure = pressure == Laws::one;
  if (o.use != JointUse::pressure) {
    program.add(
        "Law",
        {{"--law", names(half_angle, o.laws), kind(o.one_law),
          o.one_law ? "half-angle law; default: the joint's law, or fitted"
                    : "a comma-separated list or all; default: the joint's "
                      "law, or fitted"},
         {"--limit-angle", &o.limit_angle, "NAME|ANGLE",
          "formula, linear, or degrees; default formula"}});
  }
  program.add(
      "Law",
      {{"--pressure", names(pressure, o.pressures), kind(o.one_pressure),
        o.use == JointUse::pressure ? "pressure law; default: the joint's law, "
                                      "or exact; cosine without materials"
        : o.one_pressure ? "pressure law; default: the joint's law, or exact"
                         : "a comma-separated list or all; default: the "
                           "joint's law, or exact"}});
}

contact::JointContact Joint::contact(contact::FrictionModel friction,
                                     std::size_t law,
                                     std::size_t pressure) const {
  return {spec.geometry.without_seat(), pair,
          std::move(friction),          laws[law].law,
          pressures[pressure].law,      spec.conditions()};
}

std::string shared_title(const std::vector<Joint>& joints,
                         const std::string& behind) {
  const std::string& title = joints[0].title;
  const bool shared = std::ranges::all_of(
      joints, [&](const Joint& joint) { return joint.title == title; });
  if (!shared || title.empty()) return behind;
  return behind.empty() ? title : title + ", " + behind;
}

std::vector<Joint> make_joints(const JointOptions& o) {
  const std::vector<contact::KeySettings> variants = key_settings(o.settings);
  const bool several = o.joints.size() > 1;
  std::vector<Joint> joints;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, o.joints.size()); ++i) {
    const std::string name = o.joints.empty() ? "" : o.joints[i];
    if (!is_file(name)) {
      if (several) refuse("--joint", name, "a .toml file");
      if (!o.settings.empty()) refuse_without("--set", "a joint file");
    }
    for (const contact::KeySettings& settings : variants) {
      Joint joint = joint_of(o, name, settings);
      if (several) {
        joint.differences.push_back(
            {"joint", std::filesystem::path(name).stem().string()});
      }
      for (const contact::KeySetting& setting : settings) {
        joint.differences.push_back({setting.key, setting.value});
      }
      if (!joints.empty() && have_laws_in_common(joints.back(), joint)) {
        joint.laws = joints.back().laws;
        joint.pressures = joints.back().pressures;
      } else {
        make_laws(o, joint);
      }
      joints.push_back(std::move(joint));
    }
  }
  for (Joint& joint : joints) {
    if (joints.size() == 1) break;
    joint.among_several = difference_text(joint.differences);
  }
  return joints;
}

Joint make_joint(const JointOptions& options) {
  std::vector<Joint> joints = make_joints(options);
  if (joints.size() > 1) {
    throw contact::Error(contact::detail::must_be(
        fmt::format("{} joints of --joint and --set", joints.size()),
        "one joint here"));
  }
  return std::move(joints[0]);
}

void warn_of_validity(std::string_view program,
                      const std::vector<Joint>& joints) {
  std::set<std::string> said;
  for (const Joint& joint : joints) {
    std::vector<std::string> plain_notes = joint.notes;
    std::ranges::copy(joint.spec.clearance_notes(),
                      std::back_inserter(plain_notes));
    for (const std::string& text : plain_notes) {
      if (said.insert(text).second) note(program, text);
    }
    std::vector<std::string> notes = law_notes(joint.laws, joint.pair);
    if (joint.has_size) {
      std::ranges::copy(joint.spec.geometry.validity_notes(),
                        std::inserter(notes, notes.begin()));
    }
    std::ranges::copy(joint.spec.own_notes(), std::back_inserter(notes));
    const auto& friction = joint.spec.friction;
    const auto* stress =
        friction ? std::get_if<contact::FrictionStress>(&*friction) : nullptr;
    if (stress && !stress->note().empty()) notes.push_back(stress->note());
    for (const std::string& text : notes) {
      if (said.insert(text).second) warn(program, text);
    }
  }
}

}  // namespace cli
