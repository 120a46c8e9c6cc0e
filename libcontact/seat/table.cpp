#include "libcontact/seat/table.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <queue>
#include <random>
#include <utility>

#include "libcontact/base/check.hpp"
#include "libcontact/seat/friction.hpp"
#include "libcontact/seat/readout.hpp"

namespace contact {

namespace {

constexpr double pi = std::numbers::pi;
constexpr int degrees = 64;
constexpr int halvings = 6;
constexpr int largest = 3 << halvings;  // steps of a square

// Numbers of a state; pressures over load/rho^2.
enum Number {
  shift_x,  // over the clearance and load/(E rho)
  shift_z,
  sum,   // S
  area,  // over rho^2
  inner_peak,
  inner_angle,
  rim_peak,                  // lower and upper rim, near and far longitude
  intensity = rim_peak + 4,  // over load/rho^1.5
  arc = intensity + 2,
  lower_end = arc + 2,
  upper_end,
  count
};

// Weights of a cubic through four even places, 0 <= x <= 1.
Eigen::Array4d cubic(double x) {
  const double a = 3 * x, b = a - 1, c = a - 2, d = a - 3;
  return {-b * c * d / 6, a * c * d / 2, -a * b * d / 2, a * b * c / 6};
}

double polar_angle(const Eigen::Vector3d& force) {
  return std::atan2(std::hypot(force.x(), force.y()), force.z());
}

}  // namespace

struct SeatTable::Node {
  static_assert(int(Numbers::SizeAtCompileTime) == int(count));
  Numbers numbers;
  Eigen::ArrayXf pressure, area;  // harmonics, over the load and rho^2
};

// States (i + size/3 k, j + size/3 l), in steps from the lowest place.
struct SeatTable::Square {
  int i, j, size;
  std::array<int, 16> nodes = {};  // k runs fastest
  int halves = -1;                 // the first of four
  bool is_used = false;
};

struct SeatTable::Place {
  Eigen::Array2d at;  // in steps
  double load;
  bool is_mirrored;
};

// Fills a table.
class SeatTable::Maker {
 public:
  Maker(SeatTable& table, const Options& options)
      : table_(table), options_(options) {}

  void make() {
    for (int i = 0; i < table_.count_(0); ++i) {
      for (int j = 0; j < table_.count_(1); ++j) {
        add({i * largest, j * largest, largest});
      }
    }
    refine();
    // Squares in which a state is not good enough are halved, and others asked.
    for (int round = 0; !check() && has_room() && round < 5; ++round) refine();
    if (options_.progress) options_.progress(1);
  }

 private:
  struct Exact {
    SeatState state;
    Node node;
    Eigen::Vector2d shift;
    Eigen::Matrix2d stiffness;
  };

  bool has_room() const {
    return static_cast<int>(table_.nodes_.size()) < options_.most_states;
  }

  Eigen::Vector3d force(Eigen::Array2d at) const {
    const Eigen::Array2d step =
        (table_.high_ - table_.low_) / (largest * table_.count_.cast<double>());
    const Eigen::Array2d place = table_.low_ + at * step;
    const double x = place(0) / (1 - place(0));
    return table_.unit_load_ * x * x * x *
           Eigen::Vector3d(std::sin(place(1)), 0, std::cos(place(1)));
  }

  // On the grid, even where no rim is reached.
  bool solve(const Eigen::Vector3d& force, Exact& exact) {
    last_ = table_.contact_.confined(force, last_);
    exact.state = last_;
    if (last_.status != SeatStatus::ok) {
      last_ = {};
      return false;
    }
    const detail::SeatSolution& solution = *last_.solution;
    exact.shift = solution.patch.shift;
    exact.stiffness =
        solution.solver->tangent(solution.patch) * table_.contact_.unit_force();
    set(solution, force.norm(), exact);
    return true;
  }

  void set(const detail::SeatSolution& solution, double load, Exact& exact) {
    const SeatState& state = exact.state;
    auto& to = exact.node.numbers;
    const double rho = table_.radius_;
    const double pressure = load / (rho * rho);
    const double unit = table_.contact_.unit_force() / (rho * rho * pressure);
    to.segment<2>(shift_x) = exact.shift / table_.shift_unit(load);
    to(sum) = state.force_ratio;
    to(area) = state.area / (rho * rho);
    const detail::SeatReadout read(*solution.solver, solution.patch);
    const detail::SeatWindow& window = solution.solver->cells().window;
    const SeatZone& zone = table_.contact_.zone();
    const double near = table_.contact_.report_distance_;
    const double inside = std::min(4 * near, zone.width() / 3);
    const auto inner = read.peak(inside);
    to(inner_peak) = unit * inner.pressure;
    to(inner_angle) = inner.pressure > 0 ? inner.polar_angle : 0;
    for (const int rim : {0, 1}) {
      const double at = rim == 0 ? zone.from() : zone.to();
      const double sign = rim == 0 ? 1 : -1;
      const double ends[] = {at + sign * near, at + sign * inside};
      for (const int side : {0, 1}) {
        to(rim_peak + 2 * rim + side) =
            window.rim[rim] ? unit * read.peak(ends[rim], ends[1 - rim],
                                               side * solution.solver->order())
                                         .pressure
                            : 0;
      }
      to(intensity + rim) =
          state.rims[rim].intensity / (pressure * std::sqrt(rho));
      to(arc + rim) = state.rims[rim].half_arc;
    }
    const double middle = polar_angle(state.force);
    to(lower_end) = std::isnan(state.lower_end) ? middle : state.lower_end;
    to(upper_end) = std::isnan(state.upper_end) ? middle : state.upper_end;
    const detail::SeatHarmonics harmonics =
        table_.sums_->of(solution, table_.contact_.unit_force());
    exact.node.pressure = (harmonics.pressure / load).cast<float>();
    exact.node.area = harmonics.area.cast<float>();
  }

  // -1: not found.
  int node(int i, int j) {
    const auto [found, is_new] = known_.try_emplace({i, j}, -1);
    if (!is_new) return found->second;
    Exact exact;
    if (solve(force({double(i), double(j)}), exact)) {
      found->second = static_cast<int>(table_.nodes_.size());
      table_.nodes_.push_back(std::move(exact.node));
    }
    if (options_.progress) {
      options_.progress(
          std::min(0.99, double(table_.nodes_.size()) / options_.most_states));
    }
    return found->second;
  }

  // A square of which a part reaches a rim.
  bool is_wanted(const Square& s) const {
    for (int n = 0; n < 16; ++n) {
      const double part = s.size / 3.0;
      if (!table_.is_free(force({s.i + part * (n % 4), s.j + part * (n / 4)})))
        return true;
    }
    return false;
  }

  void add(Square square) {
    const int index = static_cast<int>(table_.squares_.size());
    square.is_used = is_wanted(square);
    for (int n = 0; square.is_used && n < 16; ++n) {
      const int part = square.size / 3;
      square.nodes[n] =
          node(square.i + part * (n % 4), square.j + part * (n / 4));
      square.is_used = square.nodes[n] >= 0;
    }
    table_.squares_.push_back(square);
    if (!square.is_used) return;
    const double middle = square.size / 2.0;
    const Check found = error({square.i + middle, square.j + middle}, 3);
    rough_.push({std::max(found.load, found.friction), index});
  }

  void halve(int index) {
    const Square whole = table_.squares_[index];
    if (whole.size == 3 || whole.halves >= 0) return;
    table_.squares_[index].halves = static_cast<int>(table_.squares_.size());
    const int half = whole.size / 2;
    for (int n = 0; n < 4; ++n) {
      add({whole.i + half * (n % 2), whole.j + half * (n / 2), half});
    }
  }

  void refine() {
    while (!rough_.empty() && has_room() &&
           rough_.top().first > options_.accuracy / 4) {
      const int index = rough_.top().second;
      rough_.pop();
      halve(index);
    }
  }

  // Errors at a state: about some slip axes.
  Check error(const Eigen::Array2d& at, int axes) {
    Exact exact;
    const Eigen::Vector3d force = this->force(at);
    if (!solve(force, exact)) return {};
    const double load = force.norm();
    const Square* square = table_.square({at, load, false});
    if (!square) return {};
    Numbers numbers;
    detail::SeatHarmonics harmonics;
    table_.interpolate(*square, {at, 1, false}, numbers, &harmonics, false);
    const Eigen::Vector2d shift =
        numbers.segment<2>(shift_x).matrix() * table_.shift_unit(load);
    Check check{1, (exact.stiffness * (shift - exact.shift)).norm() / load, 0,
                0};
    const Eigen::ArrayXd off =
        harmonics.pressure - exact.node.pressure.cast<double>();
    for (int n = 0; n < axes; ++n) {
      const auto slip = table_.sums_->basis().dry(off, axis());
      check.friction =
          std::max({check.friction, slip.force.norm(), slip.moment.norm()});
    }
    SeatState table;
    SeatState grid;
    table_.set_peak(numbers, table);
    table_.set_peak(exact.node.numbers, grid);
    check.peak = std::abs(table.peak_pressure / grid.peak_pressure - 1);
    return check;
  }

  Eigen::Vector3d axis() {
    std::normal_distribution<double> normal;
    return Eigen::Vector3d(normal(random_), normal(random_), normal(random_))
        .normalized();
  }

  // Whether states drawn at random are as good as they should be.
  bool check() {
    std::uniform_real_distribution<double> uniform(0, 1);
    Check& all = table_.check_ = {};
    for (int tries = 0; all.states < options_.checks && tries < 1000; ++tries) {
      Eigen::Array2d at(uniform(random_), uniform(random_));
      at *= largest * table_.count_.cast<double>();
      const Eigen::Vector3d force = this->force(at);
      if (table_.is_free(force) || !table_.covers(force)) continue;
      const Check one = error(at, 1);
      all.states += one.states;
      all.load = std::max(all.load, one.load);
      all.friction = std::max(all.friction, one.friction);
      all.peak = std::max(all.peak, one.peak);
      const double worst = std::max(one.load, one.friction);
      if (worst <= options_.accuracy) continue;
      const Square* square = table_.square({at, force.norm(), false});
      rough_.push({worst, static_cast<int>(square - table_.squares_.data())});
    }
    return std::max(all.load, all.friction) <= options_.accuracy;
  }

  SeatTable& table_;
  const Options& options_;
  SeatState last_;
  std::map<std::pair<int, int>, int> known_;
  std::priority_queue<std::pair<double, int>> rough_;
  std::mt19937_64 random_{1};
};

SeatTable::SeatTable(const SeatContact& contact, const Options& options)
    : contact_(contact),
      radius_(contact.unbounded().geometry().radius()),
      clearance_(contact.unbounded().geometry().radial_clearance()),
      unit_load_(4 * contact.unit_force() * clearance_),
      sums_(std::make_unique<const detail::SeatSums>(degrees)) {
  contact.unbounded().require_clearance("a table of a seat that ends");
  const auto require = [](bool good, const char* name, double value,
                          const char* rule) {
    detail::require(good, "seat table", name, value, rule);
  };
  require(options.least_load > 0, "least_load", options.least_load,
          "above 0 N");
  require(options.most_load > options.least_load, "most_load",
          options.most_load, "above least_load");
  require(options.accuracy > 0, "accuracy", options.accuracy, "above 0");
  const SeatZone& zone = contact.zone();
  has_mirror_ = std::abs(zone.from() + zone.to() - pi) < 1e-12;
  low_ = {load_place(options.least_load), 0};
  high_ = {load_place(options.most_load), has_mirror_ ? pi / 2 : pi};
  if (zone.to() <= pi / 2) high_(1) = 0.9 * zone.to();
  if (zone.from() >= pi / 2) low_(1) = pi - 0.9 * (pi - zone.from());
  // Squares of the size in which states of common joints are smooth.
  count_ = ((high_ - low_) / Eigen::Array2d(0.12, 0.26)).ceil().cast<int>();
  Maker(*this, options).make();
}

SeatTable::~SeatTable() = default;

int SeatTable::size() const { return static_cast<int>(nodes_.size()); }

const detail::SeatBasis& SeatTable::basis() const { return sums_->basis(); }

// All loads are between 0 and 1: they are smooth at both ends.
double SeatTable::load_place(double load) const {
  const double x = std::cbrt(load / unit_load_);
  return x / (1 + x);
}

double SeatTable::shift_unit(double load) const {
  return clearance_ + load / (4 * contact_.unit_force());
}

bool SeatTable::is_free(const Eigen::Vector3d& force) const {
  const HalfAngleResult half_angle =
      contact_.unbounded().half_angle(force.norm());
  return half_angle.status == Status::ok &&
         contact_.zone().margin(polar_angle(force), half_angle.half_angle) >= 0;
}

SeatTable::Place SeatTable::place(const Eigen::Vector3d& force) const {
  const double load = force.norm();
  const double direction = polar_angle(force);
  const bool is_mirrored = has_mirror_ && direction > pi / 2;
  const Eigen::Array2d at(load_place(load),
                          is_mirrored ? pi - direction : direction);
  return {(at - low_) / (high_ - low_) * largest * count_.cast<double>(), load,
          is_mirrored};
}

const SeatTable::Square* SeatTable::square(const Place& place) const {
  const Eigen::Array2i whole =
      (place.at / largest).floor().cast<int>().min(count_ - 1);
  if (!((place.at >= 0) && (place.at <= largest * count_.cast<double>())).all())
    return nullptr;
  const Square* at = &squares_[whole(0) * count_(1) + whole(1)];
  while (at->halves >= 0) {
    const double half = at->size / 2.0;
    const int n = (place.at(0) >= at->i + half ? 1 : 0) +
                  (place.at(1) >= at->j + half ? 2 : 0);
    at = &squares_[at->halves + n];
  }
  return at->is_used ? at : nullptr;
}

bool SeatTable::covers(const Eigen::Vector3d& force) const {
  return square(place(force)) != nullptr && !is_free(force);
}

void SeatTable::interpolate(const Square& in, const Place& place,
                            Numbers& numbers, detail::SeatHarmonics* harmonics,
                            bool has_area) const {
  const Eigen::Array4d x = cubic((place.at(0) - in.i) / in.size);
  const Eigen::Array4d y = cubic((place.at(1) - in.j) / in.size);
  numbers.setZero();
  if (harmonics) {
    harmonics->pressure.setZero(basis().size());
    if (has_area) harmonics->area.setZero(basis().size());
  }
  for (int n = 0; n < 16; ++n) {
    const Node& node = nodes_[in.nodes[n]];
    const double share = x(n % 4) * y(n / 4);
    numbers += share * node.numbers;
    if (!harmonics) continue;
    harmonics->pressure += place.load * share * node.pressure.cast<double>();
    if (has_area) harmonics->area += share * node.area.cast<double>();
  }
  numbers.segment<upper_end - rim_peak>(rim_peak) =
      numbers.segment<upper_end - rim_peak>(rim_peak).max(0.0);
}

bool SeatTable::find(const Eigen::Vector3d& force, SeatState& state,
                     detail::SeatHarmonics* harmonics, bool has_area) const {
  const Place at = place(force);
  const Square* in = square(at);
  if (!in || is_free(force)) return false;
  Numbers numbers;
  interpolate(*in, at, numbers, harmonics, has_area);
  const double sign = at.is_mirrored ? -1 : 1;
  const double pressure = at.load / (radius_ * radius_);
  const Eigen::Vector2d shift =
      numbers.segment<2>(shift_x).matrix() * shift_unit(at.load);
  state = {};
  state.status = SeatStatus::ok;
  state.force = force;
  state.shift = detail::plane_axes(force) *
                Eigen::Vector3d(shift.x(), 0, sign * shift.y());
  state.force_ratio = numbers(sum);
  state.area = radius_ * radius_ * numbers(area);
  set_peak(numbers, state);
  state.peak_pressure *= pressure;
  for (const int rim : {0, 1}) {
    state.rims[rim].intensity =
        numbers(intensity + rim) * pressure * std::sqrt(radius_);
    state.rims[rim].half_arc = std::min(numbers(arc + rim), pi);
  }
  const SeatZone& zone = contact_.zone();
  state.lower_end = std::clamp(numbers(lower_end), zone.from(), zone.to());
  state.upper_end = std::clamp(numbers(upper_end), zone.from(), zone.to());
  if (at.is_mirrored) {
    std::swap(state.rims[0], state.rims[1]);
    const double lower = state.lower_end;
    state.lower_end = pi - state.upper_end;
    state.upper_end = pi - lower;
    state.peak_place.polar_angle = pi - state.peak_place.polar_angle;
    if (harmonics) {
      basis().mirror(harmonics->pressure);
      if (has_area) basis().mirror(harmonics->area);
    }
  }
  contact_.set_rims(state);
  return true;
}

// In units of load/rho^2.
void SeatTable::set_peak(const Numbers& numbers, SeatState& state) const {
  const SeatZone& zone = contact_.zone();
  const double near = contact_.report_distance_;
  state.peak_pressure = numbers(inner_peak);
  state.peak_place = {numbers(inner_angle), 0};
  for (int n = 0; n < 4; ++n) {
    if (numbers(rim_peak + n) <= state.peak_pressure) continue;
    state.peak_pressure = numbers(rim_peak + n);
    state.peak_place = {n < 2 ? zone.from() + near : zone.to() - near,
                        n % 2 * pi};
  }
}

}  // namespace contact
