#include "page/answer.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <nlohmann/json.hpp>
#include <utility>
#include <vector>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/files/joint_tables.hpp"
#include "libcontact/files/tables/friction_presets.hpp"
#include "libcontact/joint/contact_notes.hpp"
#include "page/same_numbers.hpp"
#include "programs/joint/solution_row.hpp"

namespace page {
namespace {

namespace fs = std::filesystem;
using contact::Dimension;
using contact::JointKind;
using contact::JointSpec;
using contact::TomlTable;
using hinge_joint::Answer;
using hinge_joint::AnswerColumn;
using Json = nlohmann::ordered_json;

// Columns that are drawn over the load.
constexpr std::string_view drawn_columns[] = {
    "theta0_deg", "p_peak_Pa",      "p_mean_Pa", "p_nominal_Pa",
    "M_t_N_m",    "M_textbook_N_m", "approach_m"};

// Points of a curve over four decades of load, and of a pressure profile.
constexpr int curve_points = 81;
constexpr int curve_decades = 4;
constexpr int profile_points = 101;

Json unit_choices(Dimension dimension) {
  Json units = Json::array();
  for (const contact::Unit& unit : contact::units_of(dimension)) {
    units.push_back({{"ending", unit.ending},
                     {"symbol", contact::unit_symbol(unit.ending)}});
  }
  return units;
}

contact::KnownKeys state_keys() {
  constexpr contact::Interval size{0, 1e100};
  using contact::number_key;
  return {number_key("reaction", Dimension::force, size),
          number_key("rate", Dimension::angular_velocity, size),
          number_key("beta_deg", {0, 180})};
}

// The intervals of hinge-joint.
hinge_joint::Input state_of(const std::string& text, bool is_pin) {
  const TomlTable state = TomlTable::from_text(text, "", state_keys());
  const double reaction = state.number("reaction");
  const double rate = state.number("rate");
  const double beta = is_pin ? 90 : state.number("beta_deg");
  state.refuse_idle();
  return hinge_joint::state_from_reaction(reaction, beta, rate);
}

Json layers_of(const std::vector<contact::Layer>& layers) {
  Json all = Json::array();
  for (const contact::Layer& layer : layers) {
    all.push_back(
        {{"thickness_m", layer.thickness}, {"material", layer.material.name}});
  }
  return all;
}

Json drawn_joint(const JointSpec& spec) {
  const contact::JointGeometry& geometry = spec.geometry;
  Json joint = {{"name", spec.name},
                {"kind", to_string(geometry.kind())},
                {"radius_m", geometry.radius()},
                {"radial_clearance_m", geometry.radial_clearance()},
                {"inner", spec.inner.surface().name},
                {"outer", spec.outer.surface().name},
                {"coatings", layers_of(spec.inner.layers)},
                {"layers", layers_of(spec.outer.layers)}};
  if (geometry.kind() == JointKind::pin) joint["length_m"] = geometry.length();
  return joint;
}

// Bytes of names that are no UTF-8 are replaced.
std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

template <class Make>
std::string text_or_error(const Make& make) {
  try {
    return make();
  } catch (const contact::Error& error) {
    return text_of({{"error", error.what()}});
  }
}

template <class Texts>
void add(const Texts& from, Json& to) {
  for (const std::string& text : from) {
    if (std::find(to.begin(), to.end(), text) == to.end()) to.push_back(text);
  }
}

// As tables of the programs have it: JSON knows no infinity.
Json cell_of(double value) {
  if (std::isinf(value)) return value > 0 ? "inf" : "-inf";
  return value + 0.0;  // no -0
}

Json numbers_of(const std::vector<AnswerColumn>& columns, const Answer& a) {
  Json numbers = Json::array();
  std::string_view meaning;  // parts of a vector share one
  for (const AnswerColumn& column : columns) {
    if (!column.meaning.empty()) meaning = column.meaning;
    const auto [symbol, unit] = std::visit(
        [](const auto& c) {
          return std::pair(c.quantity->stem(), c.unit->ending);
        },
        column.of);
    numbers.push_back({{"name", column.name},
                       {"symbol", symbol},
                       {"unit", contact::unit_symbol(unit)},
                       {"meaning", meaning},
                       {"value", cell_of(column(a))}});
  }
  return numbers;
}

}  // namespace

// A joint that has been asked about, and its columns.
struct Calculator::Prepared {
  std::string text;
  JointSpec spec;
  std::string file;  // its text needs no other file
  contact::SharedLaws laws;
  JointSpec endless;
  hinge_joint::NamedJoint joint;
  std::vector<AnswerColumn> columns;
  // The last curves, and their parameters: first decade, angle, rate.
  std::array<double, 3> drawn = {};
  std::string curves_text;

  static JointSpec read(const std::string& text, const fs::path& data) {
    return contact::parse_joint(text, "", {}, data / "joints");
  }
  // Text of a file that stands alone: the given one, unless it names another.
  static std::string alone(const std::string& text, const JointSpec& spec) {
    const TomlTable table =
        TomlTable::from_text(text, "", contact::joint_keys());
    return table.table("materials").has("pair") ? spec.canonical_text() : text;
  }

  Prepared(const std::string& joint_text, const fs::path& data,
           contact::SharedLaws known)
      : text(joint_text),
        spec(read(text, data)),
        file(alone(text, spec)),
        laws(std::move(known)),
        // Curves of a hundred contacts at a rim would take seconds: warnings
        // say how far the contact goes beyond one.
        endless(spec.without_seat()),
        joint{endless.half_angle_law_name(),
              endless.pressure_law_name(),
              contact::Joint(endless.contact(laws)),
              {},
              {},
              true} {
    const auto law = laws.half_angle(endless);
    if (cli::JointApproach::of(*law)) {
      joint.approach.emplace(law,
                             cli::Joint{.spec = spec, .pair = spec.pair()});
    }
    columns =
        hinge_joint::answer_columns({.approach = joint.approach.has_value(),
                                     .preload = joint.has_preload(),
                                     .pv = true});
  }

  Answer solve(const hinge_joint::Input& input) const {
    return hinge_joint::answer(joint, hinge_joint::Question::reaction, input);
  }

  Json warnings(const Answer& a) const {
    const contact::JointContact& contact = joint.joint.contact();
    const contact::JointSolution& s = a.solution();
    Json all = Json::array();
    add(contact.validity_notes(), all);
    add(spec.own_notes(), all);
    add(contact.limits().notes(
            {s.half_angle, s.peak_pressure,
             rim_overlap(contact, s, contact::LoadDirection::angle)}),
        all);
    add(joint.joint.notes(s), all);
    return all;
  }

  // A curve's points for the decades around a load.
  Json curves(double first, const hinge_joint::Input& input) const {
    Json curves = Json::object();
    for (int i = 0; i < curve_points; ++i) {
      const double load =
          std::pow(10, first + curve_decades * i / (curve_points - 1.0));
      const Answer a = solve(hinge_joint::state_from_reaction(
          load, input.given->angle_deg, input.turn[2]));
      curves["R_N"].push_back(load);
      for (const AnswerColumn& column : columns) {
        if (std::find(std::begin(drawn_columns), std::end(drawn_columns),
                      column.name) != std::end(drawn_columns)) {
          curves[column.name].push_back(cell_of(column(a)));
        }
      }
    }
    return curves;
  }

  Json pressure(const Answer& a) const {
    Json profile = {{"theta_deg", Json::array()}, {"p_Pa", Json::array()}};
    const contact::JointSolution& s = a.solution();
    for (int i = 0; i < profile_points; ++i) {
      const double theta = s.half_angle * i / (profile_points - 1);
      profile["theta_deg"].push_back(theta / contact::degree);
      profile["p_Pa"].push_back(
          joint.joint.contact().pressure(theta, s.normal_force, s.half_angle));
    }
    return profile;
  }

  Json answer(const std::string& state) const {
    const bool is_pin = joint.joint.is_pin();
    const hinge_joint::Input input = state_of(state, is_pin);
    const Answer a = solve(input);
    const SameNumbers same = same_numbers(
        input, is_pin,
        spec.geometry.seat()                                ? "seat"
        : spec.relief.kind() != contact::Relief::Kind::none ? "relief"
                                                            : "");
    Json notes = Json::array();
    add(spec.clearance_notes(), notes);
    return {{"words",
             {{"law", joint.law},
              {"pressure", joint.pressure},
              {"state", state_text(a)},
              {"status", to_string(a.solution().status)},
              {"contact_state", contact_state_text(a)}}},
            {"joint", drawn_joint(spec)},
            {"numbers", numbers_of(columns, a)},
            {"notes", notes},
            {"warnings", warnings(a)},
            {"pressure", pressure(a)},
            {"same",
             {{"file", file},
              {"command", same.command},
              {"python", same.python},
              {"cpp", same.cpp}}}};
  }
};

Calculator::Calculator(fs::path data) : data_(std::move(data)) {}

Calculator::~Calculator() = default;

std::string choices() {
  Json presets = Json::array();
  for (const auto& preset : contact::detail::friction_presets()) {
    presets.push_back({{"name", preset.name},
                       {"least", preset.least},
                       {"largest", preset.largest}});
  }
  const Json all = {
      {"presets", presets},
      {"units",
       {{"length", unit_choices(Dimension::length)},
        {"stress", unit_choices(Dimension::stress)},
        {"force", unit_choices(Dimension::force)},
        {"temperature", unit_choices(Dimension::temperature)},
        {"angular_velocity", unit_choices(Dimension::angular_velocity)}}}};
  return text_of(all);
}

Calculator::Prepared& Calculator::prepared(const std::string& joint) {
  // Laws of joints that have been asked about one after the other.
  constexpr std::size_t most_laws = 16;
  if (!last_ || last_->text != joint) {
    contact::SharedLaws laws;
    if (last_ && last_->laws.size() < most_laws) laws = last_->laws;
    last_ = std::make_unique<Prepared>(joint, data_, std::move(laws));
  }
  return *last_;
}

std::string Calculator::answer(const std::string& joint,
                               const std::string& state) {
  return text_or_error([&] { return text_of(prepared(joint).answer(state)); });
}

std::string Calculator::curves(const std::string& joint,
                               const std::string& state) {
  return text_or_error([&] {
    Prepared& it = prepared(joint);
    const hinge_joint::Input input = state_of(state, it.joint.joint.is_pin());
    const double load = input.given->force;
    if (!(load > 0)) return text_of(Json::object());
    // The load is in the third of the decades.
    const double first = std::floor(std::log10(load)) - curve_decades / 2;
    const std::array of = {first, input.given->angle_deg, input.turn[2]};
    if (it.curves_text.empty() || it.drawn != of) {
      it.curves_text = text_of(it.curves(first, input));
      it.drawn = of;
    }
    return it.curves_text;
  });
}

}  // namespace page
