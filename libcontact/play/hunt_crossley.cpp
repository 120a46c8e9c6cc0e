#include "libcontact/play/hunt_crossley.hpp"

#include <boost/math/special_functions/lambert_w.hpp>
#include <boost/math/special_functions/log1p.hpp>
#include <boost/math/tools/toms748_solve.hpp>
#include <cmath>
#include <cstdint>
#include <limits>

#include "libcontact/base/check.hpp"

namespace contact {
namespace {

// z - ln(1 + z), to its own digits.
double excess(double z) { return -boost::math::log1pmx(z); }

// The z of excess(z) = y of the sign `sign`.
double inverse_excess(double y, int sign) {
  if (!(y > 0)) return y == 0 ? 0 : std::numeric_limits<double>::quiet_NaN();
  if (y > 0.05) {
    if (y > 700) return sign > 0 ? y + std::log(y + std::log(y) + 1) : -1;
    const double argument = -std::exp(-1 - y);
    return -1 - (sign > 0 ? boost::math::lambert_wm1(argument)
                          : boost::math::lambert_w0(argument));
  }
  // Near 0 both branches meet: a series and Newton's steps.
  const double p = sign * std::sqrt(2 * y);
  double z = p * (1 + p * (1.0 / 3 + p / 36));
  for (int i = 0; i < 3; ++i) z -= (excess(z) - y) * (1 + z) / z;
  return z;
}

double restitution_of(double x) {
  return x == 0 ? 1 : -inverse_excess(excess(x), -1) / x;
}

// X of e.
double damping_number(double e) {
  const double rest = 1 - e;
  if (rest < 1e-4) return rest * (1.5 + rest * (1.5 + rest * 1.35));
  if (e < 0.15) {
    double x = 1 / e;
    for (int i = 0; i < 12; ++i) x = (1 - (1 + x) * std::exp(-(1 + e) * x)) / e;
    return x;
  }
  const auto residual = [e](double x) { return excess(-e * x) - excess(x); };
  std::uintmax_t steps = 100;
  const auto [low, high] = boost::math::tools::toms748_solve(
      residual, 0.75 * rest, (1 - 1e-15) / e,
      boost::math::tools::eps_tolerance<double>(52), steps);
  return (low + high) / 2;
}

}  // namespace

HuntCrossley::HuntCrossley(double damping) : damping_(damping) {
  detail::require(detail::is_not_negative(damping), "impact", "damping",
                  damping, "0 s/m or more");
}

HuntCrossley HuntCrossley::from_restitution(double restitution,
                                            double reference_speed) {
  detail::require(restitution > 0 && restitution <= 1, "impact", "restitution",
                  restitution, "above 0, and at most 1");
  detail::require(detail::is_above_zero(reference_speed), "impact",
                  "reference_speed", reference_speed, "above 0 m/s");
  return HuntCrossley(damping_number(restitution) / reference_speed);
}

double HuntCrossley::restitution(double speed) const noexcept {
  return restitution_of(damping_ * speed);
}

double HuntCrossley::energy_share(double speed) const noexcept {
  const double x = damping_ * speed;
  return x == 0 ? 1 : 2 * excess(x) / (x * x);
}

double HuntCrossley::speed_inwards(double energy_per_mass) const noexcept {
  if (damping_ == 0) return std::sqrt(2 * energy_per_mass);
  return inverse_excess(damping_ * damping_ * energy_per_mass, 1) / damping_;
}

double HuntCrossley::speed_outwards(double energy_per_mass) const noexcept {
  if (damping_ == 0) return std::sqrt(2 * energy_per_mass);
  return -inverse_excess(damping_ * damping_ * energy_per_mass, -1) / damping_;
}

ApproximateRestitution approximate_restitution(double e) noexcept {
  return {restitution_of(3 * (1 - e * e) / 4), restitution_of(3 * (1 - e) / 2),
          restitution_of(8 * (1 - e) / (5 * e))};
}

}  // namespace contact
