#pragma once

#include <type_traits>
#include <vector>

#include "libcontact/base/simd.hpp"
#include "multibody/dynamics/carrier_equations.hpp"
#include "multibody/system/active_forces.hpp"
#include "multibody/system/constants.hpp"
#include "multibody/system/state_layout.hpp"

namespace multibody {

/// Number of lanes of a scalar type, 1 if it has none.
template <class S>
constexpr int lane_count() {
  if constexpr (requires { S::size(); }) {
    return S::size();
  } else {
    return 1;
  }
}

/// Scalars of one resolution: T of the state, S of the bodies (T, or lanes over
/// bodies if T is double). Bodies are taken in packets of `width`.
template <class T, class S>
struct Lanes {
  static constexpr int width = lane_count<S>();
  /// Type of a body's parameters.
  using Parameter = std::conditional_t<(width > 1), S, double>;

  static T at(const S& s, int lane) {
    if constexpr (width == 1) {
      return s;
    } else {
      return s[lane];
    }
  }
  static Vec3<T> at(const Vec3<S>& v, int lane) {
    return {at(v.x, lane), at(v.y, lane), at(v.z, lane)};
  }
  /// Vectors of a packet's bodies; in empty lanes the numbers beyond the last
  /// body, or 0.
  template <class Packet>
  [[gnu::always_inline]] static Vec3<S> read(const Packet& packet,
                                             const VectorRows& rows) {
    const auto row = [&](int k) {
      if constexpr (width == 1) {
        return rows.at(packet.body[0])[k * VectorRows::lanes];
      } else if (packet.in_order) {
        return S::load(rows.at(packet.body[0]) + k * VectorRows::lanes);
      } else {
        return S([&](auto lane) {
          const int body = packet.body[lane];
          return body < 0 ? 0.0 : rows.at(body)[k * VectorRows::lanes];
        });
      }
    };
    return {row(0), row(1), row(2)};
  }
  template <class Packet>
  [[gnu::always_inline]] static void write(const Packet& packet,
                                           const Vec3<S>& v,
                                           const VectorRows& rows) {
    const auto row = [&](const S& x, int k) {
      if constexpr (width == 1) {
        rows.at(packet.body[0])[k * VectorRows::lanes] = x;
      } else if (packet.in_order) {
        x.store(rows.at(packet.body[0]) + k * VectorRows::lanes);
      } else {
        for (int lane = 0; lane < width; ++lane) {
          const int body = packet.body[lane];
          if (body >= 0) rows.at(body)[k * VectorRows::lanes] = x[lane];
        }
      }
    };
    row(v.x, 0);
    row(v.y, 1);
    row(v.z, 2);
  }
  static Vec3<S> spread(const Vec3<T>& v) { return {S(v.x), S(v.y), S(v.z)}; }
  static CarrierAcceleration<S> spread(const CarrierAcceleration<T>& c) {
    return {spread(c.linear), spread(c.angular)};
  }
  /// Numbers base[index * stride ...] of every lane; `empty` where the body is
  /// negative.
  template <int n>
  [[gnu::always_inline]] static void read(const int (&body)[width],
                                          const int (&index)[width],
                                          const T* base, int stride,
                                          const double* empty, S (&to)[n]) {
    if constexpr (width == 1) {
      for (int k = 0; k < n; ++k) to[k] = base[index[0] * stride + k];
    } else {
      const T* from[width];
      for (int lane = 0; lane < width; ++lane) {
        from[lane] = body[lane] < 0 ? empty : base + index[lane] * stride;
      }
      for (int k = 0; k < n; ++k) {
        to[k] = S([&](auto lane) { return from[lane][k]; });
      }
    }
  }

  /// Over the bodies of a packet.
  template <class X>
  static auto sum(const X& s) {
    if constexpr (width == 1) {
      return s;
    } else {
      return reduce(s);
    }
  }
  template <class X>
  static auto sum(const Vec3<X>& v) {
    return Vec3{sum(v.x), sum(v.y), sum(v.z)};
  }
  template <class X>
  static auto sum(const Sym3<X>& m) {
    return Sym3{sum(m.xx), sum(m.yy), sum(m.zz),
                sum(m.xy), sum(m.xz), sum(m.yz)};
  }
  template <class X>
  static auto sum(const CarrierMatrix<X>& m) {
    const Mat3<X>& b = m.b_transposed;
    return CarrierMatrix<decltype(sum(b.x.x))>{
        sum(m.a), {sum(b.x), sum(b.y), sum(b.z)}, sum(m.f)};
  }
  /// Lanes whose sum is t.
  static S to_sum(const T& t) {
    if constexpr (width == 1) {
      return t;
    } else {
      return S([&](auto lane) { return lane == 0 ? t : T(0.0); });
    }
  }
  static Vec3<S> to_sum(const Vec3<T>& v) {
    return {to_sum(v.x), to_sum(v.y), to_sum(v.z)};
  }
  static Sym3<S> to_sum(const Sym3<T>& m) {
    return {to_sum(m.xx), to_sum(m.yy), to_sum(m.zz),
            to_sum(m.xy), to_sum(m.xz), to_sum(m.yz)};
  }
  static CarrierMatrix<S> to_sum(const CarrierMatrix<T>& m) {
    const Mat3<T>& b = m.b_transposed;
    return {to_sum(m.a), {to_sum(b.x), to_sum(b.y), to_sum(b.z)}, to_sum(m.f)};
  }
};

/// The bodies of one kind in packets. Kernel is a kernel of TwoStep.
template <class T, class S, template <class, class> class KernelTemplate>
class LinkGroup {
 public:
  using L = Lanes<T, S>;
  using Kernel = KernelTemplate<S, typename L::Parameter>;
  static constexpr int width = L::width;

  struct Packet {
    Kernel kernel;
    int body[width];    ///< -1: empty lane, whose constants are all 0
    int offset[width];  ///< first number in the state
    bool in_order;      ///< bodies that follow on each other, as in VectorRows
  };

  void reserve(int bodies) { packets_.reserve((bodies + width - 1) / width); }
  void clear() {
    packets_.clear();
    lanes_used_ = width;
  }
  static constexpr bool serves(HingeKind kind, JointMode mode) {
    return Kernel::serves(kind, mode);
  }
  /// Appends a body and returns its place; finish() builds the kernels.
  void add(int body, int offset, int& packet_index, int& lane) {
    if (lanes_used_ == width) {
      Packet& packet = packets_.emplace_back();
      for (int& empty : packet.body) empty = -1;
      lanes_used_ = 0;
    }
    packet_index = static_cast<int>(packets_.size()) - 1;
    lane = lanes_used_++;
    packets_.back().body[lane] = body;
    packets_.back().offset[lane] = offset + Kernel::state_begin;
  }
  void finish(const SystemConstants& system) {
    for (Packet& packet : packets_) {
      packet.in_order = is_in_order(packet, system.size());
      packet.kernel.set_constants(
          [&](std::size_t i) { return parameter(packet, system, i); });
    }
  }

  std::vector<Packet>& packets() { return packets_; }
  const std::vector<Packet>& packets() const { return packets_; }

 private:
  static bool is_in_order(const Packet& packet, int bodies) {
    const int first = packet.body[0];
    for (int lane = 1; lane < width; ++lane) {
      const int next = first + lane;
      if (packet.body[lane] != (next < bodies ? next : -1)) return false;
    }
    return first % width == 0;
  }

  // The i-th constant of a packet.
  static typename L::Parameter parameter(const Packet& packet,
                                         const SystemConstants& system,
                                         std::size_t i) {
    const auto number = [&](auto lane) {
      const int body = packet.body[lane];
      return body < 0 ? 0.0 : Kernel::constant(system, body, i);
    };
    if constexpr (width > 1) {
      return typename L::Parameter(number);
    } else {
      return number(0);
    }
  }

  std::vector<Packet> packets_;
  int lanes_used_ = width;
};

}  // namespace multibody
