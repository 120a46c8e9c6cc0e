#pragma once

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/joint/placement.hpp"
#include "python/answers.hpp"
#include "python/joint_set.hpp"

namespace contact_python {

/// Starting values of rows: each row starts from the result with the same
/// index, or all rows from one result. Unpickled results contain no starting
/// values.
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
  // Null if there is no starting value.
  const Row* operator()(std::size_t i) const {
    if (!last_) return nullptr;
    return &(*last_)[last_->size() == 1 ? 0 : i];
  }

 private:
  const std::vector<Row>* last_;
};

/// The axis of pins; 0 if not given.
inline Argument axis_argument(const std::optional<Numbers>& axis) {
  static const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  return axis ? Argument("axis", *axis, 3) : Argument(none);
}

/// 3 x 3 matrices, row by row as in NumPy.
using RowMajor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;
inline Eigen::Matrix3d matrix_at(const double* numbers) {
  return Eigen::Map<const RowMajor>(numbers);
}

/// Arguments with the positions of the halves of joints, as Placement.
struct Lies {
  std::optional<Numbers> from_seat = {};
  std::optional<Numbers> tilt = {};
  std::optional<Numbers> place = {};
  std::optional<Numbers> axial_velocity = {};

  /// Appends the given ones of these arguments to `others`.
  /// @throws contact::Error for a tilt together with a place, and for any
  ///   position of a ball
  std::vector<Argument> behind(const JointSet& joints,
                               std::initializer_list<Argument> others) const;
};

/// Positions of the halves for each row.
class Placements {
 public:
  /// @param first  index of the first argument of Lies
  Placements(const Lies& lies, std::size_t first)
      : has_seat_(lies.from_seat),
        has_tilt_(lies.tilt),
        has_place_(lies.place),
        slides_(lies.axial_velocity),
        first_(first) {}
  /// The placement of a row, valid until the next call; null if none is given.
  /// @throws contact::Error unless from_seat is a rotation to 1e-6, for hosts
  ///   that compute in single precision
  const contact::Placement* operator()(const double* const* at, std::size_t i);

 private:
  bool has_seat_, has_tilt_, has_place_, slides_;
  std::size_t first_;
  contact::Placement placement_;
};

}  // namespace contact_python
