#include "python/rows/starts.hpp"

#include <Eigen/LU>
#include <cmath>
#include <limits>

#include "libcontact/base/text.hpp"

namespace contact_python {

std::vector<Argument> Lies::behind(
    const JointSet& joints, std::initializer_list<Argument> others) const {
  if (tilt && place) {
    throw contact::Error(
        contact::detail::must_be("tilt", "left out beside place"));
  }
  const bool ends_pin = tilt || place || axial_velocity;
  if (ends_pin && joints.size() > 0 && !joints[0].is_pin()) {
    throw contact::Error(contact::detail::must_be(
        "tilt, place and axial_velocity", "those of a pin"));
  }
  if (from_seat && joints.size() > 0 && joints[0].is_pin()) {
    throw contact::Error(
        contact::detail::must_be("from_seat", "that of a ball"));
  }
  std::vector<Argument> all(others);
  if (from_seat) all.push_back(Argument::matrix("from_seat", *from_seat));
  if (tilt) all.emplace_back("tilt", *tilt, 3);
  if (place) all.emplace_back("place", *place, 0);
  if (axial_velocity) {
    all.emplace_back("axial_velocity", *axial_velocity, 0);
  }
  return all;
}

const contact::Placement* Placements::operator()(const double* const* at,
                                                 std::size_t i) {
  if (!(has_seat_ || has_tilt_ || has_place_ || slides_)) return nullptr;
  at += first_;
  if (has_seat_) {
    const Eigen::Matrix3d turn = matrix_at(*at++);
    if (!(turn.isUnitary(1e-6) && turn.determinant() > 0)) {
      throw contact::Error(contact::detail::must_be(
          contact::detail::message("from_seat of row {}", i),
          "a rotation matrix"));
    }
    placement_.from_seat = turn;
  }
  if (has_tilt_) placement_.tilt = vector_at(*at++);
  if (has_place_) {
    placement_.place = **at++;
    // Joint interprets a place of NaN as no place; a tilt of NaN then leaves no
    // solution.
    const bool is_known = !std::isnan(placement_.place);
    placement_.tilt.setConstant(
        is_known ? 0 : std::numeric_limits<double>::quiet_NaN());
  }
  if (slides_) placement_.axial_velocity = **at;
  return &placement_;
}

}  // namespace contact_python
