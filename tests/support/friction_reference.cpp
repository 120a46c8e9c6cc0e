#include "support/friction_reference.hpp"

#include <algorithm>

#include "libcontact/base/units.hpp"
#include "support/accuracy_report.hpp"
#include "support/reference_table.hpp"

namespace contact::test {

const std::vector<FrictionReference>& friction_reference() {
  static const std::vector<FrictionReference> rows = [] {
    const ReferenceTable table("friction_integrals.csv");
    std::vector<FrictionReference> result;
    for (const ReferenceTable::Row row : table) {
      const double theta0_deg = row.value("theta0_deg");
      const double alpha_deg = row.value("alpha_deg");
      result.push_back(
          {theta0_deg,
           alpha_deg,
           theta0_deg * degree,
           SlipAxis::from_degrees(alpha_deg),
           {row.value("I_normal"),
            {row.value("I_p"), row.value("J_p"), row.value("K_p")},
            {row.value("I_a"), row.value("J_a"), row.value("K_a")},
            {row.value("chi"), row.value("sigma_Y"), row.value("sigma_Z")}},
           row.label()});
    }
    return result;
  }();
  return rows;
}

void add_triple(AccuracyReport& report, const FrictionTriple& computed,
                const FrictionTriple& expected, const std::string& label) {
  report.add(computed.force, expected.force, label + ", force");
  report.add(computed.sliding, expected.sliding, label + ", sliding");
  report.add(computed.spinning, expected.spinning, label + ", spinning");
}

const std::vector<FrictionQuantity>& friction_quantities() {
  using F = FrictionIntegrals;
  static const std::vector<FrictionQuantity> quantities = {
      {"I_normal", [](const F& f) { return f.normal; }},
      {"I_p", [](const F& f) { return f.pressure.force; }},
      {"J_p", [](const F& f) { return f.pressure.sliding; }},
      {"K_p", [](const F& f) { return f.pressure.spinning; }},
      {"I_a", [](const F& f) { return f.area.force; }},
      {"J_a", [](const F& f) { return f.area.sliding; }},
      {"K_a", [](const F& f) { return f.area.spinning; }},
      {"chi", [](const F& f) { return f.coefficient.force; }},
      {"sigma_Y", [](const F& f) { return f.coefficient.sliding; }},
      {"sigma_Z", [](const F& f) { return f.coefficient.spinning; }}};
  return quantities;
}

void add_integrals(AccuracyReport& report, const FrictionIntegrals& computed,
                   const FrictionIntegrals& expected,
                   const std::string& label) {
  for (const FrictionQuantity& quantity : friction_quantities()) {
    report.add(quantity.of(computed), quantity.of(expected),
               label + ", " + quantity.column);
  }
}

double check_friction_accuracy(const FrictionMethod& method, double budget,
                               const FrictionFilter& filter) {
  std::vector<AccuracyReport> reports;
  for (const FrictionQuantity& quantity : friction_quantities()) {
    reports.emplace_back(quantity.column, budget);
  }
  for (const FrictionReference& row : friction_reference()) {
    if (!filter(row)) continue;
    const FrictionIntegrals result = method(row.half_angle, row.axis);
    for (std::size_t i = 0; i < reports.size(); ++i) {
      const auto of = friction_quantities()[i].of;
      reports[i].add(of(result), of(row.expected), row.label);
    }
  }
  double largest = 0;
  for (const AccuracyReport& report : reports) {
    largest = std::max(largest, report.max());
  }
  return largest;
}

}  // namespace contact::test
