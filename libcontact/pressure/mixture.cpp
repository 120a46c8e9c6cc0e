#include "libcontact/pressure/mixture.hpp"

#include <cmath>

#include "libcontact/pressure/expansion.hpp"
#include "libcontact/pressure/mixture_coefficients.hpp"
#include "libcontact/pressure/registry.hpp"

namespace contact {
namespace {

// k (1 - 2 nu) of a ball's body, k of a pin's.
double contrast_part(JointKind kind, double poissons_ratio) {
  const double nu = poissons_ratio;
  const double k = (1 - 2 * nu) / (2 * (1 - nu));
  return kind == JointKind::pin ? k : k * (1 - 2 * nu);
}

}  // namespace

double pressure_contrast(JointKind kind, const ElasticPair& pair) {
  return pair.outer_compliance_share() *
             contrast_part(kind, pair.outer().poissons_ratio) -
         pair.inner_compliance_share() *
             contrast_part(kind, pair.inner().poissons_ratio);
}

MixturePressure::MixturePressure(JointKind kind, const ElasticPair& pair)
    : PressureLaw(kind, MadeFor(pair)),
      sqrt_tan_(kind),
      cosine_(kind),
      contrast_(pressure_contrast(kind, pair)) {}

double MixturePressure::largest_half_angle() const noexcept {
  return sqrt_tan_.largest_half_angle();
}

double MixturePressure::sqrt_tan_share(double half_angle) const noexcept {
  const auto& c = joint_kind() == JointKind::ball ? detail::ball_mixture
                                                  : detail::pin_mixture;
  const double h = std::sin(half_angle / 2);
  double sum = 0;
  for (int k = detail::mixture_terms - 1; k >= 0; --k) {
    sum = (sum + c.equal[k] + contrast_ * c.contrast[k]) * h;
  }
  double share = 1 - sum;
  const double cosine = std::cos(half_angle / 2);
  for (int i = 0; i < c.power; ++i) share *= cosine;
  return share;
}

double MixturePressure::mix(double half_angle, double sqrt_tan,
                            double cosine) const noexcept {
  const double w = sqrt_tan_share(half_angle);
  return w * sqrt_tan + (1 - w) * cosine;
}

double MixturePressure::pressure(double theta,
                                 double half_angle) const noexcept {
  if (half_angle == 0) return sqrt_tan_.pressure(theta, 0);
  return mix(half_angle, sqrt_tan_.pressure(theta, half_angle),
             cosine_.pressure(theta, half_angle));
}

double MixturePressure::slope(double theta, double half_angle) const noexcept {
  return mix(half_angle, sqrt_tan_.slope(theta, half_angle),
             cosine_.slope(theta, half_angle));
}

void MixturePressure::edge_slopes(double half_angle,
                                  std::span<const double> edge_variable,
                                  std::span<double> out) const noexcept {
  cosine_.edge_slopes(half_angle, edge_variable, out);
  const double w = sqrt_tan_share(half_angle);
  const double sqrt_tan = w * sqrt_tan_.peak(half_angle);
  for (double& slope : out) slope = sqrt_tan + (1 - w) * slope;
}

PressureExpansion MixturePressure::expansion(double half_angle) const noexcept {
  const double w = sqrt_tan_share(half_angle);
  PressureExpansion result = detail::expansion_of(sqrt_tan_, half_angle);
  result.cosine_share = 1 - w;
  result.coefficient[0] *= w;
  return result;
}

double MixturePressure::peak(double half_angle) const noexcept {
  if (half_angle == 0) return sqrt_tan_.peak(0);
  return mix(half_angle, sqrt_tan_.peak(half_angle), cosine_.peak(half_angle));
}

double MixturePressure::force_ratio(double half_angle) const noexcept {
  return mix(half_angle, sqrt_tan_.force_ratio(half_angle),
             cosine_.force_ratio(half_angle));
}

namespace detail {

extern constexpr PressureEntry mixture_pressure = {
    .about = {.name = "mixture",
              .meaning = "the exact pressure, nearly, in closed form",
              .accuracy = "S 0.8 %, peak 2.5 %",
              .needs = LawEntry::Needs::materials},
    .shape = "w p[sqrt_tan] + (1 - w) p[cosine]",
    .make = [](const PressureRequest& asked) -> std::unique_ptr<PressureLaw> {
      return std::make_unique<MixturePressure>(asked.kind, asked.pair);
    }};

}  // namespace detail
}  // namespace contact
