#include "libcontact/tools/reference/quadrature.hpp"

#include <gsl/gsl_errno.h>
#include <gsl/gsl_integration.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <memory>
#include <numbers>

#include "libcontact/tools/reference/gsl.hpp"

namespace contact::reference {
namespace {

constexpr std::size_t max_intervals = 200;
constexpr double pi = std::numbers::pi;

struct FreeWorkspace {
  void operator()(gsl_integration_workspace* w) const {
    gsl_integration_workspace_free(w);
  }
};
using Workspace = std::unique_ptr<gsl_integration_workspace, FreeWorkspace>;

Workspace make_workspace() {
  return Workspace(gsl_integration_workspace_alloc(max_intervals));
}

/// A C++ callable as a gsl_function.
template <class Function>
gsl_function as_gsl(Function& function) {
  return {[](double x, void* f) { return (*static_cast<Function*>(f))(x); },
          &function};
}

enum class Role { force, sliding, spinning };

enum class Weight { one, cosine, law };

/// One of the six double integrals.
struct Integral {
  Role role;
  Weight weight;
  const PressureLaw* law;  ///< for Weight::law
  double half_angle;
  SlipAxis axis;
  double tolerance;
};

struct Estimate {
  double value = 0;
  double error = 0;
};

/// Integrand of the definition at the point t, psi, where psi = 90 deg - f is
/// the longitude from the plane of the slip axis: r = (sin t sin psi,
/// sin t cos psi, cos t), slip velocity Dw x r, moments r x (Dw x r). The
/// weight and sin t of the area are left to the outer integral.
double integrand(Role role, SlipAxis axis, double sin_t, double cos_t,
                 double psi) {
  const double x = sin_t * std::sin(psi);
  const double y = sin_t * std::cos(psi);
  const double slip_x = axis.cos * cos_t - axis.sin * y;
  const double speed = std::sqrt(slip_x * slip_x + x * x);  // |Dw x r|
  switch (role) {
    case Role::force:
      return slip_x / speed;
    case Role::sliding:
      return (cos_t * slip_x + x * axis.cos * x) / speed;
    default:
      return (x * axis.sin * x - y * slip_x) / speed;
  }
}

double weight(const Integral& integral, double t) {
  const double theta0 = integral.half_angle;
  switch (integral.weight) {
    case Weight::cosine:
      // cos t - cos theta0 without cancellation
      return 2 * std::sin((theta0 - t) / 2) * std::sin((theta0 + t) / 2);
    case Weight::law:
      return integral.law->pressure(t, theta0) /
             integral.law->pressure(0, theta0);
    default:
      return 1;
  }
}

class Quadrature {
 public:
  Quadrature() : inner_(make_workspace()), outer_(make_workspace()) {}

  /// The double integral. The error is the outer rule's own estimate, asked
  /// to be half of the tolerance, and the largest of the inner ones over the
  /// whole interval.
  Estimate operator()(const Integral& integral) {
    const double theta0 = integral.half_angle;
    double inner_error = 0;
    auto over_colatitude = [&](double t) {
      const double scale = 2 * weight(integral, t) * std::sin(t);  // +-psi
      const Estimate inner = over_longitude(integral, t);
      inner_error = std::max(inner_error, scale * inner.error);
      return scale * inner.value;
    };
    const double pole = std::atan2(integral.axis.cos, integral.axis.sin);
    std::array<double, 4> points{0};
    std::size_t count = 1;
    for (const double t :
         {std::min(pole, pi - pole), std::max(pole, pi - pole)}) {
      if (t > points[count - 1] && t < theta0) points[count++] = t;
    }
    points[count++] = theta0;
    gsl_function function = as_gsl(over_colatitude);
    Estimate result;
    gsl_integration_qagp(&function, points.data(), count, 0,
                         integral.tolerance / 2, max_intervals, outer_.get(),
                         &result.value, &result.error);
    result.error += theta0 * inner_error;
    return result;
  }

  std::size_t evaluations() const { return evaluations_; }

 private:
  Estimate over_longitude(const Integral& integral, double t) {
    const double sin_t = std::sin(t), cos_t = std::cos(t);
    auto over_psi = [&](double psi) {
      ++evaluations_;
      return integrand(integral.role, integral.axis, sin_t, cos_t, psi);
    };
    gsl_function function = as_gsl(over_psi);
    // The integrand turns within an angle of about |t - pole|/sin t of the
    // plane of the slip axis: split there.
    const double pole = std::atan2(integral.axis.cos, integral.axis.sin);
    std::array<double, 4> points{
        0, std::min(1.0, 2 * std::abs(t - pole) / sin_t),
        pi - std::min(1.0, 2 * std::abs(t - (pi - pole)) / sin_t), pi};
    const bool at_pole = points[1] < 1e-12 || pi - points[2] < 1e-12;
    if (at_pole) points[1] = pi;
    // A tenth of the tolerance; not less than the rounding of integrands of
    // the size 1 or sin t.
    const double size = integral.role == Role::spinning ? sin_t : 1.0;
    Estimate result;
    gsl_integration_qagp(&function, points.data(), at_pole ? 2 : 4,
                         2e-15 * size, integral.tolerance / 10, max_intervals,
                         inner_.get(), &result.value, &result.error);
    return result;
  }

  Workspace inner_, outer_;
  std::size_t evaluations_ = 0;
};

}  // namespace

namespace {

// Integrates the cosine pressure if there is no law.
QuadratureResult by_quadrature(const PressureLaw* law, double half_angle,
                               SlipAxis axis, double tolerance) {
  use_gsl_return_codes();
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const FrictionTriple none{nan, nan, nan}, zero{0, 0, 0};
  // Sine and cosine may exceed 1 by the rounding of unit vectors.
  constexpr double limit = 1.000001;
  if (!(half_angle >= 0 && half_angle <= pi && axis.cos >= 0 &&
        axis.cos <= limit && std::abs(axis.sin) <= limit &&
        tolerance >= 1e-13 && tolerance <= 1e-2)) {
    return {{nan, none, none, none},
            {nan, none, none, none},
            Status::out_of_range,
            0};
  }
  if (half_angle == 0) {
    const double one = axis.cos > 0 ? 1 : 0;
    return {
        {0, zero, zero, {one, one, 0}}, {0, zero, zero, zero}, Status::ok, 0};
  }
  Quadrature quadrature;
  bool converged = true;
  const auto triple = [&](Weight weight, FrictionTriple& value,
                          FrictionTriple& error) {
    const auto one = [&](Role role, bool vanishes, double& v, double& e) {
      const Estimate estimate =
          vanishes ? Estimate{}
                   : quadrature(Integral{role, weight, law, half_angle, axis,
                                         tolerance});
      v = estimate.value;
      e = estimate.error;
      converged = converged && e <= tolerance * std::abs(v);
    };
    one(Role::force, axis.cos == 0, value.force, error.force);
    one(Role::sliding, axis.cos == 0, value.sliding, error.sliding);
    one(Role::spinning, axis.sin == 0, value.spinning, error.spinning);
  };
  QuadratureResult result{};
  const double half = std::sin(half_angle / 2);
  const double rise = 2 * half * half;  // 1 - cos theta0
  const double normal = law ? 1 / law->pressure(0, half_angle)
                            : pi / 3 * rise * rise * (3 - rise);
  result.value.normal = normal;
  triple(law ? Weight::law : Weight::cosine, result.value.pressure,
         result.error.pressure);
  triple(Weight::one, result.value.area, result.error.area);
  const auto over_normal = [&](const FrictionTriple& f) {
    return FrictionTriple{f.force / normal, f.sliding / normal,
                          f.spinning / normal};
  };
  result.value.coefficient = over_normal(result.value.pressure);
  result.error.coefficient = over_normal(result.error.pressure);
  result.status = converged ? Status::ok : Status::not_converged;
  result.evaluations = quadrature.evaluations();
  return result;
}

}  // namespace

QuadratureResult quadrature_friction_integrals(double half_angle, SlipAxis axis,
                                               double tolerance) {
  return by_quadrature(nullptr, half_angle, axis, tolerance);
}

QuadratureResult quadrature_friction_integrals(const PressureLaw& law,
                                               double half_angle, SlipAxis axis,
                                               double tolerance) {
  return by_quadrature(&law, half_angle, axis, tolerance);
}

}  // namespace contact::reference
