#include "programs/angle/compare.hpp"

#include <algorithm>
#include <cmath>
#include <string_view>

#include "cli/output.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/report.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/half_angle/factory.hpp"
#include "libcontact/half_angle/registry.hpp"

namespace hinge_angle {
namespace {

using contact::detail::infinity;
using contact::detail::nan;

int cost_of(std::string_view name, contact::JointKind kind) {
  const auto* const law = contact::detail::find_half_angle_entry(name);
  if (law == nullptr) return 0;
  return kind == contact::JointKind::ball ? law->ball_cost : law->pin_cost;
}

// Loads in equal ratios from the smallest to the largest of the input, as
// load parameters.
std::vector<double> load_parameters(const Loads& scale, const Input& input) {
  double low = infinity;
  double high = 0;
  for (std::size_t i = 0; i < input.values.size(); ++i) {
    low = std::min(low, input.values[i]);
    high = std::max(high, input.values[i]);
  }
  low = scale.convert(input.variable, low, LoadVariable::load_parameter);
  high = scale.convert(input.variable, high, LoadVariable::load_parameter);
  std::vector<double> loads = {low, high};
  // At 0 all laws are 0; below 1e-9 they are Hertz's.
  const double first = std::max(low, 1e-9);
  const double last = std::min(high, 1e12);
  constexpr int steps = 400;
  for (int i = 0; i <= steps && first < last; ++i) {
    loads.push_back(first * std::pow(last / first, i / double{steps}));
  }
  return loads;
}

LawComparison compare_law(const NamedLaw& law,
                          const contact::HalfAngleLaw& exact,
                          const std::vector<double>& loads) {
  LawComparison worst{law.name, 0,   loads[0],
                      nan,      nan, cost_of(law.name, exact.joint_kind()),
                      false};
  double largest = -1;
  for (const double load : loads) {
    const contact::HalfAngleResult reference = exact.half_angle(load);
    // Beyond the range of the exact solution there is no reference.
    if (reference.status != contact::Status::ok || reference.half_angle == 0) {
      continue;
    }
    const double half_angle = law.law->half_angle(load).half_angle;
    const double error =
        std::isnan(half_angle)
            ? infinity
            : 100 * std::abs(half_angle / reference.half_angle - 1);
    const bool first_gap =
        std::isinf(error) && std::isinf(largest) && load < worst.load_parameter;
    if (error > largest || first_gap) {
      largest = error;
      worst.error_percent = error;
      worst.load_parameter = load;
      worst.exact = reference.half_angle;
      worst.half_angle = half_angle;
    }
  }
  if (largest < 0) worst.error_percent = nan;
  return worst;
}

}  // namespace

std::vector<LawComparison> compare(const Input& input, const cli::Joint& joint,
                                   double tolerance_percent) {
  const auto exact =
      contact::make_half_angle_law("exact", joint.kind(), joint.pair);
  const std::vector<double> loads = load_parameters(Loads(joint), input);
  std::vector<LawComparison> result;
  for (const NamedLaw& law : joint.laws) {
    result.push_back(compare_law(law, *exact, loads));
  }
  if (std::all_of(result.begin(), result.end(), [](const auto& law) {
        return std::isnan(law.error_percent);
      })) {
    cli::refuse_without("--compare",
                        "a load above 0 and within the exact solution");
  }
  const auto best = std::min_element(
      result.begin(), result.end(),
      [&](const LawComparison& a, const LawComparison& b) {
        const auto rank = [&](const LawComparison& law) {
          return law.error_percent <= tolerance_percent ? law.cost : infinity;
        };
        return rank(a) < rank(b);
      });
  if (best != result.end() && best->error_percent <= tolerance_percent) {
    best->recommended = true;
  }
  return result;
}

void write_comparison(const std::vector<LawComparison>& laws,
                      const cli::Joint& joint,
                      const cli::OutputOptions& options) {
  const Loads loads(joint);
  std::vector<std::string> columns = {"law", "error_percent"};
  if (joint.has_size) columns.push_back(loads.column());
  for (const char* name : {"load_parameter", "theta0_exact_deg",
                           "theta0_law_deg", "cost_tanh", "recommended"}) {
    columns.emplace_back(name);
  }
  cli::write_table(options, columns, [&](cli::RowWriter& row) {
    for (const LawComparison& law : laws) {
      row.text(law.name);
      row.number(law.error_percent);
      if (joint.has_size) {
        row.number(loads.convert(LoadVariable::load_parameter,
                                 law.load_parameter, LoadVariable::load));
      }
      row.number(law.load_parameter);
      row.number(law.exact / contact::degree);
      row.number(law.half_angle / contact::degree);
      row.number(law.cost);
      if (law.recommended) {
        row.text("yes");
      } else {
        row.empty();
      }
      row.end();
    }
  });
}

}  // namespace hinge_angle
