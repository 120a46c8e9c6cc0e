#include "libcontact/play/force_law.hpp"

#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/linear/solve.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/conforming/ball.hpp"
#include "libcontact/conforming/pin.hpp"
#include "libcontact/conforming/wall_harmonics.hpp"
#include "libcontact/play/force_series.hpp"

namespace contact {
namespace {

using detail::ForceSeries;

using detail::nan;

// For 5e-12 at up to 80 deg.
constexpr int unknowns = 24;
// Thin layers take as many as there are.
int walled_unknowns(const LayeredPair& pair) {
  return detail::walled_unknowns(pair) <= unknowns
             ? unknowns
             : BallContact::max_walled_unknowns;
}
// Coefficients of a cell's slope and half-angle. The half-angle's singularity
// is 17 half-widths of a cell away, at delta = 0: 34^-9 is left.
constexpr int terms = 9;

template <class Contact, class Pair>
ForceSeries series_of(JointKind kind, const Pair& pair, int count) {
  const Contact contact(pair, InnerLoading::centre(), count);
  const double limit = contact.limit_half_angle().half_angle;
  return {kind, limit,
          [&](double theta) { return contact.force_point(theta); }};
}

ForceSeries series_of(const JointSpec& joint) {
  if (const std::string why = ForceLaw::refusal(joint); !why.empty()) {
    throw Error(why);
  }
  const JointKind kind = joint.geometry.kind();
  const ContactConditions conditions = joint.conditions();
  if (!conditions.walls) {
    return series_of<BallContact>(kind, joint.pair(), unknowns);
  }
  const int count = walled_unknowns(*conditions.walls);
  return kind == JointKind::ball
             ? series_of<BallContact>(kind, *conditions.walls, count)
             : series_of<PinContact>(kind, *conditions.walls, count);
}

// The bits of a double at which the cells of octaves begin.
constexpr int shift = 49;

std::uint64_t cell_number(double x) {
  return std::bit_cast<std::uint64_t>(x) >> shift;
}
double cell_begin(std::uint64_t number) {
  return std::bit_cast<double>(number << shift);
}

// Coefficients of the polynomial through the values at Chebyshev nodes.
using Values = Eigen::Matrix<double, terms, 1>;
struct Interpolation {
  Interpolation() {
    Eigen::Matrix<double, terms, terms> powers;
    for (int i = 0; i < terms; ++i) {
      node(i) = std::cos(std::numbers::pi * (i + 0.5) / terms);
      for (int k = 0; k < terms; ++k) powers(i, k) = std::pow(node(i), k);
    }
    coefficients =
        detail::solve_square(powers, Eigen::MatrixXd::Identity(terms, terms));
  }
  Values node;
  Eigen::Matrix<double, terms, terms> coefficients;
};

}  // namespace

// Between two doubles of the same upper bits, in s = (delta - centre)/width,
// -1 to 1. Force and energy are integrals of the slope, from the exact values
// at the centre.
struct ForceLaw::Cell {
  double centre;
  double width;
  double energy;
  std::array<double, terms + 1> force;
  std::array<double, terms> half_angle;

  double force_at(double s) const {
    double sum = force[terms];
    for (int k = terms - 1; k >= 0; --k) sum = sum * s + force[k];
    return sum;
  }
  double slope_at(double s) const {
    double sum = terms * force[terms];
    for (int k = terms - 1; k > 0; --k) sum = sum * s + k * force[k];
    return sum / width;
  }
  double energy_at(double s) const {
    double sum = force[terms] / (terms + 1);
    for (int k = terms - 1; k >= 0; --k) sum = sum * s + force[k] / (k + 1);
    return energy + width * s * sum;
  }
  double half_angle_slope_at(double s) const {
    double sum = (terms - 1) * half_angle[terms - 1];
    for (int k = terms - 2; k > 0; --k) sum = sum * s + k * half_angle[k];
    return sum / width;
  }
  double half_angle_at(double s) const {
    double sum = half_angle[terms - 1];
    for (int k = terms - 2; k >= 0; --k) sum = sum * s + half_angle[k];
    return sum;
  }
};

struct ForceLaw::Cells {
  // unit: of K_1'/D', N/m.
  Cells(const ForceSeries& series, double clearance, double unit);

  const Cell& of(double penetration) const {
    return cells[std::min<std::uint64_t>(cell_number(penetration) - first,
                                         cells.size() - 1)];
  }
  // The power below the first cell.
  ForceState small(double penetration) const {
    const double share = penetration / smallest;
    const double force = start.force * std::pow(share, power);
    const double half_angle = start.half_angle * std::sqrt(share);
    return {force,
            power * force / penetration,
            force * penetration / (power + 1),
            half_angle,
            1 + (start.force_ratio - 1) * share,
            half_angle / (2 * penetration)};
  }
  // S from W = (F/2) (delta - eps (S - 1)).
  double force_ratio(double penetration, double force, double energy) const {
    return 1 + (penetration - 2 * energy / force) / eps;
  }

  double eps;
  double smallest;
  double largest;
  std::uint64_t first;
  std::vector<Cell> cells;
  ForceState start;
  double power;
};

ForceLaw::Cells::Cells(const ForceSeries& series, double clearance, double unit)
    : eps(clearance) {
  static const Interpolation table;
  first = cell_number(eps * series.at(series.first()).penetration) + 1;
  const std::uint64_t end =
      cell_number(eps * series.at(series.last()).penetration);
  smallest = cell_begin(first);
  largest = cell_begin(end);
  double u = series.first();
  const auto point = [&](double penetration) {
    u = series.at_penetration(penetration / eps, u);
    return series.at(u);
  };
  for (std::uint64_t number = first; number < end; ++number) {
    Cell cell;
    cell.width = (cell_begin(number + 1) - cell_begin(number)) / 2;
    cell.centre = cell_begin(number) + cell.width;
    Values slope;
    Values half_angle;
    for (int i = terms - 1; i >= 0; --i) {
      const ForceSeries::Point at =
          point(cell.centre + cell.width * table.node(i));
      slope(i) = at.slope;
      half_angle(i) = at.half_angle;
    }
    const ForceSeries::Point middle = point(cell.centre);
    const Values k = table.coefficients * slope;
    const Values angle = table.coefficients * half_angle;
    cell.energy = unit * eps * eps * middle.energy;
    cell.force[0] = unit * eps * middle.force;
    for (int i = 0; i < terms; ++i) {
      cell.force[i + 1] = unit * cell.width * k(i) / (i + 1);
      cell.half_angle[i] = angle(i);
    }
    cells.push_back(cell);
  }
  const Cell& edge = cells.front();
  start = {edge.force_at(-1),      0, edge.energy_at(-1),
           edge.half_angle_at(-1), 0, 0};
  start.force_ratio = force_ratio(smallest, start.force, start.energy);
  power = start.force * smallest / start.energy - 1;
}

std::string ForceLaw::refusal(const JointSpec& joint, std::string asker) {
  const std::string name =
      asker.empty() ? to_string(joint.geometry.kind()) + " joint with play"
                    : std::move(asker);
  if (!(joint.geometry.radial_clearance() > 0)) {
    return detail::needs(name, "a radial_clearance above 0 m");
  }
  if (joint.loading.is_back()) {
    return detail::needs(name,
                         "loading = centre: a body that is pressed from "
                         "behind has no approach");
  }
  if (joint.geometry.kind() == JointKind::pin &&
      (joint.outer.backing.kind() == Backing::Kind::medium ||
       !joint.conditions().walls)) {
    return detail::needs(
        name,
        "a wall with a backing other than an infinite body: in an "
        "infinite hole the displacement has no limit");
  }
  return {};
}

ForceLaw::ForceLaw(const JointSpec& joint) : geometry_(joint.geometry) {
  const bool ball = geometry_.kind() == JointKind::ball;
  const double unit = ball ? std::numbers::pi / 3 * geometry_.radius()
                           : std::numbers::pi / 4 * geometry_.length();
  cells_ = std::make_shared<const Cells>(
      series_of(joint), geometry_.radial_clearance(),
      unit * joint.pair().effective_modulus());
}

ForceLaw::~ForceLaw() = default;

namespace {

constexpr ForceState no_contact = {0, 0, 0, 0, 1, 0};
constexpr ForceState no_value = {nan, nan, nan, nan, nan, nan};

}  // namespace

ForceState ForceLaw::at(double penetration) const noexcept {
  const Cells& table = *cells_;
  if (penetration <= 0) return no_contact;
  if (!(penetration <= table.largest)) return no_value;
  if (penetration < table.smallest) return table.small(penetration);
  const Cell& cell = table.of(penetration);
  const double s = (penetration - cell.centre) / cell.width;
  const double force = cell.force_at(s);
  const double energy = cell.energy_at(s);
  return {force,
          cell.slope_at(s),
          energy,
          cell.half_angle_at(s),
          table.force_ratio(penetration, force, energy),
          cell.half_angle_slope_at(s)};
}

double ForceLaw::force(double penetration) const noexcept {
  const Cells& table = *cells_;
  if (!(penetration >= table.smallest && penetration <= table.largest)) {
    return at(penetration).force;
  }
  const Cell& cell = table.of(penetration);
  return cell.force_at((penetration - cell.centre) / cell.width);
}

double ForceLaw::slope(double penetration) const noexcept {
  return at(penetration).slope;
}
double ForceLaw::energy(double penetration) const noexcept {
  return at(penetration).energy;
}
double ForceLaw::half_angle(double penetration) const noexcept {
  return at(penetration).half_angle;
}
double ForceLaw::force_ratio(double penetration) const noexcept {
  return at(penetration).force_ratio;
}

double ForceLaw::largest_penetration() const noexcept {
  return cells_->largest;
}
double ForceLaw::smallest_penetration() const noexcept {
  return cells_->smallest;
}

// Newton's steps for a quantity that grows with delta, from its cell's edge;
// quantity: value and slope of a state.
template <class Quantity>
double ForceLaw::inverse(double value,
                         const Quantity& quantity) const noexcept {
  const Cells& table = *cells_;
  if (value == 0) return 0;
  if (!(value > 0 && value <= quantity(at(table.largest)).first)) return nan;
  const auto next = std::partition_point(
      table.cells.begin(), table.cells.end(), [&](const Cell& cell) {
        return quantity(at(cell.centre - cell.width)).first < value;
      });
  const bool small = next == table.cells.begin();
  double low = small ? 0 : std::prev(next)->centre - std::prev(next)->width;
  double high =
      next == table.cells.end() ? table.largest : next->centre - next->width;
  double penetration = small ? high : (low + high) / 2;
  // A power law takes the most steps, some 10.
  constexpr int step_limit = 200;
  for (int i = 0; i < step_limit; ++i) {
    const auto [now, growth] = quantity(at(penetration));
    (now < value ? low : high) = penetration;
    double step = (value - now) / growth;
    if (!(penetration + step >= low && penetration + step <= high)) {
      step = (low + high) / 2 - penetration;
    }
    penetration += step;
    if (std::abs(step) < 1e-15 * penetration) break;
  }
  return penetration;
}

double ForceLaw::penetration_of_force(double force) const noexcept {
  return inverse(force, [](const ForceState& state) {
    return std::pair(state.force, state.slope);
  });
}

double ForceLaw::penetration_of_energy(double energy) const noexcept {
  return inverse(energy, [](const ForceState& state) {
    return std::pair(state.energy, state.force);
  });
}

}  // namespace contact
