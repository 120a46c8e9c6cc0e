#pragma once

#include <Eigen/Core>
#include <cmath>

/// A double that counts the operations on it.
namespace multibody::test {

struct OperationCount {
  int multiplications = 0;
  int additions = 0;
  int divisions = 0;
  int trigonometric = 0;
  int total() const {
    return multiplications + additions + divisions + trigonometric;
  }
};

class Counted {
 public:
  Counted() = default;
  Counted(double value) : value_(value) {}  // implicit, like a number

  static OperationCount& count() {
    static OperationCount instance;
    return instance;
  }
  double value() const { return value_; }

  /// Changes of sign are not counted: they are free in an addition.
  Counted operator-() const { return -value_; }
  friend Counted operator+(const Counted& a, const Counted& b) {
    ++count().additions;
    return a.value_ + b.value_;
  }
  friend Counted operator-(const Counted& a, const Counted& b) {
    ++count().additions;
    return a.value_ - b.value_;
  }
  friend Counted operator*(const Counted& a, const Counted& b) {
    ++count().multiplications;
    return a.value_ * b.value_;
  }
  friend Counted operator/(const Counted& a, const Counted& b) {
    ++count().divisions;
    return a.value_ / b.value_;
  }
  Counted& operator+=(const Counted& b) { return *this = *this + b; }
  Counted& operator-=(const Counted& b) { return *this = *this - b; }
  Counted& operator*=(const Counted& b) { return *this = *this * b; }
  Counted& operator/=(const Counted& b) { return *this = *this / b; }
  friend Counted sin(const Counted& a) {
    ++count().trigonometric;
    return std::sin(a.value_);
  }
  friend Counted cos(const Counted& a) {
    ++count().trigonometric;
    return std::cos(a.value_);
  }

 private:
  double value_ = 0;
};

}  // namespace multibody::test

/// Required for elements of a matrix.
template <>
struct Eigen::NumTraits<multibody::test::Counted>
    : Eigen::GenericNumTraits<multibody::test::Counted> {
  using Real = multibody::test::Counted;
  using NonInteger = multibody::test::Counted;
  using Nested = multibody::test::Counted;
  // Names required by Eigen.
  // NOLINTBEGIN(readability-identifier-naming)
  enum {
    IsComplex = 0,
    IsInteger = 0,
    IsSigned = 1,
    RequireInitialization = 1,
    ReadCost = 1,
    AddCost = 1,
    MulCost = 1
  };
  // NOLINTEND(readability-identifier-naming)
};
