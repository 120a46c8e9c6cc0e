#include "cli/joint_options.hpp"

#include <CLI/CLI.hpp>

#include <array>
#include <cmath>
#include <limits>

#include "cli/choice.hpp"
#include "cli/program.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "libcontact/files/joint_file.hpp"

namespace cli {
namespace {

using contact::Backing;
using contact::JointBody;
using contact::JointGeometry;
using contact::JointKind;

// The group of options that a joint file takes the place of.
constexpr const char* without_file = "Joint without a file";

Joint joint_from_file(const JointOptions& o) {
  const contact::JointSpec joint = contact::read_joint(o.joint);
  return {.kind = joint.geometry.kind(),
          .pair = joint.pair,
          .geometry = joint.geometry,
          .fit = joint.fit,
          .friction = joint.friction,
          .half_angle_law = joint.half_angle_law,
          .half_angle_options = joint.half_angle_options,
          .pressure_law = joint.pressure_law,
          .conditions = joint.conditions,
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

Joint bodies_from_options(const JointOptions& o) {
  const JointKind kind = kind_of(o);
  if (!o.modulus_ratio.empty()) return {kind, pair_of_modulus_ratio(o)};
  if (o.pair.empty()) {
    const char* either =
        o.use == JointUse::friction ? "--pair" : "--pair or --modulus-ratio";
    if (!o.joint.empty()) refuse_without(given("--joint", o.joint), either);
    if (!o.wall.empty()) refuse_without("--wall", either);
    // For laws that do not look at it.
    return {kind, contact::ElasticPair::from_modulus_ratio(1, 0.3, 0.3)};
  }
  const contact::MaterialPair pair = contact::read_material_pair(o.pair);
  Joint joint{.kind = kind,
              .pair = pair.elastic,
              .friction = pair.friction,
              .materials = pair.name};
  if (const auto size = make_size(o.size)) {
    joint.geometry = geometry_of(o, kind, *size);
    joint.fit = size->fit;
  } else if (o.use == JointUse::friction) {
    refuse_without(given("--joint", o.joint), "--radius and --clearance");
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
  app.add_option_function<std::string>(
         "--joint",
         [&app, &o](const std::string& text) {
           o.joint = text;
           if (!o.names_file()) return;
           for (const CLI::Option* option : app.get_options()) {
             if (option->count() == 0 || option->get_group() != without_file) {
               continue;
             }
             refuse_beside(option->get_name(), given("--joint", text));
           }
         },
         pressure ? "ball (default) or a ball joint's file"
                  : "ball, pin or a joint file")
      ->option_text("KIND|FILE")
      ->required(!pressure);
  app.add_option("--loading", o.loading,
                 "of the ball or pin: centre (default) or back:PSI")
      ->option_text("NAME");
  app.option_defaults()->group(without_file);
  const auto add = [&app](const char* name, std::string& value,
                          const char* what, const char* kind) {
    return app.add_option(name, value, what)->option_text(kind);
  };
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
  if (!pressure) add_size_options(app, o.size, pair);
  if (friction) {
    add("--length", o.length, "of a pin, m or with a unit", "LENGTH");
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
      o.one_pressure        ? "pressure law; default the joint's, or cosine"
      : o.pressures.empty() ? "a comma list or all; default the joint's, or "
                              "cosine"
                            : "a comma list or all; default all");
}

std::string Joint::title() const {
  if (!name.empty()) return name;
  return to_string(kind) + " joint" +
         (materials.empty() ? "" : ", " + materials);
}

Joint make_joint(const JointOptions& options) {
  Joint joint = options.names_file() ? joint_from_file(options)
                                     : joint_from_options(options);
  if (options.use == JointUse::pressure && joint.kind == JointKind::pin) {
    refuse("--joint", options.joint, "a ball joint");
  }
  joint.conditions.loading =
      parse_loading(options.loading, joint.conditions.loading);
  make_laws(options, joint);
  return joint;
}

void warn_of_validity(std::string_view program, const Joint& joint) {
  if (joint.fit) note(program, to_string(*joint.fit));
  if (joint.geometry) {
    for (const auto& text : joint.geometry->validity_notes()) {
      warn(program, text);
    }
  }
  for (const auto& text : law_notes(joint.laws, joint.pair)) {
    warn(program, text);
  }
}

}  // namespace cli
