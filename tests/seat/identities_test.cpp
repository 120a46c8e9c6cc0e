#include <gtest/gtest.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <random>
#include <string>
#include <tuple>

#include "libcontact/base/units.hpp"
#include "libcontact/files/joint_file.hpp"
#include "libcontact/seat/contact.hpp"
#include "libcontact/seat/patch.hpp"
#include "libcontact/seat/windows.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"

// Identities of every seat that ends, and refusals.
namespace contact::test::identities_test {
namespace {

const Material steel{2.1e11, 0.3};
const Material bronze{1.1e11, 0.34};

JointSpec bearing(double clearance = 2.5e-5) {
  return {.geometry = JointGeometry::ball(0.025, clearance),
          .inner = steel,
          .outer = bronze};
}

Eigen::Vector3d towards(double polar_deg, double azimuth_deg, double load) {
  const double v = polar_deg * degree, phi = azimuth_deg * degree;
  return load * Eigen::Vector3d(std::sin(v) * std::cos(phi),
                                std::sin(v) * std::sin(phi), std::cos(v));
}

SeatZone cup(double degrees) { return SeatZone::cup(degrees * degree); }

TEST(Seat, RefusesWhatItHasNoCellsFor) {
  const SeatZone zone = cup(60);
  const auto message = [&](const JointSpec& joint, SeatContact::Grid grid) {
    return error_message([&] { SeatContact(joint, zone, grid); });
  };
  JointSpec lined = bearing();
  lined.outer = {{{2.4e-5, {1e9, 0.4}}}, Backing::medium(steel)};
  EXPECT_TRUE(has_text(message(lined, {}), "must be at least 0.001 radii"));
  JointSpec back = bearing();
  back.loading = InnerLoading::back(20 * degree);
  EXPECT_TRUE(has_text(message(back, {}), "requires loading = centre"));
  const JointSpec pin{.geometry = JointGeometry::pin(0.01, 1e-5, 0.02),
                      .inner = steel,
                      .outer = steel};
  EXPECT_TRUE(has_text(message(pin, {}), "requires a ball"));
  EXPECT_TRUE(has_text(message(bearing(), {.cells = 7}), "must be 8 to 200"));
  EXPECT_TRUE(has_text(message(bearing(), {.longitudes = 1000}), "16 to 720"));
}

TEST(Seat, SaysWhatItCannotCarry) {
  const SeatContact seat(bearing(), cup(60), {.cells = 12, .longitudes = 30});
  const SeatState out = seat.under(towards(60.1, 0, 1e4));
  EXPECT_EQ(out.status, SeatStatus::out_of_seat);
  EXPECT_TRUE(std::isnan(out.shift.x()) && std::isnan(out.peak_pressure));
  EXPECT_TRUE(seat.stiffness(out).array().isNaN().all());
  EXPECT_TRUE(has_text(seat.note(out),
                       "points 60.1 deg from the seat's axis, and the seat "
                       "carries loads below 60 deg only"));
  // The contact shrinks onto the rim as the load nears the cone's edge.
  double before = 0;
  for (const double v : {50.0, 56.0, 59.0}) {
    const SeatState state = seat.under(towards(v, 0, 1e4));
    EXPECT_EQ(state.status, SeatStatus::ok) << v;
    EXPECT_GT(state.shift.norm(), before);
    before = state.shift.norm();
  }
  EXPECT_EQ(seat.under(Eigen::Vector3d::Zero()).status, SeatStatus::no_load);
  EXPECT_EQ(seat.under(towards(10, 0, NAN)).status, SeatStatus::no_load);
}

// The pressures at places integrate to the load, at rims and elsewhere, and
// agree with the reported values.
TEST(Seat, PressuresAddUpToTheLoad) {
  const SeatContact seat(bearing(), cup(60));
  for (const Eigen::Vector3d& load :
       {towards(25, 40, 1e5), towards(5, 0, 2e4)}) {
    const SeatState state = seat.under(load);
    ASSERT_EQ(state.is_free, load.norm() < 5e4);
    Eigen::Vector3d sum = Eigen::Vector3d::Zero();
    double area = 0;
    constexpr int longitudes = 361, latitudes = 400;
    for (int i = 0; i < latitudes; ++i) {
      // Dense towards the rim, where p is singular.
      const double x = (i + 0.5) / latitudes;
      const double v = 60 * degree * (1 - x * x);
      const double width = 60 * degree * 2 * x / latitudes;
      for (int j = 0; j < longitudes; ++j) {
        const double phi = 2 * pi * (j + 0.3) / longitudes;
        const Eigen::Vector3d r(std::sin(v) * std::cos(phi),
                                std::sin(v) * std::sin(phi), std::cos(v));
        const double cell =
            0.025 * 0.025 * std::sin(v) * width * 2 * pi / longitudes;
        const double p = seat.pressure(state, seat_place(load, r));
        sum += cell * p * r;
        area += p > 0 ? cell : 0;
      }
    }
    EXPECT_LT((sum - load).norm() / load.norm(), 1e-3);
    EXPECT_NEAR(area / state.area, 1, 0.02);
    EXPECT_NEAR(
        seat.pressure(state, seat_place(load, load)) / state.pressure_at_load,
        1, 1e-12);
    EXPECT_EQ(seat.pressure(state, seat_place(load, -load)), 0);
    EXPECT_TRUE(std::isnan(seat.pressure(state, SeatPlace{})));
  }
  EXPECT_TRUE(
      std::isnan(seat.pressure(seat.under(towards(80, 0, 1e4)), {0, 0})));
}

JointSpec shipped(const std::string& name) {
  return read_joint(CONTACT_DATA_DIR "/joints/" + name + ".toml");
}

// A parabola goes on below 0 where the contact ends; it ran to -14 % of the
// peak beside the pole, and to minus infinity at rims.
TEST(Seat, PressuresAreNeverBelowZero) {
  const struct {
    const char* joint;
    double load, direction;
  } cases[] = {{"hip_cup", 5000, 43},
               {"hip_cup", 1000, 66},
               {"hip_cup", 5000, 89},
               {"ball_stud", 3000, 90},
               {"spherical_plain_bearing_ge50", 1e5, 60}};
  for (const auto& [name, load, direction] : cases) {
    const JointSpec spec = shipped(name);
    const SeatZone zone = *spec.geometry.seat();
    const SeatContact seat(spec, zone);
    const SeatState state = seat.under(towards(direction, 0, load));
    ASSERT_EQ(state.status, SeatStatus::ok) << name;
    const auto p = [&](double v, double longitude_deg) {
      return seat.pressure(state, {v, longitude_deg * degree});
    };
    constexpr int parts = 360;
    double least = 0;
    for (int i = 0; i <= parts; ++i) {
      const double v =
          i == parts ? zone.to() : zone.from() + zone.width() * i / parts;
      for (int k = 0; k <= 180; ++k) {
        const double here = p(v, k);
        ASSERT_FALSE(std::isnan(here)) << name << " " << v << " " << k;
        least = std::min(least, here);
      }
    }
    EXPECT_EQ(least, 0) << name;
    // At the rims themselves, and beyond, where the model has no seat.
    for (const int rim : {0, 1}) {
      const bool is_there =
          rim == 0 ? zone.has_lower_rim() : zone.has_upper_rim();
      if (!is_there) continue;
      const double at = rim == 0 ? zone.from() : zone.to();
      const double arc = state.rims[rim].half_arc / degree;
      for (double k = 0; k <= 180; k += 3) {
        if (std::abs(k - arc) < 4) continue;  // two longitudes
        EXPECT_EQ(p(at, k), k < arc ? INFINITY : 0) << name << " " << k;
      }
      for (const double beyond : {1e-9, 1e-3, 0.05}) {
        EXPECT_EQ(p(at + (rim == 0 ? -beyond : beyond), 0), 0) << name;
      }
    }
  }
}

// Against a grid twice as fine, at places drawn at random.
TEST(Seat, PressuresAreThoseOfAFinerGrid) {
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  for (const auto& [name, load, direction] :
       {std::tuple{"hip_cup", 5000.0, 66.0}, {"ball_stud", 3000.0, 160.0}}) {
    const JointSpec spec = shipped(name);
    const SeatZone zone = *spec.geometry.seat();
    const SeatContact seat(spec, zone);
    const SeatContact fine(spec, zone, {.cells = 56, .longitudes = 180});
    const Eigen::Vector3d force = towards(direction, 0, load);
    const SeatState state = seat.under(force), finer = fine.under(force);
    const double cell = zone.width() / 28;
    const auto is_inside = [&](double v, double longitude) {
      for (int k = 0; k < 8; ++k) {
        const double up = 2 * cell * std::cos(k * pi / 4);
        const double across = 2 * cell * std::sin(k * pi / 4) / std::sin(v);
        if (v + up < zone.from() || v + up > zone.to()) return false;
        if (!(fine.pressure(finer, {v + up, longitude + across}) > 0)) {
          return false;
        }
      }
      return true;
    };
    double squares = 0, largest = 0;
    int count = 0;
    for (int i = 0; i < 4000; ++i) {
      const double v = zone.from() + zone.width() * uniform(random);
      const double longitude = pi * uniform(random);
      const double error = std::abs(seat.pressure(state, {v, longitude}) -
                                    fine.pressure(finer, {v, longitude})) /
                           finer.peak_pressure;
      if (!is_inside(v, longitude)) continue;
      ++count;
      squares += error * error;
      largest = std::max(largest, error);
    }
    ASSERT_GT(count, 100) << name;
    EXPECT_LT(std::sqrt(squares / count), 3e-3) << name;
    EXPECT_LT(largest, 2e-2) << name;
  }
}

TEST(Seat, MakesItsGridsWhenTheyAreAskedFor) {
  const LayeredPair pair(0.025, steel, bronze);
  const detail::SeatWindows windows(pair, cup(60), 12, 30, 2.5e-5);
  EXPECT_EQ(windows.grids(), 0u);
  detail::SeatSolution solution;
  EXPECT_TRUE(windows.balance({4e4, 8e4}, solution));
  EXPECT_GE(windows.grids(), 1u);
}

void expect_no_numbers(const SeatState& state) {
  for (const double number :
       {state.shift.x(), state.pressure_at_load, state.peak_pressure,
        state.lower_end, state.upper_end, state.half_width, state.force_ratio,
        state.area, state.gap(), state.intensity(), state.rim_pressure(),
        state.rims[0].half_arc, state.rims[1].half_arc, state.rims[0].distance,
        state.rims[1].distance}) {
    EXPECT_TRUE(std::isnan(number));
  }
  EXPECT_FALSE(state.solution);
}

// A load next to the last that a cup carries had a shift of kilometres.
TEST(Seat, WhatIsNotFoundHasNoNumbers) {
  const JointSpec spec = shipped("hip_cup");
  const SeatContact seat(spec, *spec.geometry.seat());
  const SeatState state = seat.under(towards(89.99, 0, 2000));
  EXPECT_EQ(state.status, SeatStatus::not_converged);
  expect_no_numbers(state);
  expect_no_numbers(seat.under(towards(91, 0, 2000)));
  expect_no_numbers(seat.under({0, 0, 0}));
  EXPECT_TRUE(std::isnan(seat.pressure(state, {1, 0})));
}

// A contact that lies nearer to its rim than peaks are reported has none: the
// ring's under 100 N was 0, or a quarter of the mean.
TEST(Seat, PeaksAreAboveTheMeanOrThereIsNone) {
  const JointSpec spec = shipped("spherical_plain_bearing_ge50");
  const SeatContact seat(spec, *spec.geometry.seat());
  for (const double direction : {20.0, 60.0}) {
    const SeatState state = seat.under(towards(direction, 0, 100));
    ASSERT_EQ(state.status, SeatStatus::ok);
    EXPECT_TRUE(std::isnan(state.peak_pressure)) << direction;
    EXPECT_TRUE(std::isnan(state.peak_place.polar_angle));
    EXPECT_GT(state.intensity(), 0);
    EXPECT_TRUE(
        has_text(seat.notes(state).at(0),
                 "no largest pressure: at the reported distance of 0.66 mm"));
    const ContactPv pv = seat.pv(state, {0.2, 0.1, 0.3});
    EXPECT_GT(pv.total, 0);
    EXPECT_TRUE(std::isnan(pv.largest));
    EXPECT_TRUE(std::isnan(pv.place.x()));
  }
  const SeatContact coarse(spec, *spec.geometry.seat(),
                           {.cells = 14, .longitudes = 48});
  std::mt19937_64 random(1);
  std::uniform_real_distribution<double> uniform(0, 1);
  int there = 0;
  for (int i = 0; i < 24; ++i) {
    const double load = 100 * std::pow(1e4, uniform(random));
    const SeatState state =
        coarse.under(towards(90 * uniform(random), 0, load));
    ASSERT_EQ(state.status, SeatStatus::ok);
    EXPECT_FALSE(state.peak_pressure < state.mean_pressure());
    there += state.peak_pressure > 0 ? 1 : 0;
  }
  EXPECT_GT(there, 12);
}

// To the last bit.
TEST(Seat, FreeContactIsTheExactLaw) {
  const SeatContact seat(bearing(), cup(60));
  const JointContact& exact = seat.unbounded();
  const double load = 2e4;
  const double theta0 = exact.half_angle(load).half_angle;
  const SeatState state = seat.under(towards(0, 0, load));
  EXPECT_TRUE(state.is_free);
  EXPECT_EQ(state.shift.z(), exact.shift(load, theta0));
  EXPECT_EQ(state.peak_pressure, exact.peak_pressure(load, theta0));
  EXPECT_EQ(state.pressure_at_load, exact.pressure(0, load, theta0));
  EXPECT_EQ(state.area, exact.area(theta0));
  EXPECT_EQ(state.force_ratio, exact.sum_of_pressures(load, theta0) / load);
  EXPECT_EQ(state.upper_end, theta0);
  EXPECT_EQ(state.rims[1].distance, 60 * degree - theta0);
  EXPECT_EQ(seat.stiffness(state)(2, 2), exact.approach(theta0).stiffness);
}

// The shift is continuous where the contact reaches the rim: within the grid's
// 1e-4.
TEST(Seat, ReachesTheRimWithoutAJump) {
  const SeatContact seat(bearing(), cup(60));
  const double load = 2e4;
  const double theta0 = seat.unbounded().half_angle(load).half_angle / degree;
  const SeatState in = seat.under(towards(60 - theta0 - 1e-6, 0, load));
  const SeatState at = seat.under(towards(60 - theta0 + 1e-6, 0, load));
  EXPECT_TRUE(in.is_free);
  EXPECT_FALSE(at.is_free);
  EXPECT_LT((in.shift - at.shift).norm() / in.shift.norm(), 1e-4);
  EXPECT_NEAR(at.peak_pressure / in.peak_pressure, 1, 2e-3);
  EXPECT_NEAR(at.force_ratio, in.force_ratio, 2e-4);
}

// A turn about the seat's axis turns everything; so does a mirror.
TEST(Seat, TurnsWithTheLoad) {
  const SeatContact::Grid grid{.cells = 20, .longitudes = 60};
  const SeatContact ring(bearing(), {70 * degree, 120 * degree}, grid);
  const SeatContact mirrored(bearing(), {60 * degree, 110 * degree}, grid);
  const SeatState state = ring.under(towards(80, 0, 1e5));
  const SeatState turned = ring.under(towards(80, 130, 1e5));
  const SeatState other = mirrored.under(towards(100, 0, 1e5));
  ASSERT_EQ(state.status, SeatStatus::ok);
  const auto turn = Eigen::AngleAxisd(130 * degree, Eigen::Vector3d::UnitZ())
                        .toRotationMatrix();
  const double size = state.shift.norm();
  // Rounding, and where Newton stops.
  EXPECT_LT((turn * state.shift - turned.shift).norm() / size, 1e-7);
  EXPECT_LT(
      (turn * ring.stiffness(state) * turn.transpose() - ring.stiffness(turned))
              .norm() /
          ring.stiffness(state).norm(),
      1e-6);
  EXPECT_NEAR(other.shift.x() / state.shift.x(), 1, 1e-7);
  EXPECT_NEAR(-other.shift.z() / state.shift.z(), 1, 1e-7);
  EXPECT_NEAR(other.rims[1].intensity / state.rims[0].intensity, 1, 1e-6);
}

TEST(Seat, WarmStartsGiveTheSame) {
  const SeatContact seat(bearing(), cup(60), {.cells = 20, .longitudes = 60});
  const SeatState near = seat.under(towards(30, 0, 8e4));
  const SeatState cold = seat.under(towards(36, 20, 9e4));
  const SeatState warm = seat.under(towards(36, 20, 9e4), near);
  ASSERT_EQ(warm.status, SeatStatus::ok);
  // Sets that differ by a cell whose pressure is nearly 0.
  EXPECT_LT((warm.shift - cold.shift).norm() / cold.shift.norm(), 1e-6);
}

// The energy U = (D.F - eps Q)/2 has the gradient F, and F and Q are of first
// degree in D and eps: K D = F + eps dQ/dD.
TEST(Seat, HasAPotential) {
  const LayeredPair pair(0.025, steel, bronze);
  const double eps = 2.5e-5;
  const auto solver = [&](double clearance) {
    return detail::SeatPatchSolver(pair, detail::SeatWindow(cup(60)), 24, 60,
                                   clearance);
  };
  const detail::SeatPatchSolver seat = solver(eps);
  const auto at = [](const detail::SeatPatchSolver& of, Eigen::Vector2d shift) {
    detail::SeatPatch patch;
    of.solve(shift, patch);
    EXPECT_TRUE(patch.converged);
    return patch;
  };
  const Eigen::Vector2d shift(3e-5, 4e-5);
  const double h = 0.1 * seat.overlap(shift);
  const detail::SeatPatch middle = at(seat, shift);
  const auto energy = [&](const detail::SeatPatch& p) {
    return (p.shift.dot(p.force) - eps * p.sum) / 2;
  };
  Eigen::Matrix2d k;
  Eigen::Vector2d gradient, sums;
  for (const int axis : {0, 1}) {
    const Eigen::Vector2d step = h * Eigen::Vector2d::Unit(axis);
    const auto difference = [&](const auto& quantity) {
      return ((8 * (quantity(at(seat, shift + step)) -
                    quantity(at(seat, shift - step))) -
               (quantity(at(seat, shift + 2 * step)) -
                quantity(at(seat, shift - 2 * step)))) /
              (12 * h));
    };
    gradient(axis) = difference(energy);
    sums(axis) = difference([](const auto& p) { return p.sum; });
    k(0, axis) = difference([](const auto& p) { return p.force.x(); });
    k(1, axis) = difference([](const auto& p) { return p.force.y(); });
  }
  const double size = middle.force.norm();
  // The set in contact changes by whole cells: 1e-3 in second derivatives, the
  // step times that in first ones.
  EXPECT_LT((gradient - middle.force).norm() / size, 1e-4);
  EXPECT_LT((k * shift - middle.force - eps * sums).norm() / size, 2e-3);
  EXPECT_LT(std::abs(k(0, 1) - k(1, 0)) / k.norm(), 1e-3);
  const detail::SeatPatch twice = at(solver(2 * eps), 2 * shift);
  EXPECT_LT((twice.force - 2 * middle.force).norm() / size, 1e-8);
}

// No clearance and interference: no jump either.
TEST(Seat, AnyClearance) {
  const SeatContact::Grid grid{.cells = 20, .longitudes = 60};
  const Eigen::Vector3d force = towards(30, 0, 2e5);
  double sums[3];
  int i = 0;
  for (const double clearance : {1e-9, 0.0, -1e-9}) {
    const SeatContact seat(bearing(clearance), cup(60), grid);
    const SeatState state = seat.under(force);
    EXPECT_EQ(state.status, SeatStatus::ok) << clearance;
    sums[i++] = state.force_ratio;
  }
  // eps over the shift, 2e-5.
  EXPECT_NEAR(sums[0] / sums[1], 1, 2e-4);
  EXPECT_NEAR(sums[2] / sums[1], 1, 2e-4);
}

// The pressure on a rounding by its closed form, whose largest value and place
// the two numbers are (0.70 d inside the edge).
TEST(Seat, RoundedRimIsThePunchsShape) {
  const SeatContact seat(bearing(), cup(60), {.cells = 8, .longitudes = 16});
  const double intensity = 2e7, radius = 1e-3;
  const RoundedRim rim = seat.rounded_rim(intensity, radius);
  const double modulus = seat.unbounded().pair().contact_modulus();
  const double d = rim.reach;
  double largest = 0, place = 0;
  for (double y = d / 1000; y < 2 * d; y += d / 1000) {
    if (std::abs(y - d) < 1e-9 * d) continue;
    const double root = std::sqrt(d), other = std::sqrt(y);
    const double p =
        modulus / (2 * pi * radius) *
        (2 * std::sqrt(d * y) +
         (d - y) * std::log(std::abs((root + other) / (root - other))));
    if (p > largest) largest = p, place = y / d;
  }
  EXPECT_NEAR(largest / rim.peak_pressure, 1, 2e-3);  // to three digits
  EXPECT_NEAR(place, 0.70, 0.01);
}

// States and tables have it of their own K, and notes say where it ends.
TEST(Seat, RimsThatAreRoundedHaveAPeak) {
  const SeatContact::Grid grid = {.cells = 16, .longitudes = 32};
  JointSpec lined = bearing();
  lined.outer = {{{5e-4, {3e9, 0.4}}}, Backing::medium(steel)};
  const SeatContact sharp(bearing(), cup(60), grid);
  const SeatContact fine(bearing(), cup(60).with_edge({1e-4}), grid);
  const SeatContact coarse(lined, cup(60).with_edge({1e-3}), grid);
  const double force = 4e5;
  const auto under = [&](const SeatContact& seat, double angle) {
    return seat.under(force *
                      Eigen::Vector3d(std::sin(angle), 0, std::cos(angle)));
  };
  const double at_rim = 50 * degree;
  const SeatState state = under(fine, at_rim);
  ASSERT_GT(state.rims[1].intensity, 0);
  const RoundedRim rim = fine.rounded_rim(state.rims[1].intensity, 1e-4);
  EXPECT_EQ(state.rims[1].peak_pressure, rim.peak_pressure);
  EXPECT_EQ(state.rims[1].reach, rim.reach);
  EXPECT_EQ(state.rim_pressure(), rim.peak_pressure);
  EXPECT_TRUE(std::isnan(state.rims[0].peak_pressure));
  EXPECT_TRUE(std::isnan(under(sharp, at_rim).rim_pressure()));
  EXPECT_EQ(under(sharp, at_rim).intensity(), state.intensity());
  // Nothing is reached by a load that is small.
  EXPECT_TRUE(std::isnan(fine.under({0, 0, 1}).rim_pressure()));
  const auto says = [](const SeatContact& seat, const SeatState& of) {
    std::string all;
    for (const std::string& note : seat.notes(of)) all += note + '\n';
    return all;
  };
  EXPECT_TRUE(has_text(says(fine, state),
                       "on the rounding of its upper rim: "
                       "peak pressure "));
  EXPECT_FALSE(has_text(says(fine, state), "goes"));
  EXPECT_TRUE(has_text(says(coarse, under(coarse, at_rim)),
                       "over the rounding of its upper rim, more than a tenth "
                       "of 0.5 mm, the surface layer"));
}

}  // namespace
}  // namespace contact::test::identities_test
