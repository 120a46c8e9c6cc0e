#include "libcontact/pair/relief.hpp"

#include "libcontact/base/check.hpp"
#include "libcontact/base/constants.hpp"

namespace contact {
namespace {

using detail::infinity;

}  // namespace

Relief Relief::barrel(double depth) {
  detail::require(depth > 0 && depth < infinity, "relief", "depth", depth,
                  "above 0 m");
  return {Kind::barrel, depth, 0};
}

Relief Relief::ends(double depth, double length) {
  detail::require(depth > 0 && depth < infinity, "relief", "depth", depth,
                  "above 0 m");
  detail::require(length > 0 && length < infinity, "relief", "length", length,
                  "above 0 m");
  return {Kind::ends, depth, length};
}

std::vector<std::string> Relief::notes() const {
  if (*this == none()) return {};
  return {
      "the relief of the ends is ignored: the contact is assumed uniform along "
      "the joint's length"};
}

std::vector<Relief::Piece> Relief::pieces(double length) const {
  const double end = length / 2;
  if (kind_ == Kind::none) return {{-end, end, 0, 0}};
  if (kind_ == Kind::barrel) return {{-end, end, 0, depth_ / (end * end)}};
  detail::require(length_ <= end, "relief", "length", length_,
                  "at most half of the joint's length");
  const double inner = end - length_;
  const double curvature = depth_ / (length_ * length_);
  return {{-end, -inner, -inner, curvature},
          {-inner, inner, 0, 0},
          {inner, end, inner, curvature}};
}

}  // namespace contact
