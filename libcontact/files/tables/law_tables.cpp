#include "libcontact/files/tables/law_tables.hpp"

#include <numbers>
#include <span>
#include <string>
#include <vector>

#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/half_angle/registry.hpp"
#include "libcontact/pressure/registry.hpp"

namespace contact {
namespace {

// 180/pi is 57.2958; the paper rounds it to 57.3.
constexpr Interval degrees_per_radian_range{57, 58};

// "A, B and C".
std::string listed(const std::vector<std::string>& words) {
  const std::string last = words.back();
  if (words.size() == 1) return last;
  return detail::message(
      "{} and {}",
      detail::joined(std::span(words).first(words.size() - 1), ", "), last);
}

// A law that takes long to make is for all joints.
template <class Entry>
bool is_slow(const Entry* law) {
  return law && law->about.is_slow_to_make;
}

void read_half_angle(const TomlTable& half_angle, JointSpec& joint) {
  HalfAngleOptions& options = joint.half_angle_options;
  joint.half_angle_law =
      half_angle.optional_text("law").value_or(joint.half_angle_law);
  const std::string name = joint.half_angle_law_name();
  options.limit_half_angle = half_angle.optional_number("limit_half_angle");
  options.linear_limit =
      half_angle.optional_choice("limit_formula").value_or(0) == 1;
  const auto degrees = half_angle.optional_number("degrees_per_radian");
  if (degrees) options.initial_slope = *degrees * degree;
  try {
    if (!is_slow(detail::find_half_angle_entry(name))) {
      joint.make_half_angle_law();
    }
  } catch (const Error& error) {
    half_angle.fail("law", error.what());
  }
  if (!takes_half_angle_options(name)) {
    for (const char* key :
         {"limit_half_angle", "limit_formula", "degrees_per_radian"}) {
      if (!half_angle.has(key)) continue;
      half_angle.needs(
          key,
          detail::message("one of the laws {}; this joint has {}",
                          listed(detail::names_of(detail::half_angle_entries(),
                                                  [](const auto& law) {
                                                    return law.takes_options;
                                                  })),
                          name));
    }
  }
}

void read_pressure(const TomlTable& pressure, JointSpec& joint) {
  joint.pressure_law = pressure.text("law");
  try {
    if (!is_slow(detail::find_pressure_entry(joint.pressure_law))) {
      joint.make_pressure_law();
    }
  } catch (const Error& error) {
    pressure.fail("law", error.what());
  }
}

// [loading], which fits the laws and walls that have been read.
InnerLoading loading_from_table(const TomlTable& file, const JointSpec& joint) {
  const auto table = file.optional_table("loading");
  if (!table) return InnerLoading::centre();
  if (table->choice("kind") == 0) {
    if (table->has("patch_half_angle")) {
      table->needs("patch_half_angle", "kind = \"back\"");
    }
    return InnerLoading::centre();
  }
  const InnerLoading loading =
      InnerLoading::back(table->number("patch_half_angle"));
  if (!joint.inner.layers.empty()) {
    table->needs("kind",
                 "an inner body without [[coating]]: a coated ball or pin can "
                 "be loaded at its centre only");
  }
  const ContactConditions conditions{loading, joint.conditions().walls};
  const auto allows_back = [](const auto& law) {
    return law.about.allows_back;
  };
  if (!half_angle_law_allows(joint.half_angle_law_name(), conditions)) {
    table->needs(
        "kind", detail::message("the half-angle law {}; this joint has {}",
                                listed(detail::names_of(
                                    detail::half_angle_entries(), allows_back)),
                                joint.half_angle_law_name()));
  }
  if (!pressure_law_allows(joint.pressure_law, conditions)) {
    table->needs(
        "kind",
        detail::message(
            "one of the pressure laws {}; this joint has {}",
            listed(detail::names_of(detail::pressure_entries(), allows_back)),
            joint.pressure_law));
  }
  return loading;
}

}  // namespace

void read_laws(const TomlTable& table, JointSpec& joint) {
  if (const auto of = table.optional_table("half_angle")) {
    read_half_angle(*of, joint);
  }
  if (const auto of = table.optional_table("pressure")) {
    read_pressure(*of, joint);
  }
  joint.loading = loading_from_table(table, joint);
}

KnownKeys law_keys() {
  return {
      table_key("half_angle",
                {{"law"},
                 number_key("limit_half_angle", Dimension::angle,
                            {0, std::numbers::pi, true, true}),
                 word_key("limit_formula", {"arctan", "linear"}),
                 number_key("degrees_per_radian", degrees_per_radian_range)}),
      table_key("pressure", {{"law"}}),
      table_key("loading", {word_key("kind", {"centre", "back"}),
                            number_key("patch_half_angle", Dimension::angle,
                                       {0, std::numbers::pi / 2})})};
}

}  // namespace contact
