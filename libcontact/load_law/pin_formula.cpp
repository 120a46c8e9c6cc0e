#include "libcontact/load_law/pin_formula.hpp"

#include <cmath>

namespace contact::detail {
namespace {

// wrap() is S, of interference (S - c0)/u^2, and rise() its derivative. NaN
// passes: it is not below anything.
// clang-format off
#define CLEARANCE                                               \
  Real bend, normal, u, ratio, moment, slope;                     \
  bend = 1 / sqrt(1 + f * f);                                   \
  normal = load * bend;                                         \
  u = normal / (normal + scale);                                \
  ratio = wrap(u);                                                \
  moment = radius * f * normal * ratio;                           \
  slope = radius * f * bend * (ratio + u * (1 - u) * rise(u));
#define INTERFERENCE                                            \
  Real bend, push, normal, u, x, part, ratio, moment, slope;      \
  bend = 1 / sqrt(1 + f * f);                                   \
  push = load * bend;                                           \
  normal = push < scale ? scale : push;                         \
  u = sqrt(1 - scale / normal);                                 \
  x = 2 * u - 1;                                                \
  part = wrap(x);                                               \
  ratio = closed + u * u * part;                                  \
  moment = radius * f * normal * ratio;                           \
  slope = ratio + (1 - u * u) * (part + u * rise(x));             \
  slope = push < scale ? 0 : radius * f * bend * slope;
#define ADHESION                                                \
  Real inside, t, arm, moment, slope;                           \
  inside = load < low ? low : load;                             \
  inside = load > high ? high : inside;                         \
  t = (log(inside) - middle) / half;                            \
  arm = wrap(t);                                                \
  moment = load * arm;                                          \
  slope = load == inside ? arm + rise(t) / half : arm;
// clang-format on

std::vector<double> derivative(const std::vector<double>& c) {
  std::vector<double> d;
  for (std::size_t i = 1; i < c.size(); ++i) d.push_back(double(i) * c[i]);
  return d;
}

}  // namespace

std::string_view pin_formula(const PinLoadLaw& law) {
  switch (law.form) {
    case PinLoadLaw::Form::clearance:
      return CONTACT_TEXT_OF(CLEARANCE);
    case PinLoadLaw::Form::interference:
      return CONTACT_TEXT_OF(INTERFERENCE);
    case PinLoadLaw::Form::adhesion:
      break;
  }
  return CONTACT_TEXT_OF(ADHESION);
}

Constants pin_constants(const PinLoadLaw& law) {
  const auto [low, high] = law.loads;
  const bool pressed = law.form == PinLoadLaw::Form::interference;
  const std::vector<double> c(law.numbers.begin() + (pressed ? 1 : 0),
                              law.numbers.end());
  return {{{"radius", law.radius},
           {"scale", law.scale},
           {"closed", law.numbers[0]},
           {"low", low},
           {"high", high},
           {"middle", std::log(low * high) / 2},
           {"half", std::log(high / low) / 2}},
          {{"wrap", c}, {"rise", derivative(c)}}};
}

template <class Real>
std::pair<Real, Real> pin_moment(const PinLoadLaw& law, Real load, Real f) {
  using std::log;
  using std::sqrt;
  const Constants constants = pin_constants(law);
  const auto number = [&](const char* name) {
    return static_cast<Real>(constants.numbers.find(name)->second);
  };
  const Real radius = number("radius");
  const Real scale = number("scale");
  const auto wrap = [&](Real x) {
    return horner(constants.polynomials.find("wrap")->second, x);
  };
  const auto rise = [&](Real x) {
    return horner(constants.polynomials.find("rise")->second, x);
  };
  switch (law.form) {
    case PinLoadLaw::Form::clearance: {
      CLEARANCE
      return {moment, slope};
    }
    case PinLoadLaw::Form::interference: {
      const Real closed = number("closed");
      INTERFERENCE
      return {moment, slope};
    }
    case PinLoadLaw::Form::adhesion:
      break;
  }
  const Real low = number("low");
  const Real high = number("high");
  const Real middle = number("middle");
  const Real half = number("half");
  ADHESION
  return {moment, slope};
}
template std::pair<double, double> pin_moment(const PinLoadLaw&, double,
                                              double);
template std::pair<float, float> pin_moment(const PinLoadLaw&, float, float);

}  // namespace contact::detail
