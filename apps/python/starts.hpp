#pragma once

#include <Eigen/LU>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/joint/placement.hpp"
#include "python/answers.hpp"

namespace contact_python {

/// Starts of rows: each from the result of the same number, or all from one.
/// Unpickled results have nothing to start from.
template <class Row>
class Starts {
 public:
  Starts(const Answers<Row>* last, const Rows& rows)
      : last_(last && !last->rows.empty() ? &last->rows : nullptr) {
    if (last && !last->shape.empty() && last->shape != rows.shape()) {
      throw contact::Error(contact::detail::must_be(
          "last", "one result, or of the shape of the rows"));
    }
  }
  // Null where there is nothing.
  const Row* operator()(std::size_t i) const {
    if (!last_) return nullptr;
    return &(*last_)[last_->size() == 1 ? 0 : i];
  }

 private:
  const std::vector<Row>* last_;
};

/// The axis of pins; none is 0.
inline Argument axis_argument(const std::optional<Numbers>& axis) {
  static const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  return axis ? Argument("axis", *axis, 3) : Argument(none);
}

/// Matrices of three by three, row by row, as NumPy has them.
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
inline Eigen::Matrix3d matrix_at(const double* numbers) {
  return Eigen::Map<const RowMajor>(numbers);
}

/// Rotations from the seat's body; none is no rotation.
inline Argument seat_argument(const std::optional<Numbers>& from_seat) {
  static const RowMajor none = RowMajor::Identity();
  return from_seat ? Argument::matrix("from_seat", *from_seat)
                   : Argument(none.data(), 9, {});
}

/// Places of the seats of rows.
class Placements {
 public:
  explicit Placements(const std::optional<Numbers>& from_seat)
      : is_given_(from_seat.has_value()) {}
  /// That of a row, until the next; null where nothing is given.
  /// @param from_seat  its seat_argument()
  /// @throws contact::Error unless it is a rotation, to the 1e-6 of hosts that
  ///   compute in single precision
  const contact::Placement* operator()(const double* from_seat, std::size_t i) {
    if (!is_given_) return nullptr;
    placement_.from_seat = matrix_at(from_seat);
    const Eigen::Matrix3d& turn = placement_.from_seat;
    if (turn.isUnitary(1e-6) && turn.determinant() > 0) return &placement_;
    throw contact::Error(contact::detail::must_be(
        contact::detail::message("from_seat of row {}", i),
        "a rotation matrix"));
  }

 private:
  bool is_given_;
  contact::Placement placement_;
};

}  // namespace contact_python
