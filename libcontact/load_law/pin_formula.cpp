#include "libcontact/load_law/pin_formula.hpp"

#include <cmath>

namespace contact::detail {
namespace {

// wrap() is S, of interference (S - c0)/u^2, and rise() its derivative. NaN
// passes: it is not below anything.
// clang-format off
#define CLEARANCE                                               \
  bend = 1 / sqrt(1 + f * f);                                   \
  normal = load * bend;                                         \
  u = normal / (normal + scale);                                \
  ratio = wrap(u);                                              \
  moment = radius * f * normal * ratio;                         \
  slope = radius * f * bend * (ratio + u * (1 - u) * rise(u));
#define INTERFERENCE                                            \
  bend = 1 / sqrt(1 + f * f);                                   \
  push = load * bend;                                           \
  normal = push < scale ? scale : push;                         \
  u = sqrt(1 - scale / normal);                                 \
  x = 2 * u - 1;                                                \
  part = wrap(x);                                               \
  ratio = closed + u * u * part;                                \
  moment = radius * f * normal * ratio;                         \
  slope = ratio + (1 - u * u) * (part + u * rise(x));           \
  slope = push < scale ? 0 : radius * f * bend * slope;
#define ADHESION                                                \
  inside = load < low ? low : load;                             \
  inside = load > high ? high : inside;                         \
  t = (log(inside) - middle) / half;                            \
  arm = wrap(t);                                                \
  moment = load * arm;                                          \
  slope = load == inside ? arm + rise(t) / half : arm;
// clang-format on

using Form = PinLoadLaw::Form;

}  // namespace

std::string_view pin_formula(const PinLoadLaw& law) {
  return law.form == Form::clearance      ? CONTACT_TEXT_OF(CLEARANCE)
         : law.form == Form::interference ? CONTACT_TEXT_OF(INTERFERENCE)
                                          : CONTACT_TEXT_OF(ADHESION);
}

Constants pin_constants(const PinLoadLaw& law) {
  const auto [low, high] = law.loads;
  const int first = law.form == Form::interference ? 1 : 0;
  const std::vector<double> c(law.numbers.begin() + first, law.numbers.end());
  std::vector<double> rise;
  for (std::size_t i = 1; i < c.size(); ++i) rise.push_back(double(i) * c[i]);
  return {{{"radius", law.radius},
           {"scale", law.scale},
           {"closed", law.numbers[0]},
           {"low", low},
           {"high", high},
           {"middle", std::log(low * high) / 2},
           {"half", std::log(high / low) / 2}},
          {{"wrap", c}, {"rise", rise}}};
}

template <class Real>
std::pair<Real, Real> pin_moment(const PinLoadLaw& law, Real load, Real f) {
  using std::log, std::sqrt;
  const Constants constants = pin_constants(law);
  const auto number = [&](const char* name) {
    return static_cast<Real>(constants.numbers.at(name));
  };
  const auto polynomial = [&](const char* name, Real at) {
    const std::vector<double>& c = constants.polynomials.at(name);
    Real sum = 0;
    for (std::size_t i = c.size(); i-- > 0;) sum = sum * at + Real(c[i]);
    return sum;
  };
  const auto wrap = [&](Real at) { return polynomial("wrap", at); };
  const auto rise = [&](Real at) { return polynomial("rise", at); };
  const Real radius = number("radius"), scale = number("scale"),
             closed = number("closed"), low = number("low"),
             high = number("high"), middle = number("middle"),
             half = number("half");
  Real bend, push, normal, u, x, part, ratio, inside, t, arm, moment, slope;
  if (law.form == Form::clearance) {
    CLEARANCE
  } else if (law.form == Form::interference) {
    INTERFERENCE
  } else {
    ADHESION
  }
  return {moment, slope};
}
template std::pair<double, double> pin_moment(const PinLoadLaw&, double,
                                              double);
template std::pair<float, float> pin_moment(const PinLoadLaw&, float, float);

}  // namespace contact::detail
