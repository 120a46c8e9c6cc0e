#include "libcontact/seat/table.hpp"

#include <algorithm>
#include <boost/crc.hpp>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <type_traits>
#include <utility>

#include "libcontact/base/check.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/seat/friction.hpp"
#include "libcontact/seat/table_parts.hpp"

namespace contact {

using namespace detail;  // the numbers of a state

namespace {

using detail::nan;
using detail::pi;
constexpr int degrees = 64;

// Weights of a cubic through four even places, 0 <= x <= 1.
Eigen::Array4d cubic(double x) {
  const double a = 3 * x, b = a - 1, c = a - 2, d = a - 3;
  return {-b * c * d / 6, a * c * d / 2, -a * b * d / 2, a * b * c / 6};
}

constexpr std::string_view any_title = "libcontact table of a seat ";
constexpr std::string_view title = "libcontact table of a seat 2\n";

// Friction and name are not in the table.
std::string head_of(JointSpec joint) {
  joint.name = "";
  joint.friction = {};
  return std::string(title) + joint.canonical_text() + '\n';
}

using CheckSum = std::uint32_t;
CheckSum check_sum(std::string_view bytes) {
  boost::crc_32_type crc;
  crc.process_bytes(bytes.data(), bytes.size());
  return crc.checksum();
}

struct Writer {
  std::string& text;
  template <class T>
  void operator()(const T* of, std::size_t count) {
    static_assert(std::is_same_v<T, double> || std::is_same_v<T, float> ||
                  std::has_unique_object_representations_v<T>);
    text.append(reinterpret_cast<const char*>(of), count * sizeof(T));
  }
  template <class T>
  void resize(const std::vector<T>& of) {
    const auto size = static_cast<std::uint64_t>(of.size());
    (*this)(&size, 1);
  }
  void resize(const Eigen::ArrayXf&, Eigen::Index) {}
};

struct Reader {
  std::string_view rest;
  template <class T>
  void operator()(T* to, std::size_t count) {
    static_assert(std::is_same_v<T, double> || std::is_same_v<T, float> ||
                  std::has_unique_object_representations_v<T>);
    const std::size_t size = count * sizeof(T);
    if (size > rest.size()) throw Error("a table that is cut off");
    std::memcpy(to, rest.data(), size);
    rest.remove_prefix(size);
  }
  template <class T>
  void resize(std::vector<T>& to) {
    std::uint64_t size = 0;
    (*this)(&size, 1);
    if (size > rest.size()) throw Error("a table that is cut off");
    to.resize(size);
  }
  void resize(Eigen::ArrayXf& to, Eigen::Index size) { to.resize(size); }
};

}  // namespace

SeatTable::SeatTable(const SeatContact& contact)
    : contact_(contact),
      radius_(contact.unbounded().geometry().radius()),
      clearance_(contact.unbounded().geometry().radial_clearance()),
      unit_load_(4 * contact.unit_force() * clearance_),
      sums_(std::make_unique<const detail::SeatSums>(degrees)) {
  contact.unbounded().require_clearance("a table of a seat that ends");
  const SeatZone& zone = contact.zone();
  has_mirror_ = std::abs(zone.from() + zone.to() - pi) < 1e-12;
}

SeatTable::SeatTable(const SeatContact& contact, const Options& options)
    : SeatTable(contact) {
  const auto require = [](bool good, const char* name, double value,
                          const char* rule) {
    detail::require(good, "seat table", name, value, rule);
  };
  require(options.least_load > 0, "least_load", options.least_load,
          "above 0 N");
  require(options.most_load > options.least_load, "most_load",
          options.most_load, "above least_load");
  require(std::isfinite(options.most_load), "most_load", options.most_load,
          "finite");
  require(options.accuracy > 0, "accuracy", options.accuracy, "above 0");
  const SeatZone& zone = contact.zone();
  low_ = {load_place(options.least_load), 0};
  high_ = {load_place(options.most_load), has_mirror_ ? pi / 2 : pi};
  if (zone.to() <= pi / 2) high_(1) = 0.9 * zone.to();
  if (zone.from() >= pi / 2) low_(1) = pi - 0.9 * (pi - zone.from());
  // Squares of the size in which states of common joints are smooth.
  count_ = ((high_ - low_) / Eigen::Array2d(0.12, 0.26)).ceil().cast<int>();
  make(options);
}

SeatTable::SeatTable(const SeatContact& contact, const JointSpec& joint,
                     std::string_view bytes)
    : SeatTable(contact) {
  const std::string head = head_of(joint);
  if (!bytes.starts_with(any_title)) throw Error("not a table of a seat");
  if (!bytes.starts_with(title)) {
    throw Error("a table of another version, which has to be made again");
  }
  if (!bytes.starts_with(head)) throw Error("a table of another joint");
  if (bytes.size() < head.size() + sizeof(CheckSum)) {
    throw Error("a table that is cut off");
  }
  const std::string_view all = bytes.substr(0, bytes.size() - sizeof(CheckSum));
  CheckSum sum = 0;
  std::memcpy(&sum, bytes.data() + all.size(), sizeof sum);
  if (sum != check_sum(all)) throw Error("a table that is damaged or cut off");
  Reader reader{all.substr(head.size())};
  pass(*this, reader);
  if (!reader.rest.empty() || !is_whole())
    throw Error("a table that is damaged");
}

// Places are looked for in squares that are there, and end in one without
// halves: they stand behind the square that they are of.
bool SeatTable::is_whole() const {
  const auto size = static_cast<std::int64_t>(squares_.size());
  const std::int64_t largest = std::int64_t{count_(0)} * count_(1);
  if (!((count_ > 0).all() && (low_ < high_).all() && largest <= size)) {
    return false;
  }
  for (std::int64_t i = 0; i < size; ++i) {
    const Square& square = squares_[i];
    const bool ends = square.halves < 0;
    if (!ends && (square.halves <= i || square.halves + 4 > size)) return false;
    if (square.size <= 0) return false;
    if (!ends || !square.is_used) continue;
    for (const int node : square.nodes) {
      if (node < 0 || std::size_t(node) >= nodes_.size()) return false;
    }
  }
  return true;
}

std::string SeatTable::bytes(const JointSpec& joint) const {
  std::string text = head_of(joint);
  pass(*this, Writer{text});
  const CheckSum sum = check_sum(text);
  Writer{text}(&sum, 1);
  return text;
}

// All numbers in their order, to or from a stream of bytes.
template <class Table, class Stream>
void SeatTable::pass(Table& table, Stream&& stream) {
  stream(table.low_.data(), 2);
  stream(table.high_.data(), 2);
  stream(table.count_.data(), 2);
  stream(&table.check_.states, 1);
  stream(&table.check_.load, 1);
  stream(&table.check_.friction, 1);
  stream(&table.check_.peak, 1);
  stream.resize(table.squares_);
  stream(table.squares_.data(), table.squares_.size());
  stream.resize(table.nodes_);
  const auto size = table.basis().size();
  for (auto& node : table.nodes_) {
    stream(node.numbers.data(), detail::count);
    for (auto* harmonics : {&node.pressure, &node.area}) {
      stream.resize(*harmonics, size);
      stream(harmonics->data(), size);
    }
  }
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
  return contact_.free_half_angle(force).has_value();
}

SeatTable::Place SeatTable::place(const Eigen::Vector3d& force) const {
  const double load = force.norm();
  const double direction = polar_angle(force);
  const bool is_mirrored = has_mirror_ && direction > pi / 2;
  const Eigen::Array2d at(load_place(load),
                          is_mirrored ? pi - direction : direction);
  return {(at - low_) / (high_ - low_) * largest_square * count_.cast<double>(),
          load, is_mirrored};
}

const SeatTable::Square* SeatTable::square(const Place& place) const {
  const Eigen::Array2i whole =
      (place.at / largest_square).floor().cast<int>().min(count_ - 1);
  if (!((place.at >= 0) && (place.at <= largest_square * count_.cast<double>()))
           .all())
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
    if (contact_.has_free_side_face() && state.rims[rim].half_arc > 0) {
      state.rims[rim].intensity = nan;
    }
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
  const double near = contact_.report_distance();
  state.peak_pressure = numbers(inner_peak);
  state.peak_place = {numbers(inner_angle), 0};
  for (int n = 0; n < 4; ++n) {
    if (numbers(rim_peak + n) <= state.peak_pressure) continue;
    state.peak_pressure = numbers(rim_peak + n);
    state.peak_place = {n < 2 ? zone.from() + near : zone.to() - near,
                        n % 2 * pi};
  }
  if (state.peak_pressure < numbers(sum) / numbers(area)) {  // the mean
    state.peak_pressure = nan;
    state.peak_place = {};
  }
}

}  // namespace contact
