#include "libcontact/identify/identify.hpp"

#include <algorithm>
#include <cmath>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/magnitude.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/identify/statistics.hpp"
#include "libcontact/joint/joint.hpp"

namespace contact {
namespace {

using detail::Measurements;
using detail::Minimum;
using detail::MomentModel;
using detail::Point;
using Eigen::MatrixXd;
using Eigen::VectorXd;

using detail::nan;

void check(bool good, std::string_view what, std::string_view rule) {
  if (!good) throw Error(detail::must_be(what, rule));
}

bool is_good(const MeasuredMoment& datum, bool without_load) {
  const bool finite = datum.is_vector()
                          ? std::get<Eigen::Vector3d>(datum.moment).allFinite()
                          : std::isfinite(std::get<double>(datum.moment));
  return finite && datum.reaction.allFinite() &&
         datum.angular_velocity.allFinite() &&
         (without_load || !datum.reaction.isZero(0)) &&
         !datum.angular_velocity.isZero(0) && datum.sigma > 0 &&
         std::isfinite(datum.sigma);
}

// Numbers of a point.
std::vector<int> numbers_of(const std::vector<FrictionParameter>& parameters) {
  std::vector<int> numbers;
  for (const FrictionParameter parameter : parameters) {
    numbers.push_back(static_cast<int>(parameter));
  }
  std::vector<int> sorted = numbers;
  std::ranges::sort(sorted);
  check(!numbers.empty() && std::ranges::adjacent_find(sorted) == sorted.end(),
        "parameters to fit", "at least one, each once");
  return numbers;
}

Measurements measurements(std::span<const MeasuredMoment> data,
                          Eigen::Index size) {
  Measurements all{VectorXd(size), VectorXd(size)};
  Eigen::Index at = 0;
  for (const MeasuredMoment& datum : data) {
    if (datum.is_vector()) {
      all.moment.segment<3>(at) = std::get<Eigen::Vector3d>(datum.moment);
    } else {
      all.moment[at] = std::get<double>(datum.moment);
    }
    all.sigma.segment(at, datum.size()).setConstant(datum.sigma);
    at += datum.size();
  }
  return all;
}

// Number of the datum that a measured number is of, from 0.
std::size_t datum_of(std::span<const MeasuredMoment> data,
                     Eigen::Index number) {
  std::size_t datum = 0;
  while (number >= data[datum].size()) number -= data[datum++].size();
  return datum;
}

// The name of a datum in messages, from 0.
std::string name_of(std::size_t datum, const IdentifyOptions& options) {
  return datum < options.names.size()
             ? options.names[datum]
             : detail::message("measured moment {}", datum + 1);
}

// Throws Error where the laws have no value.
void check_states(const VectorXd& moments, std::span<const MeasuredMoment> data,
                  const IdentifyOptions& options) {
  for (Eigen::Index i = 0; i < moments.size(); ++i) {
    if (std::isfinite(moments[i])) continue;
    throw Error(detail::message(
        "{} has no solution: the half-angle law or the pressure law has no "
        "value there",
        name_of(datum_of(data, i), options)));
  }
}

// The moment that it takes to turn the joint.
double torque_of(const MeasuredMoment& datum) {
  if (!datum.is_vector()) return std::get<double>(datum.moment);
  return -std::get<Eigen::Vector3d>(datum.moment)
              .dot(datum.angular_velocity.stableNormalized());
}

// The largest |M_t|/(rho R) of a datum, whatever f0 is; NaN: not known.
double largest_ratio(const JointContact& joint, const MeasuredMoment& datum) {
  double largest = nan;
  // It rises with f0 to a flat maximum or a limit; spinning has none.
  for (const double f0 : {1.0, 2.0, 4.0, 10.0, 100.0, 1e6}) {
    const Joint with(joint.with_friction(FrictionLaw(f0)));
    const JointSolution s =
        with.solve({.reaction = datum.reaction,
                    .angular_velocity = datum.angular_velocity});
    if (s.status == Status::ok) {
      largest = std::fmax(largest, s.moment_coefficient());
    }
  }
  return largest;
}

// Throws Error for moments that no friction has.
void check_sizes(const JointContact& joint,
                 std::span<const MeasuredMoment> data,
                 const IdentifyOptions& options) {
  const auto is_negative = [](const auto& d) { return torque_of(d) < 0; };
  check(!std::ranges::all_of(data, is_negative), "measured moments",
        "those that turn the joint, above 0, and all are below: is it the "
        "other sign?");
  if (joint.has_interference()) return;
  constexpr double error = 1.1;  // error of a measurement that is not wrong
  for (std::size_t i = 0; i < data.size(); ++i) {
    const double unit = joint.geometry().radius() * magnitude(data[i].reaction);
    const double ratio = std::abs(torque_of(data[i])) / unit;
    const double largest = largest_ratio(joint, data[i]);
    check(
        !(ratio > error * largest),
        detail::message("{}: |M|/(rho R) = {:.3g}", name_of(i, options), ratio),
        detail::message("0 to {:.3g}, as no f0 gives more: are loads in N, "
                        "moments in N m?",
                        largest));
  }
}

bool turn_both_ways(std::span<const MeasuredMoment> data) {
  return std::ranges::any_of(data, [&](const MeasuredMoment& d) {
    return d.angular_velocity.dot(data[0].angular_velocity) < 0;
  });
}

// One problem: what is measured and how it is fitted.
class Identification {
 public:
  Identification(const JointContact& joint,
                 std::span<const MeasuredMoment> data,
                 const IdentifyOptions& options)
      : data_(data),
        options_(options),
        model_(joint, data),
        measured_(measurements(data, model_.size())),
        free_(numbers_of(options.parameters)),
        degrees_(static_cast<int>(model_.size()) -
                 static_cast<int>(free_.size())) {
    check(degrees_ > 0, detail::message("{} measured numbers", model_.size()),
          detail::message("more than the {} parameters to fit", free_.size()));
    quantile_ = detail::student_quantile(options.level, degrees_);
    const auto& friction = std::get<FrictionLaw>(joint.friction());
    given_ = model_.point(friction.coefficient(), friction.adhesion(),
                          joint.geometry().radial_clearance());
  }

  FrictionFit fit() {
    FrictionFit fit;
    const Fitted effective = fitted(rough_start(), {0});
    Point start = given_;
    for (const int i : free_) {
      if (i == 0) start[0] = std::max(effective.point[0], 0.0);
      if (i == 1) start[1] = 0;
    }
    const Fitted best = fitted(start, free_);
    fit.status = best.status == Status::ok ? effective.status : best.status;
    fit.parameters = options_.parameters;
    fit.degrees_of_freedom = degrees_;
    fit.effective_coefficient = estimates(effective, {0})[0];
    fit.estimates = estimates(best, free_);
    describe(best, fit);
    if (options_.profile && !options_.huber) add_profiles(best, fit);
    return fit;
  }

 private:
  // A least loss with the data for its intervals.
  struct Fitted : Minimum {
    VectorXd weight;
    VectorXd residuals;
    double scale = 0;
    MatrixXd slopes;      // slopes of the residuals in `inside`
    MatrixXd covariance;  // covariance of `inside`
  };

  // Effective f0 with A = 0 from one state of weak friction, to some %.
  Point rough_start() const {
    constexpr double trial = 0.1;
    Point point = given_;
    point[0] = trial;
    point[1] = 0;
    const VectorXd moments = model_.moments(point);
    check_states(moments, data_, options_);
    const VectorXd x = moments.cwiseQuotient(measured_.sigma);
    const VectorXd y = measured_.moment.cwiseQuotient(measured_.sigma);
    point[0] = std::clamp(trial * x.dot(y) / x.squaredNorm(), 0.0, 3.0);
    return point;
  }

  Fitted fitted(const Point& start, const std::vector<int>& free) const {
    Fitted all;
    all.weight = VectorXd::Ones(model_.size());
    static_cast<Minimum&>(all) =
        least_squares(model_, measured_, all.weight, start, free);
    if (options_.huber && all.status == Status::ok) {
      const detail::HuberMinimum found =
          huber(model_, measured_, all.point, free);
      static_cast<Minimum&>(all) = found;
      all.weight = found.weight;
      all.scale = found.scale;
    }
    all.residuals = measured_.residuals(model_.moments(all.point));
    all.chi2 = all.residuals.squaredNorm();
    const auto n = static_cast<double>(model_.size() - free.size());
    if (!options_.huber) all.scale = std::sqrt(all.chi2 / n);
    all.slopes = measured_.sigma.cwiseInverse().asDiagonal() *
                 model_.slopes(all.point, all.inside);
    all.covariance =
        all.scale * all.scale * detail::inverse_of_square(all.slopes);
    if (options_.huber) {
      all.covariance *= detail::huber_factor(all.residuals / all.scale,
                                             static_cast<int>(free.size()));
    }
    return all;
  }

  // A parameter of a point in SI units, and its derivative with respect to the
  // point.
  double value(const Point& p, int number) const {
    return number == 2 ? model_.clearance(p) : p[number] * unit(p, number);
  }
  double unit(const Point& p, int number) const {
    return number == 0   ? 1
           : number == 1 ? model_.unit()
           : number == 2 ? model_.clearance_slope(p)
                         : model_.moment_unit();
  }

  std::vector<Estimate> estimates(const Fitted& best,
                                  const std::vector<int>& free) const {
    const int degrees =
        static_cast<int>(model_.size()) - static_cast<int>(free.size());
    const double quantile = detail::student_quantile(options_.level, degrees);
    std::vector<Estimate> all;
    for (const int number : free) {
      Estimate& e = all.emplace_back();
      e.value = value(best.point, number);
      const auto at = std::ranges::find(best.inside, number);
      e.at_bound = at == best.inside.end();
      if (e.at_bound) continue;
      const auto i = at - best.inside.begin();
      e.standard_error =
          unit(best.point, number) * std::sqrt(best.covariance(i, i));
      const double reach = quantile * e.standard_error;
      e.interval = {e.value - reach, e.value + reach};
    }
    return all;
  }

  void describe(const Fitted& best, FrictionFit& fit) const {
    const auto n = static_cast<Eigen::Index>(free_.size());
    fit.covariance = fit.correlation = MatrixXd::Constant(n, n, nan);
    const auto place = [&](int number) {
      return std::ranges::find(free_, number) - free_.begin();
    };
    for (std::size_t a = 0; a < best.inside.size(); ++a) {
      for (std::size_t b = 0; b < best.inside.size(); ++b) {
        const auto i = static_cast<Eigen::Index>(a);
        const auto j = static_cast<Eigen::Index>(b);
        const MatrixXd& c = best.covariance;
        const int x = best.inside[a];
        const int y = best.inside[b];
        fit.covariance(place(x), place(y)) =
            unit(best.point, x) * unit(best.point, y) * c(i, j);
        fit.correlation(place(x), place(y)) =
            i == j ? 1 : correlation(best.slopes, i, j);
      }
    }
    fit.condition = detail::scaled_condition(best.slopes);
    fit.chi2 = best.chi2;
    fit.scale = best.scale;
    fit.residual = best.residuals;
    fit.weight = best.weight;
    fit.moment =
        measured_.moment + best.residuals.cwiseProduct(measured_.sigma);
    fit.moment_error =
        measured_.sigma.cwiseProduct((best.slopes * best.covariance)
                                         .cwiseProduct(best.slopes)
                                         .rowwise()
                                         .sum()
                                         .cwiseSqrt());
    fit.joint = model_.joint_at(best.point);
    const Joint joint(*fit.joint);
    for (const MeasuredMoment& datum : data_) {
      const JointSolution s =
          joint.solve({.reaction = datum.reaction,
                       .angular_velocity = datum.angular_velocity});
      fit.largest_contact.add(s.half_angle, s.peak_pressure,
                              rim_overlap(*fit.joint, s, options_.direction));
    }
    describe_trends(best, fit);
  }

  // Correlation by the slopes alone: the covariance of exact data is 0.
  static double correlation(const MatrixXd& slopes, Eigen::Index i,
                            Eigen::Index j) {
    const MatrixXd c = detail::inverse_of_square(slopes);
    return c(i, j) / std::sqrt(c(i, i) * c(j, j));
  }

  void describe_trends(const Fitted& best, FrictionFit& fit) const {
    const Eigen::Index n = model_.size();
    VectorXd load(n);
    VectorXd direction(n);
    VectorXd rate(n);
    Eigen::Index at = 0;
    for (const MeasuredMoment& datum : data_) {
      const int size = datum.size();
      const double force = magnitude(datum.reaction);
      const double speed = magnitude(datum.angular_velocity);
      load.segment(at, size).setConstant(std::log(force));
      rate.segment(at, size).setConstant(speed);
      direction.segment(at, size).setConstant(
          angle_between(datum.reaction, datum.angular_velocity));
      at += size;
    }
    // Data of little weight in Huber's loss have little weight here.
    const VectorXd counted = best.residuals.cwiseProduct(best.weight);
    const auto over = [&](const VectorXd& x) {
      return detail::trend(counted, x, best.slopes, options_.level);
    };
    fit.load_trend = over(load);
    fit.rate_trend = over(rate);
    fit.direction_trend.value = nan;
    if (fit.joint->geometry().kind() == JointKind::ball) {
      fit.direction_trend = over(direction);
    }
  }

  static double angle_between(const Eigen::Vector3d& a,
                              const Eigen::Vector3d& b) {
    const Eigen::Vector3d x = a.stableNormalized();
    const Eigen::Vector3d y = b.stableNormalized();
    return 2 * std::atan2((x - y).norm(), (x + y).norm());
  }

  void add_profiles(const Fitted& best, FrictionFit& fit) const {
    if (best.status != Status::ok || !(best.chi2 > 0)) return;
    const MatrixXd slopes = measured_.sigma.cwiseInverse().asDiagonal() *
                            model_.slopes(best.point, free_);
    const MatrixXd covariance = detail::inverse_of_square(slopes);
    for (std::size_t i = 0; i < free_.size(); ++i) {
      const int number = free_[i];
      const auto column = covariance.col(static_cast<Eigen::Index>(i));
      const double variance = std::abs(column[static_cast<Eigen::Index>(i)]);
      Point along = Point::Zero();
      for (std::size_t k = 0; k < free_.size(); ++k) {
        along[free_[k]] = column[static_cast<Eigen::Index>(k)] / variance;
      }
      const Estimate::Interval ends = detail::profile(
          model_, measured_, best, free_, number, along,
          best.scale * std::sqrt(variance), quantile_, degrees_);
      const auto si = [&](double x) {
        Point p = best.point;
        p[number] = x;
        return value(p, number);
      };
      fit.estimates[i].profile = {si(ends.low), si(ends.high)};
    }
  }

  std::span<const MeasuredMoment> data_;
  const IdentifyOptions& options_;
  MomentModel model_;
  Measurements measured_;
  std::vector<int> free_;
  int degrees_;
  double quantile_ = 0;
  Point given_;
};

}  // namespace

FrictionFit identify_friction(const JointContact& joint,
                              std::span<const MeasuredMoment> data,
                              const IdentifyOptions& options) {
  check(std::holds_alternative<FrictionLaw>(joint.friction()),
        "friction of the joint", "dry");
  check(!data.empty(), "measured moments", "at least one");
  check(options.level > 0 && options.level < 1,
        detail::message("level = {}", options.level), "above 0 and below 1");
  const auto is_fitted = [&](FrictionParameter parameter) {
    return std::ranges::count(options.parameters, parameter) > 0;
  };
  const bool has_offset = is_fitted(FrictionParameter::offset);
  const bool without_load = has_offset || is_fitted(FrictionParameter::drag);
  for (std::size_t i = 0; i < data.size(); ++i) {
    check(is_good(data[i], without_load || joint.has_interference()),
          name_of(i, options),
          "finite, with a reaction and an angular velocity other than 0 and "
          "sigma above 0");
  }
  check(!has_offset || turn_both_ways(data), "states of a fitted offset",
        "such that turn both ways; what does not turn round is drag");
  check(joint.has_interference() ||
            std::ranges::any_of(
                data, [](const auto& d) { return !d.reaction.isZero(0); }),
        "reactions", "other than 0 in one of the states");
  if (!without_load) check_sizes(joint, data, options);
  return Identification(joint, data, options).fit();
}

std::vector<std::string> FrictionFit::notes() const {
  constexpr double factor = 1.5;
  constexpr double chance = 1e-3;
  const bool is_large = scale > 1;
  if (!(scale > factor || scale < 1 / factor) ||
      detail::chance_of(scale * scale, degrees_of_freedom) > chance) {
    return {};
  }
  std::string text = detail::message(
      "residuals are {:.3g} times as large as sigma suggests, chi2/dof "
      "{:.3g}: ",
      scale, chi2 / degrees_of_freedom);
  text += is_large ? "the joint has more than this friction (a seal's drag, a "
                     "sensor's offset: fit them too), or sigma is too small"
                   : "sigma is too large";
  return {text};
}

Estimate FrictionFit::predicted_moment(const Eigen::Vector3d& reaction,
                                       const Eigen::Vector3d& angular_velocity,
                                       double level) const {
  const MeasuredMoment state{reaction, angular_velocity, 0.0, 1};
  const MomentModel model(*joint, {&state, 1});
  const auto& friction = std::get<FrictionLaw>(joint->friction());
  const double clearance = joint->geometry().radial_clearance();
  const Point point =
      model.point(friction.coefficient(), friction.adhesion(), clearance);
  const double unit[] = {1, model.unit(), model.clearance_slope(point),
                         model.moment_unit()};
  double drag = 0;
  VectorXd slope = VectorXd::Zero(covariance.rows());
  MatrixXd known = covariance;
  for (Eigen::Index i = 0; i < slope.size(); ++i) {
    const FrictionParameter parameter = parameters[i];
    if (parameter == FrictionParameter::drag) drag = estimates[i].value;
    // It belongs to the measurement, not to the joint.
    if (parameter == FrictionParameter::offset) continue;
    if (std::isnan(known(i, i))) continue;
    const int number = static_cast<int>(parameter);
    slope[i] = model.slopes(point, {number})(0, 0) / unit[number];
  }
  known = known.array().isNaN().select(0, known);
  Estimate found;
  found.value = model.moments(point)[0] + drag;
  found.standard_error = std::sqrt(slope.dot(known * slope));
  const double reach = detail::student_quantile(level, degrees_of_freedom) *
                       found.standard_error;
  found.interval = {found.value - reach, found.value + reach};
  return found;
}

}  // namespace contact
