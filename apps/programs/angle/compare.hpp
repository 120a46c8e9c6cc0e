#pragma once

#include <string>
#include <vector>

#include "cli/joint/joint_options.hpp"
#include "cli/program.hpp"
#include "programs/angle/angle_table.hpp"
#include "programs/angle/input.hpp"

namespace hinge_angle {

/// Compares a half-angle law with the exact one over a range of loads.
struct LawComparison {
  std::string name;
  /// Largest |theta0/exact - 1| at the same load, percent; infinite if the law
  /// has no value somewhere.
  double error_percent;
  double load_parameter;  ///< mu or lambda at the largest error
  double exact;           ///< exact theta0 at this load parameter, rad
  double half_angle;      ///< theta0 of the law; NaN if it has none
  /// Approximate time for one half-angle, as a multiple of std::tanh.
  int cost;
  bool recommended;
};

/// Compares the laws between the smallest and the largest load of the input, at
/// 400 loads in equal ratios including both ends. Recommends the cheapest law
/// within the tolerance, or exact if there is none.
std::vector<LawComparison> compare(const Input& input, const cli::Joint& joint,
                                   double tolerance_percent);

/// Writes the comparison as a table: law, error_percent, load_N or load_N_per_m
/// (if the joint has a geometry), load_parameter, theta0_exact_deg,
/// theta0_law_deg, cost_tanh, recommended (yes or empty).
void write_comparison(const std::vector<LawComparison>& laws,
                      const cli::Joint& joint,
                      const cli::OutputOptions& options);

}  // namespace hinge_angle
