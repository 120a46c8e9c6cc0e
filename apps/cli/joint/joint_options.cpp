#include "cli/joint/joint_options.hpp"

#include <fmt/format.h>

#include <CLI/CLI.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <filesystem>
#include <iterator>
#include <limits>
#include <set>
#include <tuple>

#include "cli/choice.hpp"
#include "cli/joint/key_settings.hpp"
#include "cli/program.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/files/joint_file.hpp"

namespace cli {
namespace {

using contact::Backing;
using contact::JointBody;
using contact::JointGeometry;
using contact::JointKind;

// The group of options that a joint file takes the place of.
constexpr const char* without_file = "Joint without a file";

Joint joint_from_file(const JointOptions& o,
                      const contact::KeySettings& settings) {
  const contact::JointSpec joint = contact::read_joint(o.joint, settings);
  return {.kind = joint.geometry.kind(),
          .pair = joint.pair(),
          .geometry = joint.geometry,
          .fit = joint.fit,
          .friction = joint.friction,
          .half_angle_law = joint.half_angle_law,
          .half_angle_options = joint.half_angle_options,
          .pressure_law = joint.pressure_law,
          .conditions = joint.conditions(),
          .name = joint.name};
}

// hinge-table's is a ball unless it says otherwise.
JointKind kind_of(const JointOptions& o) {
  if (o.joint == "pin") return JointKind::pin;
  if (o.joint == "ball" || o.joint.empty()) return JointKind::ball;
  refuse("--joint", o.joint, "ball, pin or a .toml file");
}

JointGeometry geometry_of(const JointOptions& o, JointKind kind,
                          const JointSize& size) {
  constexpr std::array<Choice<JointBody>, 2> bodies = {
      {{"carrier", JointBody::carrier}, {"body", JointBody::body}}};
  const JointBody inner = o.inner_body.empty()
                              ? JointBody::carrier
                              : choice("--inner-body", o.inner_body, bodies);
  if (kind == JointKind::ball) {
    if (!o.length.empty()) refuse_without("--length", "--joint pin");
    return JointGeometry::ball(size.radius, size.clearance, inner);
  }
  if (o.length.empty() && o.use == JointUse::friction) {
    refuse_without("--joint pin", "--length");
  }
  // Loads per unit length ask for none.
  return JointGeometry::pin(
      size.radius, size.clearance,
      o.length.empty() ? 1 : parse_length("--length", o.length), inner);
}

contact::ElasticPair pair_of_modulus_ratio(const JointOptions& o) {
  constexpr double infinity = std::numeric_limits<double>::infinity();
  constexpr Allowed poisson{0, 0.5, ""};
  return contact::ElasticPair::from_modulus_ratio(
      parse_value("--modulus-ratio", o.modulus_ratio, {0, infinity, ""}),
      parse_value("--poisson1", o.poisson1, poisson),
      parse_value("--poisson2", o.poisson2, poisson));
}

Backing backing_of(const JointOptions& o) {
  if (o.backing.ends_with(".toml")) {
    if (!o.modulus_ratio.empty()) {
      refuse_beside(given("--backing", o.backing), "--modulus-ratio");
    }
    return Backing::medium(contact::read_material(o.backing));
  }
  // The file's name is there for the message.
  const std::array<Choice<Backing>, 3> backings = {
      {{"rigid", Backing::rigid()},
       {"held", Backing::held()},
       {"MATERIAL.toml", Backing::rigid()}}};
  return choice("--backing", o.backing, backings);
}

// A layer of the outer material; without a size in units of the radius.
contact::LayeredPair walls_of(const JointOptions& o, const Joint& joint) {
  constexpr Allowed relative{contact::LayeredPair::smallest_relative_thickness,
                             1e6, "of the radius"};
  const double radius = joint.geometry ? joint.geometry->radius() : 1;
  const double thickness = joint.geometry
                               ? parse_length("--wall", o.wall)
                               : parse_value("--wall", o.wall, relative);
  if (!relative.contains(thickness / radius)) {
    refuse("--wall", o.wall, relative.text());
  }
  const contact::Material& material = joint.pair.outer();
  if (std::isinf(material.youngs_modulus)) {
    refuse_beside(given("--wall", o.wall),
                  "the rigid outer body of " + o.materials());
  }
  return {radius,
          {{}, Backing::medium(joint.pair.inner())},
          {{{thickness, material}}, backing_of(o)}};
}

// Lengths that are hardly meant in m, the unit of a plain number.
std::vector<std::string> length_notes(const JointOptions& o) {
  constexpr double largest = 2;  // m
  std::vector<std::string> notes;
  for (const auto& [option, text, parts] :
       {std::tuple{"--radius", &o.size.radius, 2},
        {"--diameter", &o.size.diameter, 1},
        {"--clearance", &o.size.clearance, 2},
        {"--diametral-clearance", &o.size.diametral_clearance, 1},
        {"--length", &o.length, 1},
        {"--wall", &o.wall, 1}}) {
    const auto plain = parse_number(*text);
    if (!plain || parts * *plain <= largest) continue;
    notes.push_back(
        fmt::format("{0} {1} is {1} m; {1}mm is {1} mm", option, *text));
  }
  return notes;
}

Joint bodies_from_options(const JointOptions& o) {
  const JointKind kind = kind_of(o);
  if (!o.modulus_ratio.empty()) return {kind, pair_of_modulus_ratio(o)};
  if (o.pair.empty()) {
    const char* either =
        o.use == JointUse::friction ? "--pair" : "--pair or --modulus-ratio";
    if (!o.joint.empty()) refuse_without(given("--joint", o.joint), either);
    if (!o.wall.empty()) refuse_without("--wall", either);
    // The paper's law, which looks at no materials.
    return {.kind = kind,
            .pair = contact::ElasticPair::from_modulus_ratio(1, 0.3, 0.3),
            .pressure_law = "cosine"};
  }
  const contact::MaterialPair pair = contact::read_material_pair(o.pair);
  Joint joint{.kind = kind,
              .pair = pair.elastic,
              .has_length = kind == JointKind::ball || !o.length.empty(),
              .friction = pair.friction,
              .materials = pair.name};
  if (const auto size = make_size(o.size)) {
    joint.geometry = geometry_of(o, kind, *size);
    joint.fit = size->fit;
    joint.notes = length_notes(o);
  } else if (o.use == JointUse::friction) {
    refuse_without(given("--joint", o.joint),
                   "a size: --radius and --clearance, or --diameter");
  } else if (!o.length.empty()) {
    refuse_without("--length", "--radius or --diameter");
  }
  return joint;
}

Joint joint_from_options(const JointOptions& o) {
  Joint joint = bodies_from_options(o);
  if (o.wall.empty()) return joint;
  joint.conditions.walls = walls_of(o, joint);
  joint.pair = joint.conditions.walls->surfaces();
  // The only laws that know walls.
  joint.half_angle_law = joint.pressure_law = "exact";
  return joint;
}

void refuse_several(std::string_view option,
                    const std::vector<std::string>& names) {
  if (names.size() == 1) return;
  refuse(option, "all", "one law");
}

// Whether all laws of a joint, named alike, are those of another one.
bool have_laws_in_common(const Joint& a, const Joint& b) {
  return a.kind == b.kind && a.pair == b.pair && a.conditions == b.conditions &&
         a.half_angle_law == b.half_angle_law &&
         a.half_angle_options == b.half_angle_options &&
         a.pressure_law == b.pressure_law;
}

void make_laws(const JointOptions& o, Joint& joint) {
  const contact::ContactConditions& conditions = joint.conditions;
  if (o.use != JointUse::pressure) {
    const auto names =
        half_angle_laws(o.laws, {joint.half_angle_law}, conditions);
    if (o.one_law) refuse_several("--law", names);
    set_limit_angle(o.limit_angle, names, joint.half_angle_options);
    for (const std::string& name : names) {
      joint.laws.push_back(
          {with_loading(name, conditions.loading),
           contact::make_half_angle_law(name, joint.kind, joint.pair,
                                        joint.half_angle_options, conditions)});
    }
  }
  const auto names =
      pressure_laws(o.pressures, {joint.pressure_law}, conditions);
  if (o.one_pressure) refuse_several("--pressure", names);
  for (const std::string& name : names) {
    joint.pressures.push_back(
        {with_loading(name, conditions.loading),
         contact::make_pressure_law(name, joint.kind, joint.pair, conditions)});
  }
}

Joint joint_of(const JointOptions& o, const contact::KeySettings& settings) {
  Joint joint =
      o.names_file() ? joint_from_file(o, settings) : joint_from_options(o);
  if (o.use == JointUse::pressure && joint.kind == JointKind::pin) {
    refuse("--joint", o.joint, "a ball joint");
  }
  joint.conditions.loading = parse_loading(o.loading, joint.conditions.loading);
  return joint;
}

}  // namespace

std::string JointOptions::materials() const {
  if (names_file()) return given("--joint", joint);
  if (!pair.empty()) return given("--pair", pair);
  return modulus_ratio.empty() ? "" : given("--modulus-ratio", modulus_ratio);
}

void add_joint_options(CLI::App& app, JointOptions& o) {
  const bool pressure = o.use == JointUse::pressure;
  const bool friction = o.use == JointUse::friction;
  app.option_defaults()->group("Joint");
  // Called before needs() are looked at.
  auto* joint =
      app.add_option_function<std::vector<std::string>>(
             "--joint",
             [&app, &o](const std::vector<std::string>& texts) {
               o.joints = texts;
               o.joint = texts[0];
               if (!o.names_file()) return;
               for (const CLI::Option* option : app.get_options()) {
                 if (option->count() == 0 ||
                     option->get_group() != without_file) {
                   continue;
                 }
                 refuse_beside(option->get_name(), given("--joint", texts[0]));
               }
             },
             pressure ? "ball (default) or a ball joint's file"
                      : "ball, pin, or a joint file; files more than once")
          ->option_text("KIND|FILE")
          ->required(!pressure)
          ->allow_extra_args(false);
  if (pressure) {
    joint->expected(1);
  } else {
    app.add_option("--set", o.settings,
                   "a key of the joint file and its values, a list or range")
        ->option_text("KEY=VALUES")
        ->allow_extra_args(false)
        ->needs(joint);
  }
  app.add_option("--loading", o.loading,
                 "of the ball or pin: centre (default) or back:PSI")
      ->option_text("NAME");
  app.option_defaults()->group(without_file);
  const TextOptions add(app);
  auto* pair =
      add("--pair", o.pair, "materials of the two bodies, a TOML file", "FILE");
  if (!friction) {
    auto* ratio =
        add("--modulus-ratio", o.modulus_ratio, "E1/E2, 0 to inf", "NUMBER");
    ratio->excludes(pair);
    add("--poisson1", o.poisson1, "of the ball or pin; default 0.3", "NUMBER")
        ->needs(ratio);
    add("--poisson2", o.poisson2, "of the seat or hole; default 0.3", "NUMBER")
        ->needs(ratio);
  }
  if (!pressure) {
    add_size_options(app, o.size, pair);
    add("--length", o.length, "of a pin", "LENGTH");
  }
  if (friction) {
    add("--inner-body", o.inner_body,
        "body with the ball or pin: carrier (default) or body", "NAME");
  }
  auto* wall = add("--wall", o.wall,
                   "thickness of the seat or hole; default: no end", "LENGTH");
  auto* backing =
      add("--backing", o.backing, "behind the wall: rigid, held or a material",
          "NAME|FILE");
  wall->needs(backing);
  backing->needs(wall);
}

void add_law_options(CLI::App& app, JointOptions& o, Laws half_angle,
                     Laws pressure) {
  app.option_defaults()->group("Law");
  const auto add = [&app](const char* name, std::vector<std::string>& names,
                          Laws laws, const std::string& what) {
    auto* option = app.add_option(name, names, what);
    if (laws == Laws::one) {
      option->expected(1)->option_text("NAME");
    } else {
      option->delimiter(',')->option_text("NAMES");
    }
  };
  o.one_law = half_angle == Laws::one;
  o.one_pressure = pressure == Laws::one;
  if (o.use != JointUse::pressure) {
    add("--law", o.laws, half_angle,
        o.one_law ? "half-angle law; default the joint's, or fitted"
                  : "a comma list or all; default the joint's, or fitted");
    app.add_option("--limit-angle", o.limit_angle,
                   "formula, linear, or degrees; default formula")
        ->option_text("NAME|ANGLE");
  }
  add("--pressure", o.pressures, pressure,
      o.use == JointUse::pressure
          ? "pressure law; default the joint's, or exact; cosine without "
            "materials"
      : o.one_pressure ? "pressure law; default the joint's, or exact"
                       : "a comma list or all; default the joint's, or exact");
}

std::string Joint::title() const {
  if (!name.empty()) return name;
  return to_string(kind) + " joint" +
         (materials.empty() ? "" : ", " + materials);
}

std::string difference_text(const std::vector<Difference>& differences) {
  std::string text;
  for (const auto& [column, value] : differences) {
    text += text.empty() ? "" : ", ";
    // A key without the tables that it stands in.
    if (column != "joint") {
      text += column.substr(column.rfind('.') + 1);
      text += " = ";
    }
    text += value;
  }
  return text;
}

std::vector<Joint> make_joints(const JointOptions& options) {
  const std::vector<contact::KeySettings> variants =
      key_settings(options.settings);
  std::vector<Joint> joints;
  JointOptions one = options;
  for (std::size_t i = 0; i < std::max<std::size_t>(1, one.joints.size());
       ++i) {
    if (!one.joints.empty()) one.joint = one.joints[i];
    if (!one.names_file()) {
      if (one.joints.size() > 1) refuse("--joint", one.joint, "a .toml file");
      if (!one.settings.empty()) refuse_without("--set", "a joint file");
    }
    for (const contact::KeySettings& settings : variants) {
      Joint joint = joint_of(one, settings);
      if (one.joints.size() > 1) {
        joint.differences.push_back(
            {"joint", std::filesystem::path(one.joint).stem().string()});
      }
      for (const auto& [key, value] : settings) {
        joint.differences.push_back({key, value});
      }
      if (!joints.empty() && have_laws_in_common(joints.back(), joint)) {
        joint.laws = joints.back().laws;
        joint.pressures = joints.back().pressures;
      } else {
        make_laws(one, joint);
      }
      joints.push_back(std::move(joint));
    }
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

std::vector<std::string> joint_columns(
    const std::vector<Joint>& joints,
    const std::vector<std::vector<std::string>>& columns) {
  std::vector<std::string> names;
  for (const Difference& difference : joints[0].differences) {
    names.push_back(difference.column);
  }
  for (const auto& other : columns) {
    const auto [a, b] = std::ranges::mismatch(columns[0], other);
    if (a == columns[0].end() && b == other.end()) continue;
    throw contact::Error(contact::detail::must_be(
        fmt::format(
            "the joints of --joint and --set, {} and {}",
            difference_text(joints[0].differences),
            difference_text(joints[&other - columns.data()].differences)),
        fmt::format("alike: of one kind, with the same laws; the tables have "
                    "the columns {} and {}",
                    a == columns[0].end() ? "-" : *a,
                    b == other.end() ? "-" : *b)));
  }
  names.insert(names.end(), columns[0].begin(), columns[0].end());
  return names;
}

void write_differences(const std::vector<Difference>& differences,
                       RowWriter& row) {
  for (const Difference& difference : differences) {
    if (const auto number = parse_number(difference.value)) {
      row.number(*number);
    } else {
      row.text(difference.value);
    }
  }
}

void warn_of_validity(std::string_view program,
                      const std::vector<Joint>& joints) {
  std::set<std::string> said;
  for (const Joint& joint : joints) {
    std::vector<std::string> plain_notes = joint.notes;
    if (joint.fit) plain_notes.push_back(to_string(*joint.fit));
    for (const std::string& text : plain_notes) {
      if (said.insert(text).second) note(program, text);
    }
    std::vector<std::string> notes = law_notes(joint.laws, joint.pair);
    if (joint.geometry) {
      std::ranges::copy(joint.geometry->validity_notes(),
                        std::inserter(notes, notes.begin()));
    }
    const auto* stress =
        joint.friction ? std::get_if<contact::FrictionStress>(&*joint.friction)
                       : nullptr;
    if (stress && !stress->note().empty()) notes.push_back(stress->note());
    for (const std::string& text : notes) {
      if (said.insert(text).second) warn(program, text);
    }
  }
}

}  // namespace cli
