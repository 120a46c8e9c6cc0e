#include "programs/identify/report.hpp"

#include <fmt/format.h>

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>

#include "libcontact/base/units.hpp"
#include "libcontact/quantities/fit.hpp"

namespace hinge_identify {
namespace {

using contact::Estimate;
using contact::FrictionFit;
using contact::FrictionParameter;
using contact::MeasuredMoment;

const contact::FitParameter& of(FrictionParameter parameter) {
  return contact::fit_parameter(parameter);
}

// Standard error, interval and, if there is one, the profile's interval.
std::vector<cli::Cell> errors(const Estimate& e, bool profile) {
  std::vector<cli::Cell> cells = {e.standard_error, e.interval.low,
                                  e.interval.high};
  if (profile) cells.insert(cells.end(), {e.profile.low, e.profile.high});
  return cells;
}

void add_correlations(const FrictionFit& fit, cli::Report& to) {
  for (Eigen::Index i = 0; i < fit.correlation.rows(); ++i) {
    for (Eigen::Index j = i + 1; j < fit.correlation.cols(); ++j) {
      to.add(fmt::format("correlation_{}_{}", of(fit.parameters[i]).name,
                         of(fit.parameters[j]).name),
             fit.correlation(i, j), "of their errors");
    }
  }
}

void add_lines(const FrictionFit& fit, bool profile, cli::Report& to) {
  for (std::size_t i = 0; i < fit.estimates.size(); ++i) {
    const contact::FitParameter& p = of(fit.parameters[i]);
    const Estimate& e = fit.estimates[i];
    to.add(p.column, e.value, p.meaning, errors(e, profile));
  }
  for (const contact::FitQuantity& q : contact::fit_quantities()) {
    if (q.key == "condition") add_correlations(fit, to);
    if (const auto* number = std::get_if<0>(&q.of)) {
      to.add(q.symbol, (*number)(fit), q.meaning);
    } else if (const auto* count = std::get_if<1>(&q.of)) {
      to.add(q.symbol, static_cast<double>((*count)(fit)), q.meaning);
    } else if (const auto* estimate = std::get_if<2>(&q.of)) {
      const Estimate& e = (*estimate)(fit);
      to.add(q.symbol, e.value, q.meaning, errors(e, profile));
    }
  }
}

// A measured component of a datum.
double measured(const MeasuredMoment& datum, int component) {
  return datum.is_vector() ? std::get<Eigen::Vector3d>(datum.moment)[component]
                           : std::get<double>(datum.moment);
}

// Number of residuals beyond 5 standard errors, estimated by the median.
std::ptrdiff_t outliers(const FrictionFit& fit) {
  std::vector<double> sizes(fit.residual.begin(), fit.residual.end());
  for (double& size : sizes) size = std::abs(size);
  std::ranges::sort(sizes);
  constexpr double normal_median = 0.6745;
  const double limit = 5 * sizes[sizes.size() / 2] / normal_median;
  return std::ranges::count_if(sizes, [&](double s) { return s > limit; });
}

double load_ratio(std::span<const MeasuredMoment> data) {
  const auto [least, most] = std::ranges::minmax(
      data, {}, [](const MeasuredMoment& d) { return d.reaction.norm(); });
  return most.reaction.norm() / least.reaction.norm();
}

// True if a trend is significant: t above the 99.9 % quantile.
bool shows(const Estimate& trend) {
  constexpr double most_by_chance = 3.6;
  return std::abs(trend.value) > most_by_chance * trend.standard_error;
}

// Adds a warning for each end of a profile that was not found.
void add_unknown_ends(const FrictionFit& fit, std::vector<std::string>& to) {
  for (std::size_t i = 0; i < fit.estimates.size(); ++i) {
    const auto& [low, high] = fit.estimates[i].profile;
    if (!std::isnan(low) && !std::isnan(high)) continue;
    to.push_back(
        fmt::format("--profile: {} of {} not found: fits of the other "
                    "parameters leave their range or do not converge",
                    !std::isnan(high)  ? "the low end"
                    : !std::isnan(low) ? "the high end"
                                       : "both ends",
                    of(fit.parameters[i]).name));
  }
}

void write_residuals_of(const cli::Joint& joint, const FrictionFit& fit,
                        std::span<const MeasuredMoment> data,
                        cli::RowWriter& row) {
  constexpr std::string_view axes[] = {"x", "y", "z"};
  Eigen::Index at = 0;
  for (std::size_t i = 0; i < data.size(); ++i) {
    for (int component = 0; component < data[i].size(); ++component, ++at) {
      write_differences(joint.differences, row);
      row.count(i + 1);
      row.text(data[i].is_vector() ? axes[component] : "about_rate");
      for (const double x :
           {data[i].reaction.norm(), direction_deg(data[i]),
            data[i].angular_velocity.norm(), measured(data[i], component),
            data[i].sigma, fit.moment[at], fit.moment_error[at],
            fit.residual[at], fit.weight[at]}) {
        row.number(x);
      }
      row.end();
    }
  }
}

}  // namespace

std::string_view column_of(FrictionParameter parameter) {
  return of(parameter).column;
}

double direction_deg(const MeasuredMoment& datum) {
  return std::atan2(datum.reaction.cross(datum.angular_velocity).norm(),
                    datum.reaction.dot(datum.angular_velocity)) /
         contact::degree;
}

cli::Report report_of(const FrictionFit& fit, bool profile) {
  std::vector<cli::Report::Beside> beside = {
      {"standard_error", true}, {"low", true}, {"high", true}};
  if (profile) {
    beside.insert(beside.end(),
                  {{"profile_low", true}, {"profile_high", true}});
  }
  cli::Report report(beside);
  add_lines(fit, profile, report);
  return report;
}

void write_residuals(const std::vector<cli::Joint>& joints,
                     const std::vector<FrictionFit>& fits,
                     std::span<const MeasuredMoment> data, cli::Output& output,
                     const cli::TableStyle& style) {
  const std::vector<std::string> columns = {
      "datum",          "component",    "R_N",       "b_deg",
      "rate_rad_per_s", "measured_N_m", "sigma_N_m", "fit_N_m",
      "fit_error_N_m",  "residual",     "weight"};
  cli::write_table(style.beside(), joint_columns(joints, {columns}), output,
                   [&](cli::RowWriter& row) {
                     for (std::size_t i = 0; i < joints.size(); ++i) {
                       write_residuals_of(joints[i], fits[i], data, row);
                     }
                   });
}

std::vector<std::string> warnings(const FrictionFit& fit,
                                  std::span<const MeasuredMoment> data,
                                  const contact::IdentifyOptions& options) {
  std::vector<std::string> all;
  const bool clearance =
      std::ranges::count(fit.parameters, FrictionParameter::clearance);
  constexpr double well_told = 30;
  if (fit.condition > well_told) {
    std::string text = fmt::format(
        "the data do not determine the parameters: condition {:.3g}, largest "
        "over smallest load {:.3g}",
        fit.condition, load_ratio(data));
    if (fit.parameters.size() == 2) {
      text += fmt::format(", correlation {:.4f}", fit.correlation(0, 1));
    }
    all.push_back(text + "; vary the load more, or use f0_effective");
  }
  for (std::size_t i = 0; i < fit.estimates.size(); ++i) {
    if (!fit.estimates[i].at_bound) continue;
    std::string text =
        fmt::format("{} is held at 0: the data would give a negative value",
                    of(fit.parameters[i]).name);
    if (fit.parameters.size() > 1) {
      text +=
          "; intervals of the other parameters treat it as known and are too "
          "short";
      if (!options.huber) text += ", intervals of --profile are not";
    }
    all.push_back(std::move(text));
  }
  if (options.profile) add_unknown_ends(fit, all);
  const contact::ContactLimits limits = fit.joint->limits();
  for (std::string& note : limits.notes(fit.largest_contact)) {
    all.push_back(std::move(note));
  }
  // A plateau up to lift-off determines it well.
  if (clearance && fit.joint->geometry().radial_clearance() > 0) {
    all.emplace_back(
        "a fitted clearance is poorly determined and its interval is skewed: "
        "use the interval of --profile, or measure the clearance");
  }
  if (const auto count = outliers(fit); count > 0 && !options.huber) {
    all.push_back(
        fmt::format("{} of {} residuals are beyond 5 standard errors "
                    "by their median; --huber reduces their weight",
                    count, fit.residual.size()));
  }
  for (std::string& note : fit.notes()) all.push_back(std::move(note));
  for (const auto& [name, trend] :
       {std::pair{"load", &fit.load_trend},
        std::pair{"direction", &fit.direction_trend},
        std::pair{"rate", &fit.rate_trend}}) {
    if (shows(*trend)) {
      all.push_back(
          fmt::format("residuals have a trend over the {}, {:.3g} -+ {:.2g} "
                      "sigma: the friction law misses a dependence",
                      name, trend->value, trend->standard_error));
    }
  }
  return all;
}

}  // namespace hinge_identify
