#pragma once

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
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

}  // namespace contact_python
