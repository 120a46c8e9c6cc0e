#include "programs/duty/summary.hpp"

#include <fmt/format.h>

#include <limits>
#include <string>
#include <string_view>

#include "libcontact/base/units.hpp"
#include "programs/duty/worn_quantities.hpp"

namespace hinge_duty {
namespace {

using Instant = contact::JointCycle::Instant;
using contact::degree;
using contact::JointCycle;
using Eigen::Vector3d;

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

double moment(const Instant& i) { return i.solution.friction_moment.norm(); }

void write_integrals(const JointCycle& cycle, double pv_integral, Lines& to) {
  const double period = cycle.cycle().period();
  const double rho = cycle.contact().geometry().radius();
  const double energy =
      cycle.integral([](const Instant& i) { return -i.solution.power; });
  to.number("period_s", period, "one cycle; integrals and means are over it");
  to.number("closure_deg", cycle.cycle().closure() / degree,
            "by which the turn of integrated rates fails to close");
  to.number("energy_J", energy, "dissipated by friction");
  to.number("mean_heat_W", energy / period, "energy over period");
  to.number("sliding_path_m", cycle.integral([&](const Instant& i) {
    return rho * i.state.angular_velocity.norm();
  }),
            "of the rim: integral of rho |Dw|");
  to.number("effective_sliding_distance_m",
            cycle.integral([&](const Instant& i) {
              return rho * i.state.angular_velocity.norm() *
                     cycle.sliding(i).slip_coefficient();
            }),
            "integral of rho |Dw| L, what wears under p");
  to.number("pv_integral_J", pv_integral,
            "of p v over contact and time; times k: volume");
  to.number("mean_M_t_N_m", cycle.integral(moment) / period,
            "mean of the friction moment");
  to.number("contact_spread_deg", cycle.contact_spread() / degree,
            "of the contact over the seat: rms angle from its middle, weight "
            "p v");
}

void write_moments(const JointCycle& cycle, Lines& to) {
  constexpr std::string_view axes[] = {"x", "y", "z"};
  for (int k = 0; k < 3; ++k) {
    for (const int sign : {-1, 1}) {
      const Instant most = cycle.largest([&](const Instant& i) {
        return sign * i.solution.friction_moment[k];
      });
      to.at_time(
          fmt::format("{}_M_t_{}_N_m", sign < 0 ? "least" : "largest", axes[k]),
          most.solution.friction_moment[k], most.time,
          "friction moment on the body");
    }
  }
}

void write_peaks(const JointCycle& cycle, Lines& to) {
  const auto peak = [&](std::string_view name,
                        const JointCycle::Quantity& quantity, double unit,
                        std::string_view meaning) {
    const Instant i = cycle.largest(quantity);
    to.at_time(name, quantity(i) / unit, i.time, meaning);
  };
  const auto pv = [&](const Instant& i) {
    return cycle.sliding(i).largest_pv().value;
  };
  const auto heat = [&](const Instant& i) {
    return cycle.sliding(i).largest_heat_flux().value;
  };
  peak("largest_M_t_N_m", moment, 1, "friction moment");
  write_moments(cycle, to);
  peak(
      "largest_p_peak_Pa",
      [](const Instant& i) { return i.solution.peak_pressure; }, 1,
      "peak pressure");
  peak(
      "largest_theta0_deg",
      [](const Instant& i) { return i.solution.half_angle; }, degree,
      "half-angle of the contact");
  peak(
      "least_theta0_deg",
      [](const Instant& i) { return -i.solution.half_angle; }, -degree,
      "half-angle of the contact");
  Instant i = cycle.largest(pv);
  to.at_place("largest_pv_max_W_per_m2", pv(i), i.time,
              cycle.sliding(i).largest_pv().place,
              "largest p v; x, y, z from the joint's centre, carrier axes");
  i = cycle.largest(heat);
  to.at_place("largest_q_max_W_per_m2", heat(i), i.time,
              cycle.sliding(i).largest_heat_flux().place,
              "largest heat flux of friction, into both bodies");
  peak(
      "largest_pv_nominal_W_per_m2",
      [&](const Instant& x) { return cycle.sliding(x).pv_nominal(); }, 1,
      "p v with the next area; catalogues may have another");
  to.number("nominal_area_m2",
            1 / cycle.contact().geometry().nominal_pressure(1),
            "projected: pi rho^2 or 2 rho L");
}

void write_wear(const BodyWear& wear, double pv_integral, Lines& to) {
  const std::string of = "_" + wear.body;
  constexpr double none = std::numeric_limits<double>::quiet_NaN();
  if (wear.k) {
    to.number("k_" + wear.surface + "_mm3_per_N_m", *wear.k,
              "wear coefficient, as given");
    to.number("volume_" + wear.surface + "_mm3", *wear.k * pv_integral,
              "worn off in one cycle: k pv_integral_J");
    to.at_place("largest_depth" + of + "_mm", wear.depth(wear.deepest.wear),
                none, wear.deepest.point,
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

}  // namespace

void write_summary(const JointCycle& cycle, const std::vector<BodyWear>& wear,
                   const std::optional<MeasuredWear>& measured,
                   const std::vector<contact::WearIn::State>& worn,
                   cli::Output& output, const cli::TableStyle& style) {
  const cli::Table table(
      style, {"quantity", "value", "at_time_s", "x", "y", "z", "meaning"});
  Lines lines(table);
  const double pv_integral = cycle.integral(
      [&](const Instant& i) { return cycle.sliding(i).pv_total(); });
  write_integrals(cycle, pv_integral, lines);
  write_peaks(cycle, lines);
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

}  // namespace hinge_duty
