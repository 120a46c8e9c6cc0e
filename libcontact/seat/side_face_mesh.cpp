#include "libcontact/seat/side_face_mesh.hpp"

#include <algorithm>
#include <cmath>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/constants.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"

namespace contact::detail {
namespace {

// Sizes from a fine one on that add up to a length.
std::vector<double> graded(double first, double growth, double largest,
                           double length) {
  std::vector<double> sizes;
  double sum = 0;
  for (double h = first; sum < length * (1 - 1e-9); h *= growth) {
    sizes.push_back(std::min(h, largest));
    sum += sizes.back();
  }
  for (double& h : sizes) h *= length / sum;
  return sizes;
}

void append(std::vector<double>& places, const std::vector<double>& sizes) {
  for (const double h : sizes) places.push_back(places.back() + h);
}

std::vector<double> reversed(std::vector<double> sizes) {
  std::reverse(sizes.begin(), sizes.end());
  return sizes;
}

// Distance at which an infinite body is held: displacements there are small.
// Behind layers, in units of their thickness: the removed part of the layers
// moves the backing only nearby, dA to 6e-3.
constexpr double far_end = 1e3;
constexpr double far_layers = 30;

}  // namespace

SideFaceMesh::SideFaceMesh(const LayeredPair& pair, const SeatZone& zone,
                           double coarser)
    : from_(zone.from()),
      to_(zone.to()),
      side_{zone.has_lower_rim() ? zone.side_angle(0) : nan,
            zone.has_upper_rim() ? zone.side_angle(1) : nan} {
  const LayeredBody& body = pair.outer();
  is_held_ = body.backing.kind() == Backing::Kind::held;
  has_housing_ =
      body.backing.kind() == Backing::Kind::medium && !body.layers.empty();
  double layer = 1;
  if (!body.layers.empty()) {
    layer = std::min(layer, body.layers.front().thickness / pair.radius());
  }
  const double finest =
      coarser * std::min({1e-3, layer / 15, zone.width() / 40});
  cuts_all_ = zone.edge().housing == SideFace::free;
  set_radii(body, pair.radius(), finest);
  set_angles(zone, finest);
}

void SideFaceMesh::set_radii(const LayeredBody& body, double radius,
                             double finest) {
  radius_ = {1};
  double next = finest;
  const auto fill = [&](double thickness, double growth, double largest,
                        const Material& material) {
    const auto sizes = graded(next, growth, largest, thickness);
    append(radius_, sizes);
    material_.insert(material_.end(), sizes.size(), material);
    next = sizes.back();
  };
  for (const Layer& layer : body.layers) {
    const double thickness = layer.thickness / radius;
    fill(thickness, 2.2, std::max(thickness / 4, finest), layer.material);
  }
  cut_rows_ = rows();
  if (body.backing.kind() == Backing::Kind::medium) {
    const double layers = radius_.back() - 1;
    const double end = layers > 0 && !cuts_all_ ? far_layers * layers : far_end;
    fill(end, 2.5, end, body.backing.material());
  }
  if (body.layers.empty()) cut_rows_ = rows();
}

void SideFaceMesh::set_angles(const SeatZone& zone, double finest) {
  constexpr double growth = 1.6;
  const double even = zone.width() / 12;
  const bool low = zone.has_lower_rim(), high = zone.has_upper_rim();
  angle_ = {0};
  if (low) append(angle_, reversed(graded(finest, 2.2, 0.5, from_)));
  angle_.back() = from_;
  first_ = columns();
  const double part = zone.width() / (low && high ? 2 : 1);
  const auto from_rim = graded(finest, growth, even, part);
  if (low) append(angle_, from_rim);
  if (high) append(angle_, reversed(from_rim));
  angle_.back() = to_;
  last_ = columns() - 1;
  if (high) append(angle_, graded(finest, 2.2, 0.5, pi - to_));
  angle_.back() = pi;
}

// By how much a side face has turned towards the middle of the seat.
double SideFaceMesh::turn(int rim, double radius) const {
  if (std::isnan(side_[rim])) return 0;
  const double cosine = std::cos(side_[rim]), sine = std::sin(side_[rim]);
  const double length =
      std::sqrt(sine * sine + (radius - 1) * (radius + 1)) - sine;
  return std::atan2(length * cosine, 1 + length * sine);
}

std::string SideFaceMesh::refusal() const {
  if (is_held_) return needs("side_face = free", "a backing that is not held");
  if (cuts_all_ && !has_housing_) {
    return needs("housing = free", "an elastic backing behind layers");
  }
  const double radius = radius_[cut_rows_];
  const double low = from_ + turn(0, radius), high = to_ - turn(1, radius);
  // Elements stay whole down to a fifth of the seat's width.
  if (high - low >= (to_ - from_) / 5) return {};
  return message(
      "side_face = free: the side faces, at {:.4g} deg to the seat, leave "
      "{:.3g} deg of {:.3g} at the back of the wall; at least a fifth must be "
      "left",
      (std::isnan(side_[1]) ? side_[0] : side_[1]) / degree,
      std::max(high - low, 0.0) / degree, (to_ - from_) / degree);
}

bool SideFaceMesh::is_cut_off(int column, int row) const {
  return (cuts_all_ || row < cut_rows_) && (column < first_ || column > last_);
}

double SideFaceMesh::seat_angle(int i) const {
  return i % 2 == 0 ? angle_[i / 2] : (angle_[i / 2] + angle_[i / 2 + 1]) / 2;
}

Eigen::Vector2d SideFaceMesh::node(int i, int j) const {
  const double r =
      j % 2 == 0 ? radius_[j / 2] : (radius_[j / 2] + radius_[j / 2 + 1]) / 2;
  const double v = seat_angle(i);
  const double cut = std::min(r, radius_[cut_rows_]);
  const double low = from_ + turn(0, cut), high = to_ - turn(1, cut);
  double t = low + (high - low) * (v - from_) / (to_ - from_);
  if (v < from_) t = low * v / from_;
  if (v > to_) t = high + (pi - high) * (v - to_) / (pi - to_);
  const bool at_pole = v == 0 || v == pi;
  return {at_pole ? 0 : r * std::sin(t), r * std::cos(t)};
}

}  // namespace contact::detail
