#include "libcontact/half_angle/paper_laws.hpp"

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <string_view>

#include "libcontact/base/check.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/number.hpp"
#include "libcontact/base/root_finding.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/half_angle/registry.hpp"
#include "libcontact/pair/poisson_notes.hpp"

namespace contact {
namespace {

constexpr double half_pi = std::numbers::pi / 2;
using detail::infinity;
using detail::nan;

// dln(x)/dln(load)
double load_exponent(JointKind kind) {
  return kind == JointKind::ball ? 1.0 / 3 : 0.5;
}

// The pairs (g, inverse) of the laws in xi = x/theta0*, with 1 - g(xi) where
// a caller needs it without cancellation.
double arctan_shape(double xi) { return std::atan(half_pi * xi) / half_pi; }
double arctan_slope(double xi) { return 1 / (1 + half_pi * half_pi * xi * xi); }
double arctan_rest(double xi) {
  return std::atan(1 / (half_pi * xi)) / half_pi;
}
double arctan_inverse(double ratio, double complement) {
  return ratio <= 0.5 ? std::tan(half_pi * ratio) / half_pi
                      : 1 / (half_pi * std::tan(half_pi * complement));
}

double tanh_slope(double value) { return (1 - value) * (1 + value); }
double tanh_rest(double xi) { return 2 / (std::exp(2 * xi) + 1); }
double tanh_inverse(double ratio, double complement) {
  return std::log1p(2 * ratio / complement) / 2;
}

}  // namespace

LimitHalfAngle LimitHalfAngle::given(double half_angle) {
  detail::require(half_angle > 0 && half_angle < std::numbers::pi,
                  "half-angle law", "limit_half_angle", half_angle,
                  "above 0 and below pi rad");
  return {half_angle, {}};
}

LimitHalfAngle LimitHalfAngle::arctan_formula(double modulus_ratio) {
  detail::require(modulus_ratio >= 0, "limit half-angle", "modulus_ratio",
                  modulus_ratio, "0 to inf");
  const double value_deg =
      modulus_ratio <= 1
          ? 84.85 + 4.89 * std::atan(0.436 * (1 / modulus_ratio - 1))
          : 84.85 - 2.88 * std::atan(0.711 * (modulus_ratio - 1));
  return {value_deg * degree, MadeFor(modulus_ratio)};
}

LimitHalfAngle LimitHalfAngle::linear_formula(double modulus_ratio) {
  detail::require(modulus_ratio >= 0.5 && modulus_ratio <= 2,
                  "linear limit half-angle", "modulus_ratio", modulus_ratio,
                  "0.5 to 2");
  const double value_deg = modulus_ratio <= 1
                               ? 84.85 + 2 * (1 / modulus_ratio - 1)
                               : 84.85 - 2 * (modulus_ratio - 1);
  return {value_deg * degree, MadeFor(modulus_ratio)};
}

std::vector<std::string> LimitHalfAngle::validity_notes(
    JointKind kind, const ElasticPair& pair) const {
  if (!made_for_) return {};
  std::vector<std::string> notes =
      detail::poisson_notes("the limit half-angle is a formula", pair);
  if (kind == JointKind::ball) {
    notes.emplace_back(
        "the limit half-angle is for pins; a ball's is up to 5 % larger");
  }
  return notes;
}

HalfAngleResult HertzLaw::half_angle(double load_parameter) const noexcept {
  if (!(load_parameter >= 0)) return {nan, Status::out_of_range};
  // (2.1) as atan2(x, sqrt(1 - x^2)), 1 - x^2 from the load itself: arcsin
  // would lose digits near x = 1.
  const double x =
      LoadScale::x_from_load_parameter(joint_kind(), load_parameter);
  const double rest = joint_kind() == JointKind::ball
                          ? (1 - load_parameter) * (1 + x) / (1 + x + x * x)
                          : 1 - 4 * load_parameter;
  if (!(rest >= 0)) return {nan, Status::out_of_range};
  const double cosine = std::sqrt(rest);
  const double half_angle = std::atan2(x, cosine);
  const double slope = x == 0 ? 1 : x / (cosine * half_angle);
  return {half_angle, Status::ok, load_exponent(joint_kind()) * slope};
}

LoadParameterResult HertzLaw::load_parameter(double half_angle) const noexcept {
  if (!(half_angle >= 0 && half_angle <= half_pi)) {
    return {nan, Status::out_of_range};
  }
  return {LoadScale::load_parameter_from_x(joint_kind(), std::sin(half_angle)),
          Status::ok};
}

double HertzLaw::limit_half_angle() const noexcept { return half_pi; }

std::vector<std::string> HertzLaw::validity_notes(const ElasticPair&) const {
  return {};
}

SaturatingLaw::SaturatingLaw(JointKind kind, LimitHalfAngle limit,
                             double initial_slope)
    : HalfAngleLaw(kind, limit.made_for()),
      limit_(limit),
      initial_slope_(initial_slope) {
  detail::require(detail::is_above_zero(initial_slope), "half-angle law",
                  "initial_slope", initial_slope, "above 0 and finite");
}

HalfAngleResult SaturatingLaw::half_angle(
    double load_parameter) const noexcept {
  if (!(load_parameter >= 0)) return {nan, Status::out_of_range};
  const double limit = limit_.value();
  const double x =
      LoadScale::x_from_load_parameter(joint_kind(), load_parameter);
  const double xi = initial_slope_ * x / limit;
  const Shape g = shape(xi);
  // xi g'/g tends to 1 and 0 at the ends, as 0/0 and infinity times 0.
  const double slope = xi == 0          ? 1
                       : std::isinf(xi) ? 0
                                        : xi * g.slope / g.value;
  return {limit * g.value, Status::ok, load_exponent(joint_kind()) * slope};
}

LoadParameterResult SaturatingLaw::load_parameter(
    double half_angle) const noexcept {
  const double limit = limit_.value();
  if (!(half_angle >= 0 && half_angle <= limit)) {
    return {nan, Status::out_of_range};
  }
  if (half_angle == 0) return {0, Status::ok};
  if (half_angle == limit) return {infinity, Status::ok};
  const InverseResult inverse =
      inverse_shape(half_angle / limit, (limit - half_angle) / limit);
  return {LoadScale::load_parameter_from_x(joint_kind(),
                                           inverse.xi * limit / initial_slope_),
          inverse.status};
}

std::vector<std::string> SaturatingLaw::validity_notes(
    const ElasticPair& pair) const {
  return limit_.validity_notes(joint_kind(), pair);
}

SaturatingLaw::Shape ArctanLaw::shape(double xi) const noexcept {
  return {arctan_shape(xi), arctan_slope(xi)};
}

SaturatingLaw::InverseResult ArctanLaw::inverse_shape(
    double ratio, double complement) const noexcept {
  return {arctan_inverse(ratio, complement), Status::ok};
}

SaturatingLaw::Shape TanhLaw::shape(double xi) const noexcept {
  const double value = std::tanh(xi);
  return {value, tanh_slope(value)};
}

SaturatingLaw::InverseResult TanhLaw::inverse_shape(
    double ratio, double complement) const noexcept {
  return {tanh_inverse(ratio, complement), Status::ok};
}

BlendLaw::BlendLaw(JointKind kind, LimitHalfAngle limit, double arctan_share,
                   double initial_slope)
    : SaturatingLaw(kind, limit, initial_slope), arctan_share_(arctan_share) {
  detail::require(arctan_share >= 0 && arctan_share <= 1, "blend law", "k",
                  arctan_share, "0 to 1");
}

std::string BlendLaw::name() const {
  return detail::message("blend:{}", arctan_share_);
}

std::vector<std::string> BlendLaw::validity_notes(
    const ElasticPair& pair) const {
  std::vector<std::string> notes = SaturatingLaw::validity_notes(pair);
  if (joint_kind() == JointKind::ball) {
    if (arctan_share_ != 0) {
      notes.emplace_back(
          "a blend is recommended for pins only; tanh for balls");
    }
  } else if (!(pair.modulus_ratio() > 0.5 && pair.modulus_ratio() < 2)) {
    notes.emplace_back(
        detail::message("a blend is recommended for modulus ratios between 0.5 "
                        "and 2; this pair has {:.4g}",
                        pair.modulus_ratio()));
  }
  return notes;
}

SaturatingLaw::Shape BlendLaw::shape(double xi) const noexcept {
  const double k = arctan_share_;
  const double tanh = std::tanh(xi);
  return {k * arctan_shape(xi) + (1 - k) * tanh,
          k * arctan_slope(xi) + (1 - k) * tanh_slope(tanh)};
}

SaturatingLaw::InverseResult BlendLaw::inverse_shape(
    double ratio, double complement) const noexcept {
  const double k = arctan_share_;
  // atan(pi xi/2)/(pi/2) < tanh(xi): the inverses of the two bracket the root.
  const double low = tanh_inverse(ratio, complement);
  const double high = arctan_inverse(ratio, complement);
  // Small ratios: g(xi) - r in xi. Large ones: (1 - g) - (1 - r) in 1/xi,
  // where 1 - g is nearly linear and keeps its digits.
  const bool saturated = ratio > 0.5;
  const auto residual = [&](double v) {
    if (!saturated) return shape(v).value - ratio;
    const double xi = 1 / v;
    return k * arctan_rest(xi) + (1 - k) * tanh_rest(xi) - complement;
  };
  const double start = saturated ? 1 / high : low;
  const double end = saturated ? 1 / low : high;
  const auto result = [&](double v, Status status) {
    return InverseResult{saturated ? 1 / v : v, status};
  };
  // Both increase from start to end; the ends are roots, up to rounding, for
  // k = 0 or 1 and for small ratios.
  const double residual_start = residual(start);
  const double residual_end = residual(end);
  if (!(residual_start < 0)) return result(start, Status::ok);
  if (!(residual_end > 0)) return result(end, Status::ok);

  // The bracket shrinks to 4 epsilon in 3 to 5 steps on average, in 14 at
  // k = 1e-12; 100 is never reached.
  const RootBracket root =
      shrink_bracket(residual, start, end, residual_start, residual_end, 53);
  return result(root.middle(),
                root.converged ? Status::ok : Status::not_converged);
}

namespace detail {
namespace {

LimitHalfAngle limit_of(const HalfAngleRequest& asked) {
  const HalfAngleOptions& options = asked.options;
  if (options.limit_half_angle) {
    return LimitHalfAngle::given(*options.limit_half_angle);
  }
  const double ratio = asked.pair.modulus_ratio();
  return options.linear_limit ? LimitHalfAngle::linear_formula(ratio)
                              : LimitHalfAngle::arctan_formula(ratio);
}

template <class Law>
std::unique_ptr<HalfAngleLaw> make_saturating(const HalfAngleRequest& asked) {
  return std::make_unique<Law>(asked.kind, limit_of(asked),
                               asked.options.initial_slope);
}

std::unique_ptr<HalfAngleLaw> make_blend(const HalfAngleRequest& asked,
                                         double share) {
  return std::make_unique<BlendLaw>(asked.kind, limit_of(asked), share,
                                    asked.options.initial_slope);
}

// The K of "blend:K".
double parse_share(std::string_view text) {
  if (const auto share = number_in(text)) return *share;
  throw Error(must_be(message("half-angle law blend:{}", printable(text)),
                      "blend:K with K a number from 0 to 1"));
}

}  // namespace

extern constexpr HalfAngleEntry hertz_law = {
    .about = {.name = "hertz",
              .meaning = "arcsin x, for x <= 1",
              .accuracy = "small contacts: 5 % at lambda = 0.03",
              .least_clearance = Clearance::positive},
    .equation = "(2.1)",
    .ball_cost = 4,
    .pin_cost = 2,
    .make = [](const HalfAngleRequest& asked) -> std::unique_ptr<HalfAngleLaw> {
      return std::make_unique<HertzLaw>(asked.kind);
    }};

extern constexpr HalfAngleEntry arctan_law = {
    .about = {.name = "arctan",
              .meaning = "C atan(x/C), C = 2 theta0*/pi",
              .accuracy = "11 % (pin), 19 % (ball)",
              .needs = LawEntry::Needs::materials},
    .equation = "(2.3)",
    .ball_cost = 5,
    .pin_cost = 2,
    .takes_options = true,
    .make = make_saturating<ArctanLaw>};

extern constexpr HalfAngleEntry tanh_law = {
    .about = {.name = "tanh",
              .meaning = "theta0* tanh(x/theta0*)",
              .accuracy = "15 % (pin), 4.2 % (ball)",
              .needs = LawEntry::Needs::materials},
    .equation = "(2.4)",
    .ball_cost = 6,
    .pin_cost = 3,
    .takes_options = true,
    .make = make_saturating<TanhLaw>};

extern constexpr HalfAngleEntry blend_law = {
    .about = {.name = "blend",
              .meaning = "K arctan + (1 - K) tanh; K = 1/2 for a pin, 0 for a "
                         "ball, or blend:K with K from 0 to 1",
              .accuracy = "5.8 % (pin), 4.2 % (ball)",
              .needs = LawEntry::Needs::materials},
    .equation = "section 2.1",
    .ball_cost = 7,
    .pin_cost = 4,
    .takes_options = true,
    .takes_parameter = true,
    .make = [](const HalfAngleRequest& asked) {
      return make_blend(asked,
                        asked.parameter.data() == nullptr
                            ? BlendLaw::recommended_arctan_share(asked.kind)
                            : parse_share(asked.parameter));
    }};

extern constexpr HalfAngleEntry paper_law = {
    .about = {.name = "paper",
              .meaning = "what the paper recommends: blend:0.5 for a pin, tanh "
                         "for a ball",
              .accuracy = "5.8 % (pin), 4.2 % (ball)",
              .needs = LawEntry::Needs::materials,
              .is_among_all = false},
    .equation = "section 2.1",
    .ball_cost = 6,
    .pin_cost = 4,
    .takes_options = true,
    .make = [](const HalfAngleRequest& asked) {
      return asked.kind == JointKind::ball
                 ? make_saturating<TanhLaw>(asked)
                 : make_blend(asked,
                              BlendLaw::recommended_arctan_share(asked.kind));
    }};

}  // namespace detail
}  // namespace contact
