// SPDX-License-Identifier: MIT
#pragma once

#include <functional>
#include <limits>
#include <memory>
#include <string>
#include <vector>

namespace contact {

/// A friction stress tau(p, v) of pressure and sliding speed, by one of the
/// named laws, by a table, or one's own. tau must not fall with p: the
/// equations of a joint could then have several solutions.
///
/// Cheap to copy.
class FrictionStress {
 public:
  /// How a friction stress changes with the sliding speed at constant pressure.
  enum class OverSpeed {
    constant,
    rises,
    /// Somewhere: no convex set of moments, so that nothing can be said of
    /// rest; real joints stick and slip there.
    falls,
  };

  /// Stress in Pa from p in Pa and v in m/s, both >= 0 and finite: >= 0, 0 or
  /// more at p = 0. Does not throw, and may be called by several threads.
  using Function = std::function<double(double pressure, double speed)>;

  /// Makes a stress from a function of the caller's.
  FrictionStress(Function stress, OverSpeed over_speed);

  /// p (fc + (fs - fc) exp(-v/vs)): from fs at rest to fc when sliding.
  /// @param static_coefficient, dynamic_coefficient  fs, fc, [0, infinity)
  /// @param speed  vs, m/s, (0, infinity)
  /// @throws Error if an argument is out of range.
  static FrictionStress stribeck(double static_coefficient,
                                 double dynamic_coefficient, double speed);
  /// f p (p/p_r)^-m.
  /// @param coefficient  f, [0, infinity), at the pressure p_r
  /// @param pressure     p_r, Pa, (0, infinity)
  /// @param exponent     m, [0, 1]
  /// @throws Error if an argument is out of range.
  static FrictionStress power(double coefficient, double pressure,
                              double exponent);

  /// Coefficients of friction at some points; constant outside of them.
  struct Table {
    /// Interpolation between the points of a table of friction coefficients.
    enum class Curve {
      spline,  ///< natural cubic spline in the logarithm, two continuous slopes
      linear,  ///< in the logarithm; costs friction up to some 1e-3
    };

    std::vector<double> points;        ///< 2 or more, > 0, ascending
    std::vector<double> coefficients;  ///< as many, >= 0
    Curve curve = Curve::spline;

    friend bool operator==(const Table&, const Table&) = default;
  };
  /// p f(p), points in Pa.
  /// @throws Error if the table is not so, or if the curve through it falls
  ///         below 0 or makes p f fall with p.
  static FrictionStress of_pressure(const Table& table);
  /// p f(v/p), points in m/(s Pa): a Hersey number over the viscosity.
  /// @throws Error as of_pressure()
  static FrictionStress of_hersey(const Table& table);

  /// tau, Pa.
  double stress_at(double pressure, double speed) const {
    return (*stress_)(pressure, at_rest_ ? 0 : speed);
  }
  OverSpeed over_speed() const { return over_speed_; }
  /// m/s, within which tau changes beside the rest, as Stribeck's vs; infinite
  /// for laws that have none.
  double speed_scale() const { return at_rest_ ? no_scale : speed_scale_; }
  /// tau(p, 0) at every speed.
  FrictionStress at_rest() const;
  /// Note on a loss of accuracy, for programs to print; "" for none.
  const std::string& note() const { return note_; }

  /// Name of the law, if it is a named one, and the arguments of its function.
  struct Source {
    /// "stribeck", "power", "pressure_table" or "hersey_table"; "" if one's
    /// own.
    std::string law = {};
    /// In the order of the arguments; of a table none.
    std::vector<double> numbers = {};
    Table table = {};

    friend bool operator==(const Source&, const Source&) = default;
  };
  const Source& source() const { return source_; }

  /// The same law with the same arguments; one's own functions are equal if
  /// they are copies of one.
  friend bool operator==(const FrictionStress& a, const FrictionStress& b) {
    return a.source_ == b.source_ && a.at_rest_ == b.at_rest_ &&
           (!a.source_.law.empty() || a.stress_ == b.stress_);
  }

 private:
  static constexpr double no_scale = std::numeric_limits<double>::infinity();
  std::shared_ptr<const Function> stress_;
  Source source_;
  OverSpeed over_speed_;
  double speed_scale_ = no_scale;
  bool at_rest_ = false;
  std::string note_;
};

}  // namespace contact
