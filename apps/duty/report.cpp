#include "duty/report.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>

#include "cli/plot.hpp"
#include "libcontact/base/units.hpp"

namespace hinge_duty {
namespace {

using contact::CycleInstant;
using contact::degree;
using contact::JointCycle;
using Eigen::Vector3d;

constexpr double mm = 1e-3;

// The other tables than the summary's have all their columns.
cli::TableStyle all_columns(const cli::OutputOptions& options) {
  cli::TableStyle style = options;
  style.columns.clear();
  return style;
}

// Writes the summary line by line.
class Lines {
 public:
  explicit Lines(const cli::Table& table) : row_(table, text_) {}

  void number(std::string_view name, double value, std::string_view meaning) {
    begin(name, value);
    for (int i = 0; i < 4; ++i) row_.empty();
    end(meaning);
  }
  void at_time(std::string_view name, double value, double time,
               std::string_view meaning) {
    begin(name, value);
    row_.number(time);
    for (int i = 0; i < 3; ++i) row_.empty();
    end(meaning);
  }
  // `time` NaN: none.
  void at_place(std::string_view name, double value, double time,
                const Vector3d& place, std::string_view meaning) {
    begin(name, value);
    row_.number(time);
    for (const double x : place) row_.number(x + 0.0);  // no -0
    end(meaning);
  }
  std::string_view view() const { return text_.view(); }

 private:
  void begin(std::string_view name, double value) {
    row_.text(name);
    row_.number(value + 0.0);  // no -0
  }
  void end(std::string_view meaning) {
    row_.text(meaning);
    row_.end();
  }

  cli::Text text_;
  cli::RowWriter row_;
};

double moment(const CycleInstant& i) {
  return i.solution.friction_moment.norm();
}

void write_integrals(const JointCycle& cycle, Lines& to) {
  const double period = cycle.cycle().period();
  const double rho = cycle.contact().geometry().radius();
  const double energy =
      cycle.integral([](const CycleInstant& i) { return -i.solution.power; });
  to.number("period_s", period, "one cycle; integrals and means are over it");
  to.number("closure_deg", cycle.cycle().closure() / degree,
            "by which the turn of integrated rates fails to close");
  to.number("energy_J", energy, "dissipated by friction");
  to.number("mean_heat_W", energy / period, "energy over period");
  to.number("sliding_distance_m", cycle.integral([&](const CycleInstant& i) {
    return rho * i.state.rate.norm() * cycle.sliding(i).slip_coefficient();
  }),
            "effective: integral of rho |Dw| L");
  to.number("pv_integral_J", cycle.integral([&](const CycleInstant& i) {
    return cycle.sliding(i).pv_total();
  }),
            "of p v over contact and time; times k: volume");
  to.number("mean_M_t_N_m", cycle.integral(moment) / period,
            "mean of the friction moment");
}

void write_moments(const JointCycle& cycle, Lines& to) {
  constexpr std::string_view axes[] = {"x", "y", "z"};
  for (int k = 0; k < 3; ++k) {
    for (const int sign : {-1, 1}) {
      const CycleInstant* most = &cycle.rows()[0];
      for (const CycleInstant& row : cycle.rows()) {
        if (sign * row.solution.friction_moment[k] >
            sign * most->solution.friction_moment[k]) {
          most = &row;
        }
      }
      to.at_time(
          fmt::format("{}_M_t_{}_N_m", sign < 0 ? "least" : "largest", axes[k]),
          most->solution.friction_moment[k], most->time,
          "moment on the body, of the rows of the file");
    }
  }
}

void write_peaks(const JointCycle& cycle, Lines& to) {
  const auto peak = [&](std::string_view name,
                        const JointCycle::Quantity& quantity, double unit,
                        std::string_view meaning) {
    const CycleInstant i = cycle.largest(quantity);
    to.at_time(name, quantity(i) / unit, i.time, meaning);
  };
  const auto pv = [&](const CycleInstant& i) {
    return cycle.sliding(i).largest_pv().value;
  };
  const auto heat = [&](const CycleInstant& i) {
    return cycle.sliding(i).largest_heat_flux().value;
  };
  peak("largest_M_t_N_m", moment, 1, "friction moment");
  write_moments(cycle, to);
  peak(
      "largest_p_peak_Pa",
      [](const CycleInstant& i) { return i.solution.peak_pressure; }, 1,
      "peak pressure");
  peak(
      "largest_theta0_deg",
      [](const CycleInstant& i) { return i.solution.half_angle; }, degree,
      "half-angle of the contact");
  peak(
      "least_theta0_deg",
      [](const CycleInstant& i) { return -i.solution.half_angle; }, -degree,
      "half-angle of the contact");
  CycleInstant i = cycle.largest(pv);
  to.at_place("largest_pv_max_W_per_m2", pv(i), i.time,
              cycle.sliding(i).largest_pv().place,
              "largest p v; x, y, z from the joint's centre, carrier axes");
  i = cycle.largest(heat);
  to.at_place("largest_q_max_W_per_m2", heat(i), i.time,
              cycle.sliding(i).largest_heat_flux().place,
              "largest heat flux of friction, into both bodies");
  peak(
      "largest_pv_nominal_W_per_m2",
      [&](const CycleInstant& x) { return cycle.sliding(x).pv_nominal(); }, 1,
      "p v of catalogues, with the next area");
  to.number("nominal_area_m2",
            1 / cycle.contact().geometry().nominal_pressure(1),
            "projected: pi rho^2 or 2 rho L");
}

void write_wear(const BodyWear& wear, double pv_integral, Lines& to) {
  const std::string of = "_" + wear.body;
  const double none = std::numeric_limits<double>::quiet_NaN();
  if (wear.k) {
    to.number("k_" + wear.surface + "_mm3_per_N_m", *wear.k,
              "wear coefficient, as given");
    to.number("volume_" + wear.surface + "_mm3", *wear.k * pv_integral,
              "worn off in one cycle: k pv_integral_J");
    to.at_place("largest_depth" + of + "_mm",
                *wear.k * mm * mm * wear.deepest.wear.pv, none,
                wear.deepest.point,
                "worn in one cycle; x, y, z in the axes of the " + wear.body);
  }
  to.at_place("largest_pv_integral" + of + "_Pa_m", wear.deepest.wear.pv, none,
              wear.deepest.point, "of p v over the time; times k: depth");
  to.number("cross_shear" + of, wear.deepest.wear.cross_shear,
            "there; share of friction work across the main direction");
  to.number("volume_defect" + of, wear.volume_defect,
            "of the map's volume against k pv_integral_J");
}

// V = N k pv_integral.
void write_measured(const MeasuredWear& measured, double pv_integral,
                    Lines& to) {
  const double per_volume = 1 / (measured.cycles * pv_integral);
  to.number("k_measured_mm3_per_N_m", measured.volume * per_volume,
            "measured volume over cycles and pv_integral_J");
  if (!measured.error) return;
  to.number("k_measured_error_mm3_per_N_m", *measured.error * per_volume,
            "standard error, of the measured volume alone");
}

// What wear_in() says at some time.
struct WornQuantity {
  const char* name;
  double (*of)(const contact::WornState&);
  const char* meaning;
};
constexpr WornQuantity worn_quantities[] = {
    {"cycles", [](const contact::WornState& w) { return w.cycles; },
     "after them"},
    {"wear_number", [](const contact::WornState& w) { return w.wear_number; },
     "volume over pi rho^2 eps, of a pin 2 rho eps l"},
    {"volume_seat_mm3",
     [](const contact::WornState& w) { return w.volume / (mm * mm * mm); },
     "worn off; reliable"},
    {"penetration_mm",
     [](const contact::WornState& w) { return w.penetration / mm; },
     "deepest wear, to 8 %, once most of it is wear; no creep"},
    {"theta0_deg",
     [](const contact::WornState& w) { return w.half_angle / degree; },
     "largest, to 0.4 deg"},
    {"p_peak_Pa", [](const contact::WornState& w) { return w.peak_pressure; },
     "largest"},
    {"pv_max_W_per_m2", [](const contact::WornState& w) { return w.pv; },
     "largest"},
    {"energy_J", [](const contact::WornState& w) { return w.energy; },
     "of a cycle"},
    {"mean_M_t_N_m", [](const contact::WornState& w) { return w.mean_moment; },
     "mean of the friction moment"},
    {"worn_in", [](const contact::WornState& w) { return w.worn_in ? 1. : 0; },
     "1: pressure p ~ cos theta, 0: that of the joint"},
};

}  // namespace

void write_blocks(const std::vector<contact::WornState>& worn,
                  cli::Output& output, const cli::OutputOptions& options) {
  std::vector<std::string> columns;
  for (const WornQuantity& q : worn_quantities) columns.emplace_back(q.name);
  const cli::Table table(all_columns(options), columns);
  cli::Text text;
  cli::RowWriter to(table, text);
  for (const contact::WornState& state : worn) {
    for (const WornQuantity& q : worn_quantities) to.number(q.of(state));
    to.end();
  }
  cli::TableWriter writer(output, table);
  writer.write(text.view());
  writer.finish();
}

void write_summary(const JointCycle& cycle, const std::vector<BodyWear>& wear,
                   const std::optional<MeasuredWear>& measured,
                   const std::vector<contact::WornState>& worn,
                   cli::Output& output, const cli::OutputOptions& options) {
  const cli::Table table(
      options, {"quantity", "value", "at_time_s", "x", "y", "z", "meaning"});
  Lines lines(table);
  write_integrals(cycle, lines);
  write_peaks(cycle, lines);
  const double pv_integral = cycle.integral(
      [&](const CycleInstant& i) { return cycle.sliding(i).pv_total(); });
  for (const BodyWear& w : wear) write_wear(w, pv_integral, lines);
  if (measured) write_measured(*measured, pv_integral, lines);
  if (!worn.empty()) {
    for (const WornQuantity& q : worn_quantities) {
      const std::string name = q.name;
      lines.number(name.starts_with("worn") ? name : "worn_" + name,
                   q.of(worn.back()), q.meaning);
    }
  }
  cli::TableWriter writer(output, table);
  writer.write(lines.view());
  writer.finish();
}

void write_states(const JointCycle& cycle, cli::Output& output,
                  const cli::OutputOptions& options) {
  const cli::Table table(all_columns(options), {"time_s",
                                                "R_x_N",
                                                "R_y_N",
                                                "R_z_N",
                                                "w_x_rad_per_s",
                                                "w_y_rad_per_s",
                                                "w_z_rad_per_s",
                                                "R_n_N",
                                                "n_x",
                                                "n_y",
                                                "n_z",
                                                "theta0_deg",
                                                "g_deg",
                                                "a_deg",
                                                "M_t_x_N_m",
                                                "M_t_y_N_m",
                                                "M_t_z_N_m",
                                                "heat_W",
                                                "p_peak_Pa",
                                                "pv_max_W_per_m2",
                                                "pv_max_theta_deg",
                                                "q_max_W_per_m2",
                                                "pv_total_W",
                                                "pv_nominal_W_per_m2"});
  cli::Text text;
  cli::RowWriter to(table, text);
  for (const CycleInstant& i : cycle.rows()) {
    const contact::JointSolution& s = i.solution;
    const contact::SlidingContact sliding = cycle.sliding(i);
    const auto vector = [&to](const Vector3d& v) {
      for (const double x : v) to.number(x + 0.0);  // no -0
    };
    to.number(i.time);
    vector(i.state.reaction);
    vector(i.state.rate);
    to.number(s.normal_force);
    vector(s.normal);
    for (const double angle :
         {s.half_angle, s.friction_angle(), s.slip_axis_angle()}) {
      to.number(angle / degree);
    }
    vector(s.friction_moment);
    to.number(sliding.heat());
    to.number(s.peak_pressure);
    to.number(sliding.largest_pv().value);
    to.number(sliding.largest_pv().theta / degree);
    to.number(sliding.largest_heat_flux().value);
    to.number(sliding.pv_total());
    to.number(sliding.pv_nominal());
    to.end();
  }
  cli::TableWriter writer(output, table);
  writer.write(text.view());
  writer.finish();
}

void write_map(const std::vector<BodyWear>& wear, bool is_pin,
               cli::Output& output, const cli::OutputOptions& options) {
  std::vector<std::string> columns = {"body"};
  if (is_pin) {
    columns.emplace_back("beta_deg");
  } else {
    columns.insert(columns.end(), {"x", "y", "z"});
  }
  columns.insert(columns.end(),
                 {"pv_integral_Pa_m", "depth_mm", "cross_shear"});
  const cli::Table table(all_columns(options), columns);
  cli::Text text;
  cli::RowWriter to(table, text);
  for (const BodyWear& w : wear) {
    for (std::size_t i = 0; i < w.points.size(); ++i) {
      const auto& [pv, cross_shear] = w.wear[i];
      if (pv == 0) continue;
      const Vector3d& point = w.points[i];
      to.text(w.body);
      if (is_pin) {
        to.number(std::atan2(point.y(), point.x()) / degree);
      } else {
        for (const double x : point) to.number(x);
      }
      to.number(pv);
      to.number(w.k.value_or(std::numeric_limits<double>::quiet_NaN()) * mm *
                mm * pv);
      to.number(cross_shear);
      to.end();
    }
  }
  cli::TableWriter writer(output, table);
  writer.write(text.view());
  writer.finish();
}

std::string draw_cycle(const JointCycle& cycle, const std::string& title,
                       const std::string& file) {
  cli::PanelPlot plot{.title = title,
                      .x_label = "time, s",
                      .x = {},
                      .panels = {{"R", "N", {}},
                                 {"Mₜ", "N m", {}},
                                 {"p", "Pa", {}},
                                 {"p v", "W/m²", {}}}};
  for (const CycleInstant& i : cycle.rows()) {
    const contact::SlidingContact sliding = cycle.sliding(i);
    const double values[] = {i.solution.reaction.norm(), moment(i),
                             i.solution.peak_pressure,
                             sliding.largest_pv().value};
    plot.x.push_back(i.time);
    for (std::size_t k = 0; k < plot.panels.size(); ++k) {
      plot.panels[k].y.push_back(values[k]);
    }
  }
  return cli::draw(plot, file);
}

}  // namespace hinge_duty
