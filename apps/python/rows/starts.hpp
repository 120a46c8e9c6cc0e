#pragma once

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/joint/placement.hpp"
#include "python/answers.hpp"
#include "python/joint_set.hpp"

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

/// Arguments that say how the halves of rows lie, as Placement does.
struct Lies {
  std::optional<Numbers> from_seat = {};
  std::optional<Numbers> tilt = {};
  std::optional<Numbers> place = {};
  std::optional<Numbers> axial_velocity = {};

  /// The arguments `others`, followed by the given ones of these.
  /// @throws contact::Error for a tilt beside a place, and for any of a ball
  std::vector<Argument> behind(const JointSet& joints,
                               std::initializer_list<Argument> others) const;
};

/// How the halves of rows lie.
class Placements {
 public:
  /// @param first  the number of the first argument of Lies
  Placements(const Lies& lies, std::size_t first)
      : has_seat_(lies.from_seat),
        has_tilt_(lies.tilt),
        has_place_(lies.place),
        slides_(lies.axial_velocity),
        first_(first) {}
  /// The placement of a row, valid until the next; null if none is given.
  /// @throws contact::Error unless from_seat is a rotation, to the 1e-6 of
  ///   hosts that compute in single precision
  const contact::Placement* operator()(const double* const* at, std::size_t i);

 private:
  bool has_seat_, has_tilt_, has_place_, slides_;
  std::size_t first_;
  contact::Placement placement_;
};

}  // namespace contact_python
