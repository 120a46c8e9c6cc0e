#pragma once

// Included by each lane_kernel_*.cpp, which is compiled for its own
// instruction set and has lanes of its own.

#include <experimental/simd>
#include <vector>

#include "multibody/dynamics/kernel/lane_kernel.hpp"
#include "multibody/dynamics/two_step.hpp"

namespace multibody::detail {

using Motions = std::experimental::native_simd<double>;

/// An array of doubles as a row of lanes.
template <class V>
struct LaneRow {
  const double* numbers;
  V operator[](int i) const {
    return V(numbers + i * static_cast<int>(V::size()),
             std::experimental::element_aligned);
  }
};

/// The same to write to.
template <class V>
struct WritableLaneRow {
  struct Place {
    double* numbers;
    void operator=(const V& v) const {
      v.copy_to(numbers, std::experimental::element_aligned);
    }
  };
  double* numbers;
  Place operator[](int i) const {
    return {numbers + i * static_cast<int>(V::size())};
  }
};

template <class V, class P>
class LaneKernelOf final : public LaneKernel {
 public:
  explicit LaneKernelOf(const SystemConstants* const* constants)
      : two_step_(constants), reactions_(two_step_.size()) {}

  void set_mode(int load, JointMode mode) override {
    two_step_.set_mode(load, mode);
  }
  void evaluate(const double* state, const double* loading) override {
    const LaneRow<V> c{loading};
    two_step_.evaluate(LaneRow<V>{state},
                       CarrierLoading<V>{vector(c, 0), vector(c, 3)},
                       LaneRow<V>{loading + 6 * V::size()});
  }
  void add_friction(const double* change) override {
    two_step_.add_friction(LaneRow<V>{change});
  }
  void accelerations(double* to) const override {
    const WritableLaneRow<V> row{to};
    write(row, 0, two_step_.carrier().linear);
    write(row, 3, two_step_.carrier().angular);
    two_step_.relative_accelerations(
        [&](int load, const Vec3<V>& a) { write(row, 6 + 3 * load, a); });
  }
  void rates(const double* state, const double* gravity,
             double* to) const override {
    two_step_.rates(LaneRow<V>{state}, vector(LaneRow<V>{gravity}, 0),
                    WritableLaneRow<V>{to});
  }
  void reactions(double* to) override {
    two_step_.reactions(reactions_.data());
    const WritableLaneRow<V> row{to};
    for (int i = 0; i < two_step_.size(); ++i) {
      write(row, 6 * i, reactions_[i].force);
      write(row, 6 * i + 3, reactions_[i].moment);
    }
  }

 private:
  static Vec3<V> vector(LaneRow<V> row, int i) {
    return {row[i], row[i + 1], row[i + 2]};
  }
  static void write(WritableLaneRow<V> row, int i, const Vec3<V>& v) {
    row[i] = v.x;
    row[i + 1] = v.y;
    row[i + 2] = v.z;
  }

  TwoStep<V, P> two_step_;
  std::vector<Reaction<V>> reactions_;
};

/// Made by new.
template <class V>
LaneKernel* new_lane_kernel(const SystemConstants* const* constants,
                            bool same_system) {
  if (same_system) return new LaneKernelOf<V, double>(constants);
  return new LaneKernelOf<V, V>(constants);
}

}  // namespace multibody::detail
