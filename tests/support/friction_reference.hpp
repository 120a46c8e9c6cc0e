#pragma once

#include <functional>
#include <string>
#include <vector>

#include "libcontact/friction/integrals.hpp"
#include "support/accuracy_report.hpp"

namespace contact::test {

/// One row of data/reference/friction_integrals.csv as a method of the
/// library is given it: theta0_deg * degree, SlipAxis::from_degrees(a).
struct FrictionReference {
  double theta0_deg;
  double alpha_deg;
  double half_angle;
  SlipAxis axis;
  FrictionIntegrals expected;
  std::string label;
};

/// All rows of the file, read once.
const std::vector<FrictionReference>& friction_reference();

/// The ten quantities of FrictionIntegrals by their names in the file, with
/// a way to reach each.
struct FrictionQuantity {
  const char* column;
  double (*of)(const FrictionIntegrals&);
};
const std::vector<FrictionQuantity>& friction_quantities();

/// Force, sliding and spinning, each with its own relative error.
void add_triple(AccuracyReport& report, const FrictionTriple& computed,
                const FrictionTriple& expected, const std::string& label);

/// All ten quantities, each with its own relative error.
void add_integrals(AccuracyReport& report, const FrictionIntegrals& computed,
                   const FrictionIntegrals& expected, const std::string& label);

using FrictionMethod =
    std::function<FrictionIntegrals(double half_angle, SlipAxis axis)>;
using FrictionFilter = std::function<bool(const FrictionReference&)>;

/// Runs a method over the reference rows that pass the filter, prints one
/// line per quantity and fails the test where the largest relative error is
/// over the budget. Returns the largest error of all quantities.
double check_friction_accuracy(
    const FrictionMethod& method, double budget,
    const FrictionFilter& filter = [](const FrictionReference&) {
      return true;
    });

}  // namespace contact::test
