// A joint as the text of a joint file: keys as docs/reference/joint_file.md
// names them.
#include <array>
#include <cmath>
#include <initializer_list>
#include <iterator>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/joint/spec.hpp"
#include "libcontact/pair/stress_registry.hpp"

namespace contact {
namespace {

// A TOML text that grows line by line.
class Toml {
 public:
  void table(std::string_view header) {
    text_ += detail::message("\n{}\n", header);
  }
  void number(std::string_view key, double value) {
    text_ += detail::message("{} = {}\n", key, written(value));
  }
  void numbers(std::string_view key, std::span<const double> values) {
    std::string list;
    for (const double value : values) {
      list += (list.empty() ? "" : ", ") + written(value);
    }
    text_ += detail::message("{} = [{}]\n", key, list);
  }
  void text(std::string_view key, std::string_view value) {
    text_ += detail::message("{} = {}\n", key, quoted(value));
  }
  void is_true(std::string_view key) {
    text_ += detail::message("{} = true\n", key);
  }
  std::string take() { return std::move(text_); }

 private:
  // As many digits as bring the number back, in a form that TOML takes for one
  // with a fraction.
  static std::string written(double value) {
    std::string digits = detail::message("{}", value);
    if (std::isfinite(value) &&
        digits.find_first_of(".e") == std::string::npos) {
      digits += ".0";
    }
    return digits;
  }
  // A basic string of TOML.
  static std::string quoted(std::string_view value) {
    std::string result = "\"";
    for (const char c : value) {
      const auto code = static_cast<unsigned char>(c);
      if (c == '"' || c == '\\') {
        (result += '\\') += c;
      } else if (code < 0x20 || code == 0x7f) {
        result += detail::message("\\u{:04x}", code);
      } else {
        result += c;
      }
    }
    return result + '"';
  }

  std::string text_;
};

void write(Toml& toml, const Material& material) {
  if (!material.name.empty()) toml.text("name", material.name);
  toml.number("youngs_modulus_Pa", material.youngs_modulus);
  toml.number("poissons_ratio", material.poissons_ratio);
  if (std::isfinite(material.limit_pressure)) {
    toml.number("limit_pressure_Pa", material.limit_pressure);
  }
  if (material.thermal_expansion) {
    toml.number("thermal_expansion_per_K", *material.thermal_expansion);
  }
  if (material.liner) toml.is_true("liner");
}

void write(Toml& toml, std::string_view header, const Layer& layer) {
  toml.table(header);
  toml.number("thickness_m", layer.thickness);
  write(toml, layer.material);
}

void write(Toml& toml, const Temperatures& temperatures) {
  toml.number("inner_temperature_K", temperatures.inner);
  toml.number("outer_temperature_K", temperatures.outer);
  toml.number("reference_temperature_K", temperatures.reference);
  if (temperatures.axial == AxialGrowth::held) {
    toml.text("axial_growth", "held");
  }
}

void write_geometry(Toml& toml, const JointSpec& joint) {
  const JointGeometry& g = joint.geometry;
  toml.table("[geometry]");
  constexpr std::string_view taken[] = {"minimum", "mean", "maximum"};
  if (joint.bearing) {
    toml.text("designation", joint.bearing->designation());
    toml.text("clearance_group", to_string(joint.bearing->group()));
    toml.text("clearance", taken[static_cast<int>(joint.bearing->taken())]);
  } else if (joint.fit) {
    const std::string fit = joint.fit->name();  // "H7/g6"
    const auto slash = fit.find('/');
    toml.number("diameter_m", joint.fit->diameter());
    toml.text("hole", fit.substr(0, slash));
    toml.text("shaft", fit.substr(slash + 1));
    toml.text("clearance", taken[static_cast<int>(joint.fit->taken())]);
  } else {
    toml.number("radius_m", g.radius());
    toml.number("radial_clearance_m",
                joint.thermal_growth ? joint.thermal_growth->reference_clearance
                                     : g.radial_clearance());
  }
  if (g.kind() == JointKind::pin) toml.number("length_m", g.length());
  if (const auto& seat = g.seat()) {
    toml.table("[seat]");
    const SeatZone drawn = seat->drawn();
    toml.number("lower_rim_rad", drawn.from());
    toml.number("upper_rim_rad", drawn.to());
    if (seat->setback() > 0) {
      toml.number("rim_setback_rad", seat->setback());
    }
    const SeatEdge& edge = seat->edge();
    if (edge.radius > 0) toml.number("edge_radius_m", edge.radius);
    if (edge.angle) toml.number("edge_angle_rad", *edge.angle);
    for (const auto& [key, face] :
         {std::pair{"side_face", edge.side_face}, {"housing", edge.housing}}) {
      if (face == SideFace::free) toml.text(key, "free");
    }
    if (edge.report_distance != SeatEdge().report_distance) {
      toml.number("report_distance_rad", edge.report_distance);
    }
    if (seat->axis() != std::array<double, 3>{0, 0, 1}) {
      toml.numbers("axis", seat->axis());
    }
  }
}

void write_bodies(Toml& toml, const JointSpec& joint) {
  toml.table("[materials.inner]");
  write(toml, joint.inner.backing.material());
  toml.table("[materials.outer]");
  write(toml, joint.outer.surface());
  for (const Layer& coating : joint.inner.layers) {
    write(toml, "[[coating]]", coating);
  }
  if (joint.outer.layers.empty()) return;
  const Backing& backing = joint.outer.backing;
  if (backing == Backing::rigid() || backing == Backing::held()) {
    toml.table("[wall]");
    toml.text("backing", backing == Backing::held() ? "held" : "rigid");
  } else {
    toml.table("[wall.backing]");
    write(toml, backing.material());
  }
  for (const Layer& layer : joint.outer.layers) {
    write(toml, "[[wall.layer]]", layer);
  }
}

void write(Toml& toml, const FrictionLaw& dry) {
  toml.number("coefficient", dry.coefficient());
  if (dry.adhesion() != 0) toml.number("adhesion_Pa", dry.adhesion());
}

void write(Toml& toml, const ViscousLaw& viscous) {
  toml.number("viscous_constant_Pa_s_per_m", viscous.constant());
  if (viscous.pressure_slope() != 0) {
    toml.number("viscous_pressure_slope_s_per_m", viscous.pressure_slope());
  }
}

std::string with_unit(std::string_view key, std::string_view unit) {
  return unit.empty() ? std::string(key) : detail::message("{}_{}", key, unit);
}

void write(Toml& toml, const FrictionStress& stress) {
  const auto& [law, numbers, table] = stress.source();
  toml.text("law", law.empty() ? "own" : law);
  const detail::StressEntry* entry = detail::find_stress_entry(law);
  if (!entry) return;
  for (std::size_t i = 0; i < numbers.size(); ++i) {
    const auto& [key, unit, is_above_zero, largest] = entry->numbers[i];
    toml.number(with_unit(key, unit), numbers[i]);
  }
  if (!entry->is_table()) return;
  toml.numbers(with_unit(entry->points, entry->points_unit), table.points);
  toml.numbers("coefficients", table.coefficients);
  if (table.curve == FrictionStress::Table::Curve::linear)
    toml.text("curve", "linear");
}

void write_laws(Toml& toml, const JointSpec& joint) {
  const HalfAngleOptions& options = joint.half_angle_options;
  toml.table("[half_angle]");
  if (!joint.geometry.seat() || !joint.half_angle_law.empty()) {
    toml.text("law", joint.half_angle_law_name());
  }
  if (options.limit_half_angle) {
    toml.number("limit_half_angle_rad", *options.limit_half_angle);
  }
  if (options.linear_limit) toml.text("limit_formula", "linear");
  if (options.initial_slope != 1) {
    // Stored in degrees: choose the neighbouring double that converts back to
    // the same slope.
    double degrees = options.initial_slope / degree;
    for (const double to : {0.0, 100.0}) {
      const double next = std::nextafter(degrees, to);
      if (degrees * degree != options.initial_slope &&
          next * degree == options.initial_slope) {
        degrees = next;
      }
    }
    toml.number("degrees_per_radian", degrees);
  }
  toml.table("[pressure]");
  toml.text("law", joint.pressure_law_name());
  const Relief& relief = joint.relief;
  if (relief.kind() != Relief::Kind::none) {
    const bool ends = relief.kind() == Relief::Kind::ends;
    toml.table("[relief]");
    toml.text("kind", ends ? "ends" : "barrel");
    toml.number("depth_m", relief.depth());
    if (ends) toml.number("relieved_length_m", relief.length());
  }
  if (!joint.loading.is_back()) return;
  toml.table("[loading]");
  toml.text("kind", "back");
  toml.number("patch_half_angle_rad", joint.loading.patch_half_angle());
}

}  // namespace

std::string JointSpec::canonical_text() const {
  Toml toml;
  toml.text("name", name);
  toml.text("kind", to_string(geometry.kind()));
  if (geometry.inner_body() == JointBody::body) toml.text("inner_body", "body");
  if (thermal_growth) write(toml, thermal_growth->temperatures);
  write_geometry(toml, *this);
  write_bodies(toml, *this);
  if (friction) {
    toml.table("[friction]");
    std::visit([&](const auto& f) { write(toml, f); }, *friction);
  }
  write_laws(toml, *this);
  return toml.take();
}

}  // namespace contact
