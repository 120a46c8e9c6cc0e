#include "libcontact/half_angle/factory.hpp"

#include <charconv>
#include <limits>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/half_angle/exact.hpp"
#include "libcontact/half_angle/fitted.hpp"
#include "libcontact/half_angle/paper_laws.hpp"

namespace contact {

const std::vector<std::string>& half_angle_law_names() {
  static const std::vector<std::string> names = {
      "hertz", "arctan", "tanh", "blend", "paper", "fitted", "exact"};
  return names;
}

namespace {

LimitHalfAngle limit_of(const ElasticPair& pair,
                        const HalfAngleOptions& options) {
  if (options.limit_half_angle) {
    return LimitHalfAngle::given(*options.limit_half_angle);
  }
  return options.linear_limit
             ? LimitHalfAngle::linear_formula(pair.modulus_ratio())
             : LimitHalfAngle::arctan_formula(pair.modulus_ratio());
}

// The K of "blend:K".
double parse_share(std::string_view text) {
  double share = std::numeric_limits<double>::quiet_NaN();
  const char* const end = text.data() + text.size();
  const auto [stop, error] = std::from_chars(text.data(), end, share);
  if (error != std::errc() || stop != end) {
    throw Error(detail::must_be(
        detail::message("half-angle law blend:{}", detail::printable(text)),
        "blend:K with K a number from 0 to 1"));
  }
  return share;
}

}  // namespace

bool takes_half_angle_options(std::string_view name) {
  return name == "arctan" || name == "tanh" || name == "paper" ||
         name.starts_with("blend");
}

bool half_angle_law_allows(std::string_view name,
                           const ContactConditions& conditions) {
  const bool usual = !conditions.loading.is_back() && !conditions.walls;
  return usual || name == "exact";
}

std::unique_ptr<HalfAngleLaw> make_half_angle_law(
    std::string_view name, JointKind kind, const ElasticPair& pair,
    const HalfAngleOptions& options, const ContactConditions& conditions) {
  if (!half_angle_law_allows(name, conditions)) {
    throw Error(detail::must_be(
        detail::message("half-angle law {}", detail::printable(name)),
        "exact with " + to_string(conditions)));
  }
  if (name == "paper") {
    name = kind == JointKind::ball ? "tanh" : "blend";
  }
  const double slope = options.initial_slope;
  const auto blend = [&](double share) {
    return std::make_unique<BlendLaw>(kind, limit_of(pair, options), share,
                                      slope);
  };
  constexpr std::string_view blend_prefix = "blend:";
  if (name == "hertz") return std::make_unique<HertzLaw>(kind);
  if (name == "arctan") {
    return std::make_unique<ArctanLaw>(kind, limit_of(pair, options), slope);
  }
  if (name == "tanh") {
    return std::make_unique<TanhLaw>(kind, limit_of(pair, options), slope);
  }
  if (name == "blend") return blend(BlendLaw::recommended_arctan_share(kind));
  if (name == "fitted") return std::make_unique<FittedLaw>(kind, pair);
  if (name == "exact") {
    const auto& [loading, walls] = conditions;
    return walls ? std::make_unique<ExactLaw>(kind, *walls, loading)
                 : std::make_unique<ExactLaw>(kind, pair, loading);
  }
  if (name.starts_with(blend_prefix)) {
    return blend(parse_share(name.substr(blend_prefix.size())));
  }
  throw Error(detail::unknown("half-angle law", name, half_angle_law_names()));
}

}  // namespace contact
