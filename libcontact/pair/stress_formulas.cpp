// Friction stresses by a formula: Stribeck's and a power of the pressure.
#include <cmath>
#include <string>

#include "libcontact/base/check.hpp"
#include "libcontact/pair/stress_registry.hpp"

namespace contact {
namespace detail {
namespace {

constexpr StressNumber stribeck_numbers[] = {
    {"static_coefficient"},
    {"dynamic_coefficient"},
    {.key = "stribeck_velocity", .unit = "m_per_s", .is_above_zero = true}};
constexpr StressNumber power_numbers[] = {
    {"coefficient"},
    {.key = "reference_pressure", .unit = "Pa", .is_above_zero = true},
    {.key = "exponent", .largest = 1}};

}  // namespace

extern constexpr StressEntry stribeck_stress = {
    .name = "stribeck",
    .meaning = "p (fc + (fs - fc) exp(-v/vs))",
    .numbers = stribeck_numbers,
    .make = [](std::span<const double> numbers, const FrictionStress::Table&) {
      return FrictionStress::stribeck(numbers[0], numbers[1], numbers[2]);
    }};

extern constexpr StressEntry power_stress = {
    .name = "power",
    .meaning = "f p (p/p_r)^-m",
    .numbers = power_numbers,
    .make = [](std::span<const double> numbers, const FrictionStress::Table&) {
      return FrictionStress::power(numbers[0], numbers[1], numbers[2]);
    }};

}  // namespace detail

namespace {

using detail::is_above_zero;
using detail::is_not_negative;
using detail::require;

}  // namespace

FrictionStress FrictionStress::stribeck(double static_coefficient,
                                        double dynamic_coefficient,
                                        double speed) {
  const char* const place = "stribeck friction";
  require(is_not_negative(static_coefficient), place, "static_coefficient",
          static_coefficient, "0 or above and finite");
  require(is_not_negative(dynamic_coefficient), place, "dynamic_coefficient",
          dynamic_coefficient, "0 or above and finite");
  require(is_above_zero(speed), place, "speed", speed,
          "above 0 m/s and finite");
  const double more = static_coefficient - dynamic_coefficient;
  FrictionStress made(
      [=](double p, double v) {
        return p * (dynamic_coefficient + more * std::exp(-v / speed));
      },
      more > 0   ? OverSpeed::falls
      : more < 0 ? OverSpeed::rises
                 : OverSpeed::constant);
  made.source_ = {.law = std::string(detail::stribeck_stress.name),
                  .numbers = {static_coefficient, dynamic_coefficient, speed}};
  made.speed_scale_ = speed;
  return made;
}

FrictionStress FrictionStress::power(double coefficient, double pressure,
                                     double exponent) {
  const char* const place = "power friction";
  require(is_not_negative(coefficient), place, "coefficient", coefficient,
          "0 or above and finite");
  require(is_above_zero(pressure), place, "pressure", pressure,
          "above 0 Pa and finite");
  require(exponent >= 0 && exponent <= 1, place, "exponent", exponent,
          "0 to 1");
  const double scale = coefficient * pressure;
  FrictionStress made(
      [=](double p, double) {
        return scale * std::pow(p / pressure, 1 - exponent);
      },
      OverSpeed::constant);
  made.source_ = {.law = std::string(detail::power_stress.name),
                  .numbers = {coefficient, pressure, exponent}};
  return made;
}

}  // namespace contact
