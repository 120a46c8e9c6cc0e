#include <algorithm>
#include <map>
#include <queue>
#include <random>
#include <utility>

#include "libcontact/base/check.hpp"
#include "libcontact/seat/friction.hpp"
#include "libcontact/seat/readout.hpp"
#include "libcontact/seat/table_parts.hpp"

namespace contact {

using namespace detail;  // the numbers of a state

// Fills a table.
class SeatTable::Maker {
 public:
  Maker(SeatTable& table, const Options& options)
      : table_(table), options_(options) {}

  void make() {
    for (int i = 0; i < table_.count_(0); ++i) {
      for (int j = 0; j < table_.count_(1); ++j) {
        add({i * largest_square, j * largest_square, largest_square});
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
    const Eigen::Array2d step = (table_.high_ - table_.low_) /
                                (largest_square * table_.count_.cast<double>());
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
    const double near = table_.contact_.report_distance();
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
      // None where the body ends too.
      const double k = state.rims[rim].intensity;
      to(intensity + rim) = std::isnan(k) ? 0 : k / (pressure * std::sqrt(rho));
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

  // Whether a part of a square reaches a rim.
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

  // Error of a state, about some slip axes.
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
      at *= largest_square * table_.count_.cast<double>();
      const Eigen::Vector3d force = this->force(at);
      if (!table_.covers(force)) continue;
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

void SeatTable::make(const Options& options) { Maker(*this, options).make(); }

}  // namespace contact
