#include <gtest/gtest.h>

#include <boost/math/special_functions/bessel.hpp>
#include <cmath>
#include <string>
#include <vector>

#include "libcontact/base/units.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/gap/ball_gap.hpp"
#include "libcontact/conforming/gap/odd_bessel.hpp"
#include "libcontact/conforming/gap/pin_gap.hpp"
#include "libcontact/conforming/kernel/pin_wall_modes.hpp"
#include "libcontact/conforming/pin.hpp"
#include "libcontact/conforming/pin_closed_form.hpp"
#include "libcontact/conforming/pin_integrals.hpp"
#include "libcontact/conforming/wall_harmonics.hpp"
#include "support/accuracy_report.hpp"
#include "support/numbers.hpp"
#include "support/reference_table.hpp"
#include "support/wall.hpp"

// The solutions by the gap, which interference uses: against reference rows,
// the closed form of identical materials and the solutions by the pressure.
namespace contact::test::gap_test {
namespace {

using detail::BallGap;
using detail::PinGap;
using detail::SignedContact;

template <class Gap>
void compare_with_rows(const std::string& file, JointKind kind) {
  const bool is_pin = kind == JointKind::pin;
  // 1e-9 is asked for; the angles of the file are rounded to 1e-12 rad.
  AccuracyReport inverse("x", 1e-9);
  AccuracyReport sum("S", 1e-9);
  AccuracyReport shift("shift", 1e-9);
  AccuracyReport stiffness("stiffness", 1e-9);
  AccuracyReport centre("p(0)", 1e-9);
  // Rows of pins below 115 deg were made by the pressure, whose p(0) has the
  // logarithm of the edge; how much it left is a column of theirs, 7e-9 at
  // most.
  AccuracyReport rough("p(0) over what its rows leave", 1);
  if (!is_pin) rough.may_be_empty();
  for (const ReferenceTable::Row row : ReferenceTable(file)) {
    const double opening = pi - row.value("theta0_deg") * degree;
    if (!(opening > 0 && opening <= pi - Gap::smallest_half_angle)) continue;
    const LayeredPair pair = test::reference_pair(row);
    const Gap gap(pair);
    const detail::GapField field = gap.field(opening);
    const SignedContact& c = field.contact;
    const double centre_pressure = gap.centre(field);
    const double rho = row.value("rho");
    const double load = row.value("load");
    const double p1 =
        is_pin ? load / (pi * rho) : load / (4 * pi / 3 * rho * rho);
    const double modulus = pair.surfaces().effective_modulus();
    const double k1 = 4 * rho / modulus * p1;
    inverse.add(c.inverse * (is_pin ? 1 : 2 / pi),
                row.value("inverse_parameter"), row.label());
    sum.add((1 - c.mean_deficit) * (is_pin ? 2 : 3), row.value("sum_p") / load,
            row.label());
    const double left = row.value("acc_p_centre");
    const double p0 = row.value("p_centre");
    if (left < 1e-9) {
      centre.add(centre_pressure * p1, p0, row.label());
    } else {
      rough.add_error(std::abs(centre_pressure * p1 / p0 - 1) / left,
                      row.label());
    }
    if (row.text("shift").empty()) {
      EXPECT_TRUE(std::isnan(gap.first_compliance())) << row.label();
      continue;
    }
    const double c1 = gap.first_compliance();
    shift.add((c1 + c.gap_shift) * k1, row.value("shift"), row.label());
    const double unit = is_pin ? pi / 4 * modulus : pi / 3 * modulus * rho;
    stiffness.add(unit / (c1 + c.gap_compliance), row.value("stiffness"),
                  row.label());
  }
}

TEST(PinGap, IsThatOfTheReference) {
  compare_with_rows<PinGap>("preload/preload_pin.csv", JointKind::pin);
}

TEST(BallGap, IsThatOfTheReference) {
  compare_with_rows<BallGap>("preload/preload_ball.csv", JointKind::ball);
}

// Homogeneous pairs and walls.
std::vector<LayeredPair> pairs() {
  std::vector<LayeredPair> all;
  for (const double ratio : {0.0, 1.0, 20.0}) {
    all.push_back(detail::without_layers(
        ElasticPair::from_modulus_ratio(ratio, 0.3, 0.4)));
  }
  for (const test::Wall& wall :
       {test::Wall{1, 0.45, true}, {0.3, 0.4, false}, {0.1, 0.3, true}}) {
    all.push_back(wall.pair());
  }
  return all;
}

template <class Gap, class Contact>
void compare_with_pressure(JointKind kind, double centre_budget) {
  AccuracyReport inverse("x + c_0", 1e-9);
  AccuracyReport sum("p_0/p_1", 1e-9);
  AccuracyReport shift("shift", 1e-9);
  AccuracyReport compliance("compliance", 1e-9);
  AccuracyReport centre("p(0)", centre_budget);
  for (const LayeredPair& pair : pairs()) {
    const Gap gap(pair);
    const Contact contact(pair, InnerLoading::centre(), 32);
    for (const double theta0_deg : {101, 108, 115, 122}) {
      const double theta0 = theta0_deg * degree;
      const std::string label = to_string(kind) + " t " +
                                std::to_string(pair.relative_thickness()) +
                                ", theta0_deg " + std::to_string(theta0_deg);
      const detail::GapField field = gap.field(pi - theta0);
      const SignedContact& a = field.contact;
      const SignedContact b = contact.signed_contact(theta0);
      inverse.add(a.beyond_closure, b.beyond_closure, label);
      sum.add(1 - a.mean_deficit, 1 - b.mean_deficit, label);
      // P = pi rho p_1, R_n = (4 pi/3) rho^2 p_1
      const double unit = kind == JointKind::pin ? pi : 4 * pi / 3;
      centre.add(gap.centre(field), unit * contact.pressure(theta0).pressure(0),
                 label);
      const double c1 = gap.first_compliance();
      if (std::isnan(c1)) {
        EXPECT_TRUE(std::isnan(b.gap_shift)) << label;
        continue;
      }
      shift.add(c1 + a.gap_shift, c1 + b.gap_shift, label);
      compliance.add(c1 + a.gap_compliance, c1 + b.gap_compliance, label);
    }
  }
}

TEST(PinGap, MeetsThePressure) {
  // p(0) of the solution by the pressure has the logarithm of its edge.
  compare_with_pressure<PinGap, PinContact>(JointKind::pin, 1e-7);
}

TEST(BallGap, MeetsThePressure) {
  compare_with_pressure<BallGap, BallContact>(JointKind::ball, 1e-9);
}

// x = [2 - ln(1 + B) - 2 B^2]/(4 B (1 + B)), B = tan^2(theta0/2), at any
// half-angle; -1/2 at 180 deg. S and p of all pairs with beta = 0.
TEST(PinGap, IsTheClosedFormOfIdenticalMaterials) {
  AccuracyReport inverse("x + 1/2", 1e-9);
  AccuracyReport sum("S", 1e-9);
  AccuracyReport centre("p(0)", 1e-9);
  const PinGap gap(
      detail::without_layers(ElasticPair::from_modulus_ratio(1, 0.3, 0.3)));
  EXPECT_NEAR(gap.mean_compliance(), 0.5, 1e-15);
  for (const double opening : {1e-3, 0.01, 0.1, 0.5, 1.0, 1.3}) {
    const std::string label = "psi " + std::to_string(opening);
    const detail::GapField field = gap.field(opening);
    const SignedContact& c = field.contact;
    const double b = 1 / (std::tan(opening / 2) * std::tan(opening / 2));
    // x + 1/2 without cancellation.
    const double expected = (2 + 2 * b - std::log1p(b)) / (4 * b * (1 + b));
    inverse.add(c.beyond_closure, expected, label);
    sum.add(2 * (1 - c.mean_deficit), PinClosedForm::force_ratio(pi - opening),
            label);
    // P = pi rho p_1
    centre.add(gap.centre(field) / pi, PinClosedForm::pressure(0, pi - opening),
               label);
  }
}

// 0.15 of the harmonics leave 300 times as much, 5e-9; tables are good to 1e-7.
TEST(PinGap, OfTablesIsNearTheOther) {
  AccuracyReport inverse("x + c_0", 1e-8);
  AccuracyReport mean("p_0/p_1", 1e-8);
  AccuracyReport shift("shift, less c_1", 1e-8);
  AccuracyReport centre("p(0)", 1e-8);
  for (const LayeredPair& pair : pairs()) {
    const PinGap fine(pair);
    const PinGap coarse = PinGap::coarse(pair);
    for (const double opening : {1e-3, 0.03, 0.3, 0.8, 1.3}) {
      const std::string label = "t " +
                                std::to_string(pair.relative_thickness()) +
                                ", psi " + std::to_string(opening);
      const detail::GapField a = coarse.field(opening);
      const detail::GapField b = fine.field(opening);
      inverse.add(a.contact.beyond_closure, b.contact.beyond_closure, label);
      mean.add(1 - a.contact.mean_deficit, 1 - b.contact.mean_deficit, label);
      shift.add(a.contact.gap_shift, b.contact.gap_shift, label);
      centre.add(coarse.centre(a), fine.centre(b), label);
    }
  }
}

// Far fewer harmonics than radius/thickness, and the same numbers: against the
// sum over every stride below pi/psi (as HarmonicSamples takes it). Of products
// of harmonics, and of one and the edge's.
TEST(GradedSamples, GiveTheSum) {
  constexpr int end = 26000;
  for (const double psi : {0.1, 0.3, 0.8, 1.3}) {
    const detail::PinWallModes modes(psi, 64);
    const detail::HarmonicSamples plain(psi, end);
    const detail::GradedSamples graded(psi, end, modes.smooth_from());
    EXPECT_LT(graded.swinging.n.size() + 2 * graded.n.size(), 4000) << psi;
    // Ends like the c_n of a layer of 5e-4 radii.
    const Eigen::Index size = modes.transformation().rows();
    struct Sum {
      explicit Sum(Eigen::Index size)
          : products(Eigen::MatrixXd::Zero(size, size)),
            edge(Eigen::VectorXd::Zero(size)) {}
      Eigen::MatrixXd products;
      Eigen::VectorXd edge;
    };
    Sum expected(size);
    Sum sum(size);
    const auto adder = [](const auto& samples, const auto& average, Sum& to) {
      return [&](int first, const auto& g) {
        for (int i = 0; i < g.rows(); ++i) {
          const double n = samples.n[first + i];
          const double c = samples.weight[first + i] * std::exp(-1e-3 * n);
          to.products += c * g.row(i).transpose() * g.row(i);
          to.edge += c * n * average[static_cast<int>(n)] * g.row(i);
        }
      };
    };
    const auto average = detail::edge_averages(psi, end);
    const auto second = detail::second_edge_averages(psi, end);
    modes.visit(plain.n, adder(plain, average, expected));
    modes.visit(graded.swinging.n, adder(graded.swinging, average, sum));
    modes.visit(graded.n, adder(graded, average, sum));
    modes.visit_second_kind(graded.n, adder(graded, second, sum));
    const auto& t = modes.transformation();
    const Eigen::MatrixXd error =
        t.transpose() * (sum.products - expected.products) * t;
    EXPECT_LT(error.cwiseAbs().maxCoeff(), 1e-9) << psi;
    const Eigen::VectorXd edge = t.transpose() * (sum.edge - expected.edge);
    EXPECT_LT(edge.cwiseAbs().maxCoeff(), 1e-9) << psi;
  }
}

// psi^2 -> 4 (1 - P_l/P) (pin), 3 (1 - R_l/R) (ball): x + c_0 = c_0 psi^2 over
// 4 or 3; and p = p_1 (1 + cos t) there.
TEST(Gap, LiftsOffAsTheClosedContactEnds) {
  const double opening = 1e-3;
  for (const LayeredPair& pair : pairs()) {
    const PinGap pin(pair);
    const BallGap ball(pair);
    const double square = opening * opening;
    const SignedContact p = pin.solve(opening);
    const SignedContact b = ball.solve(opening);
    EXPECT_NEAR(p.beyond_closure / (pin.mean_compliance() * square), 1.0 / 4,
                1e-3);
    EXPECT_NEAR(b.beyond_closure / (ball.mean_compliance() * square), 1.0 / 3,
                1e-3);
    EXPECT_NEAR(p.mean_deficit / square, 1.0 / 4, 1e-3);
    EXPECT_NEAR(b.mean_deficit / square, 1.0 / 3, 1e-3);
    EXPECT_NEAR(pin.centre(pin.field(opening)), 2, 1e-5);
    EXPECT_NEAR(ball.centre(ball.field(opening)), 2, 1e-5);
  }
}

// Lame: a steel ball in infinite steel.
TEST(Gap, MeanComplianceIsLames) {
  const Material steel{2.1e11, 0.3};
  const ElasticPair pair(steel, steel);
  const double unit = pair.effective_modulus() / 4;
  EXPECT_NEAR(BallGap(detail::without_layers(pair)).mean_compliance(),
              unit * (1.3 / 2 + 0.4) / 2.1e11, 1e-15);
  EXPECT_NEAR(PinGap(detail::without_layers(pair)).mean_compliance(),
              unit * (1.3 + 1.3 * 0.4) / 2.1e11, 1e-15);
}

TEST(OddSphericalBessel, IsBoosts) {
  Eigen::VectorXd values(40);
  for (const double x :
       {0.0, 1e-9, 1e-4, 0.3, 3.14159, 17.0, 79.0, 81.0, 4e3}) {
    detail::odd_spherical_bessel(x, values);
    for (int j = 0; j < values.size(); ++j) {
      const auto order = static_cast<unsigned>(2 * j + 1);
      EXPECT_NEAR(values(j), boost::math::sph_bessel(order, x), 1e-14)
          << x << " " << order;
    }
  }
}

}  // namespace
}  // namespace contact::test::gap_test
