// SPDX-License-Identifier: MIT
#pragma once

#include <Eigen/Core>
#include <limits>
#include <optional>
#include <span>
#include <string>
#include <variant>
#include <vector>

#include "libcontact/joint/contact.hpp"
#include "libcontact/joint/contact_notes.hpp"
#include "libcontact/pressure/validity.hpp"

/// Friction parameters from measured moments (docs/how-to/identify.md).
namespace contact {

/// A friction moment that was measured while a joint slides.
struct MeasuredMoment {
  /// R on the body, N; not 0 but of joints with interference, which turn hard
  /// without load too, and where drag or offset is fitted.
  Eigen::Vector3d reaction;
  Eigen::Vector3d angular_velocity;  ///< Dw, rad/s; not 0
  /// The moment that it takes to turn the joint, -M_t . Dw/|Dw|, or the vector
  /// M_t on the body; N m.
  std::variant<double, Eigen::Vector3d> moment;
  /// Standard error of the moment, or of each component, N m; > 0. Their ratios
  /// alone count.
  double sigma;

  bool is_vector() const {
    return std::holds_alternative<Eigen::Vector3d>(moment);
  }
  /// How many numbers that are: 1 or 3.
  int size() const { return is_vector() ? 3 : 1; }
};

/// Parameters that are fitted.
enum class FrictionParameter {
  coefficient,  ///< f0
  adhesion,     ///< A, Pa
  /// eps, m. From a joint without clearance or with interference it is searched
  /// on both sides of 0, else above 0.
  clearance,
  /// A moment that resists whatever the load is, as of a seal, N m.
  drag,
  /// A moment that does not turn round with Dw, as of a sensor, N m: added to
  /// the moment that it takes to turn about the first datum's Dw.
  offset,
};

struct IdentifyOptions {
  std::vector<FrictionParameter> parameters = {FrictionParameter::coefficient,
                                               FrictionParameter::adhesion};
  /// Huber's loss instead of least squares: a few wrong data do no harm.
  bool huber = false;
  /// Intervals by refitting too, see Estimate::profile. Not with huber.
  bool profile = false;
  /// Probability of the intervals, above 0 and below 1.
  double level = 0.95;
  /// Direction of the reactions, for FrictionFit::largest_contact.
  LoadDirection direction = LoadDirection::vector;
  /// Names of the data in messages, as "rig.csv, line 3"; empty: "measured
  /// moment 3".
  std::vector<std::string> names = {};
};

/// A number that is found. NaN: there is none.
struct Estimate {
  /// Confidence interval.
  struct Interval {
    double low = std::numeric_limits<double>::quiet_NaN();
    double high = std::numeric_limits<double>::quiet_NaN();
  };

  double value = 0;
  double standard_error = std::numeric_limits<double>::quiet_NaN();
  /// value -+ quantile of Student's t times the standard error.
  Interval interval = {};
  /// Profile interval: at its ends, with the other parameters fitted anew, chi2
  /// has risen by t^2 chi2/dof; it ends at 0, and is infinite where chi2 never
  /// rises so far. NaN: the others leave their ranges before, so that there is
  /// no end; the end of f0 is then that with the clearance at an end of its
  /// range.
  Interval profile = {};
  /// Held at f0 = 0 or A = 0; the data fit best below.
  bool at_bound = false;
};

/// The friction of a joint that fits measured moments.
struct FrictionFit {
  Status status = Status::not_converged;
  std::vector<FrictionParameter> parameters;
  std::vector<Estimate> estimates;  ///< one for each parameter
  /// f0 alone with A = 0, at the joint's own clearance, by the same loss.
  Estimate effective_coefficient;
  /// Covariance and correlations of the estimates; NaN of those at_bound.
  Eigen::MatrixXd covariance;
  Eigen::MatrixXd correlation;
  /// Condition number of the slopes of the moments, each column scaled to 1:
  /// how badly the data tell the parameters apart.
  double condition = 1;
  /// Sum of squares of the residuals, unweighted.
  double chi2 = 0;
  int degrees_of_freedom = 0;
  /// Standard error of the data in units of sigma: sqrt(chi2/dof), or Huber's
  /// scale.
  double scale = 0;
  /// One element per measured number, in order: the moment of the fit, N m, its
  /// standard error, (fit - measured)/sigma, and Huber's weight.
  Eigen::VectorXd moment;
  Eigen::VectorXd moment_error;
  Eigen::VectorXd residual;
  Eigen::VectorXd weight;
  /// Residuals, in sigma, over ln R, b (rad) and |Dw| (rad/s): slopes of a
  /// fourth parameter that the fit leaves out. Without value where the data do
  /// not vary enough, and direction of a pin.
  Estimate load_trend;
  Estimate direction_trend;
  Estimate rate_trend;
  /// Largest contact over the data's states with these parameters: for
  /// ContactLimits.
  LargestContact largest_contact;
  /// The joint with these parameters.
  std::optional<JointContact> joint;

  /// Notes for programs to print, if sigma is known: on errors 1.5 times larger
  /// or smaller than it says, which have a probability below 0.1 %.
  std::vector<std::string> notes() const;

  /// Moment predicted for another state.
  /// @param reaction, angular_velocity  as in MeasuredMoment
  /// @param level  probability of the interval
  /// @return -M_t . Dw/|Dw| with the drag, without the offset, N m, with the
  ///         standard error of the fit
  Estimate predicted_moment(const Eigen::Vector3d& reaction,
                            const Eigen::Vector3d& angular_velocity,
                            double level = 0.95) const;
};

/// Finds friction parameters with which a joint has measured moments. Those
/// that are not looked for are the joint's.
///
/// Estimates agree with an independent program to 1e-7, profiles to 1e-5; exact
/// data give their parameters back to 1e-11 (identify/identify_test.cpp), with
/// interference to 1e-9 (identify/interference_test.cpp).
/// @throws Error for a viscous joint, a parameter that is named twice, data
///         that are too few or out of range or for which the joint's laws have
///         no value, moments that no f0 can give or that are all negative
///         while neither drag nor offset is fitted, and an offset of states
///         that turn one way.
FrictionFit identify_friction(const JointContact& joint,
                              std::span<const MeasuredMoment> data,
                              const IdentifyOptions& options = {});

}  // namespace contact
