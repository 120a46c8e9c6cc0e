#pragma once

#include <bit>
#include <cmath>
#include <concepts>
#include <cstdint>
#include <type_traits>
#include <utility>
#if defined(__SSE2__)
#include <immintrin.h>
#endif

/// Numbers side by side in a vector of the compiler's, g++ or clang, on any
/// machine. In kernels only: each file that is compiled for an instruction set
/// has types of its own, so that the linker does not mix functions of two sets.
namespace contact::detail {

enum class LaneSet { baseline, avx2, avx512 };
#if defined(__AVX512VL__)
inline constexpr LaneSet compiled_set = LaneSet::avx512;
inline constexpr int native_lanes = 8;
#elif defined(__AVX2__)
inline constexpr LaneSet compiled_set = LaneSet::avx2;
inline constexpr int native_lanes = 4;
#else
inline constexpr LaneSet compiled_set = LaneSet::baseline;
inline constexpr int native_lanes = 2;
#endif

// Members are inlined into kernels, whatever the compiler's limits are.
#define CONTACT_LANE __attribute__((always_inline)) inline

template <class T, int n>
struct NativeVector {
  typedef T type __attribute__((vector_size(n * sizeof(T))));
};

/// The outcome of a comparison in each lane.
template <int n, LaneSet set = compiled_set>
class LaneMask {
 public:
  /// A bit, or as many as a number has, for each lane.
  static constexpr bool is_bits = set == LaneSet::avx512;
  using Native =
      std::conditional_t<is_bits, std::uint8_t,
                         typename NativeVector<std::int64_t, n>::type>;

  CONTACT_LANE explicit LaneMask(Native native) : native_(native) {}
  CONTACT_LANE explicit LaneMask(bool value) {
    if constexpr (is_bits) {
      native_ = value ? all_bits : 0;
    } else {
      native_ = Native{} - std::int64_t{value};
    }
  }

  CONTACT_LANE Native native() const { return native_; }
  CONTACT_LANE bool operator[](int i) const {
    if constexpr (is_bits) {
      return (native_ >> i & 1) != 0;
    } else {
      return native_[i] != 0;
    }
  }
  /// Lane i as bit i.
  CONTACT_LANE unsigned bits() const {
    if constexpr (is_bits) {
      return native_;
#if defined(__AVX2__)
    } else if constexpr (n == 4) {
      return static_cast<unsigned>(
          _mm256_movemask_pd(std::bit_cast<__m256d>(native_)));
#endif
#if defined(__SSE2__)
    } else if constexpr (n == 2) {
      return static_cast<unsigned>(
          _mm_movemask_pd(std::bit_cast<__m128d>(native_)));
#endif
    } else {
      unsigned all = 0;
      for (int i = 0; i < n; ++i) all |= unsigned{(*this)[i]} << i;
      return all;
    }
  }

  friend CONTACT_LANE LaneMask operator&&(const LaneMask& a,
                                          const LaneMask& b) {
    return LaneMask(static_cast<Native>(a.native_ & b.native_));
  }
  friend CONTACT_LANE LaneMask operator||(const LaneMask& a,
                                          const LaneMask& b) {
    return LaneMask(static_cast<Native>(a.native_ | b.native_));
  }
  CONTACT_LANE LaneMask operator!() const {
    if constexpr (is_bits) {
      return LaneMask(static_cast<Native>(native_ ^ all_bits));
    } else {
      return LaneMask(static_cast<Native>(~native_));
    }
  }
  friend CONTACT_LANE bool any_of(const LaneMask& m) { return m.bits() != 0; }
  friend CONTACT_LANE bool none_of(const LaneMask& m) { return !any_of(m); }
  friend CONTACT_LANE bool all_of(const LaneMask& m) {
    return m.bits() == all_bits;
  }
  friend CONTACT_LANE int popcount(const LaneMask& m) {
    return std::popcount(m.bits());
  }
  /// Lane of the first; one must be.
  friend CONTACT_LANE int find_first_set(const LaneMask& m) {
    return std::countr_zero(m.bits());
  }

 private:
  static constexpr unsigned all_bits = (1U << n) - 1;
  Native native_;
};

template <int n, LaneSet set = compiled_set>
class LanesOf {
 public:
  using Native = typename NativeVector<double, n>::type;
  using Bits = typename NativeVector<std::uint64_t, n>::type;
  using mask_type = LaneMask<n, set>;

  static constexpr int size() { return n; }

  LanesOf() = default;
  CONTACT_LANE explicit LanesOf(Native native) : native_(native) {}
  // NOLINTNEXTLINE: the same number in all lanes, in formulae
  CONTACT_LANE LanesOf(double all)
      : LanesOf([all](auto) __attribute__((always_inline)) { return all; }) {}
  /// From of(lane) for each lane, an integral constant.
  template <class F>
  requires std::invocable<const F&, std::integral_constant<int, 0>>
      CONTACT_LANE explicit LanesOf(const F& of)
      : native_([&]<int... i>(std::integer_sequence<int, i...>)
                    __attribute__((always_inline)) {
                      return Native{of(std::integral_constant<int, i>())...};
                    }(std::make_integer_sequence<int, n>())) {}
  CONTACT_LANE static LanesOf load(const double* from) {
    LanesOf v;
    __builtin_memcpy(&v.native_, from, sizeof v.native_);
    return v;
  }
  CONTACT_LANE void store(double* to) const {
    __builtin_memcpy(to, &native_, sizeof native_);
  }

  CONTACT_LANE Native native() const { return native_; }
  CONTACT_LANE double operator[](int i) const { return native_[i]; }
  CONTACT_LANE void set_lane(int i, double value) { native_[i] = value; }

  friend CONTACT_LANE LanesOf operator+(const LanesOf& a, const LanesOf& b) {
    return LanesOf(a.native_ + b.native_);
  }
  friend CONTACT_LANE LanesOf operator-(const LanesOf& a, const LanesOf& b) {
    return LanesOf(a.native_ - b.native_);
  }
  friend CONTACT_LANE LanesOf operator*(const LanesOf& a, const LanesOf& b) {
    return LanesOf(a.native_ * b.native_);
  }
  friend CONTACT_LANE LanesOf operator/(const LanesOf& a, const LanesOf& b) {
    return LanesOf(a.native_ / b.native_);
  }
  CONTACT_LANE LanesOf operator-() const { return LanesOf(-native_); }
  CONTACT_LANE LanesOf& operator+=(const LanesOf& b) {
    return *this = *this + b;
  }
  CONTACT_LANE LanesOf& operator-=(const LanesOf& b) {
    return *this = *this - b;
  }
  CONTACT_LANE LanesOf& operator*=(const LanesOf& b) {
    return *this = *this * b;
  }

#if defined(__AVX512VL__)
#define CONTACT_LANE_COMPARISON(op, code)                               \
  friend CONTACT_LANE mask_type operator op(const LanesOf& a,           \
                                            const LanesOf& b) {         \
    if constexpr (n == 8) {                                             \
      return mask_type(_mm512_cmp_pd_mask(a.native_, b.native_, code)); \
    } else if constexpr (n == 4) {                                      \
      return mask_type(_mm256_cmp_pd_mask(a.native_, b.native_, code)); \
    } else {                                                            \
      static_assert(n == 2);                                            \
      return mask_type(_mm_cmp_pd_mask(a.native_, b.native_, code));    \
    }                                                                   \
  }
#else
#define CONTACT_LANE_COMPARISON(op, code)                                   \
  friend CONTACT_LANE mask_type operator op(const LanesOf& a,               \
                                            const LanesOf& b) {             \
    return mask_type(                                                       \
        std::bit_cast<typename mask_type::Native>(a.native_ op b.native_)); \
  }
#endif
  CONTACT_LANE_COMPARISON(<, _CMP_LT_OS)
  CONTACT_LANE_COMPARISON(<=, _CMP_LE_OS)
  CONTACT_LANE_COMPARISON(>, _CMP_GT_OS)
  CONTACT_LANE_COMPARISON(>=, _CMP_GE_OS)
  CONTACT_LANE_COMPARISON(==, _CMP_EQ_OQ)
  CONTACT_LANE_COMPARISON(!=, _CMP_NEQ_UQ)
#undef CONTACT_LANE_COMPARISON

  /// condition ? a : b
  friend CONTACT_LANE LanesOf select(const mask_type& condition,
                                     const LanesOf& a, const LanesOf& b) {
#if defined(__AVX512VL__)
    const auto k = condition.native();
    if constexpr (n == 8) {
      return LanesOf(_mm512_mask_blend_pd(k, b.native_, a.native_));
    } else if constexpr (n == 4) {
      return LanesOf(_mm256_mask_blend_pd(k, b.native_, a.native_));
    } else {
      return LanesOf(_mm_mask_blend_pd(k, b.native_, a.native_));
    }
#else
#if defined(__AVX2__)
    if constexpr (n == 4) {
      return LanesOf(_mm256_blendv_pd(
          b.native_, a.native_, std::bit_cast<__m256d>(condition.native())));
    }
#endif
    const auto m = std::bit_cast<Bits>(condition.native());
    return of_bits((m & a.bits()) | (~m & b.bits()));
#endif
  }

  friend CONTACT_LANE LanesOf abs(const LanesOf& x) {
    constexpr std::uint64_t sign = std::uint64_t{1} << 63;
    return of_bits(x.bits() & ~sign);
  }
  friend CONTACT_LANE LanesOf sqrt(const LanesOf& x) {
#if defined(__AVX512VL__)
    if constexpr (n == 8) return LanesOf(_mm512_sqrt_pd(x.native_));
#endif
#if defined(__AVX2__)
    if constexpr (n == 4) return LanesOf(_mm256_sqrt_pd(x.native_));
#endif
#if defined(__SSE2__)
    if constexpr (n == 2) return LanesOf(_mm_sqrt_pd(x.native_));
#endif
    return LanesOf([&](auto i) { return std::sqrt(x[i]); });
  }
  /// b where they are not comparable.
  friend CONTACT_LANE LanesOf max(const LanesOf& a, const LanesOf& b) {
    return LanesOf(a.native_ > b.native_ ? a.native_ : b.native_);
  }
  friend CONTACT_LANE LanesOf min(const LanesOf& a, const LanesOf& b) {
    return LanesOf(a.native_ < b.native_ ? a.native_ : b.native_);
  }

  /// Sum, maximum and minimum of the lanes, by halves.
  friend CONTACT_LANE double reduce(const LanesOf& x) {
    return x.folded([](const auto& a, const auto& b) { return a + b; });
  }
  friend CONTACT_LANE double hmax(const LanesOf& x) {
    return x.folded([](const auto& a, const auto& b) { return max(a, b); });
  }
  friend CONTACT_LANE double hmin(const LanesOf& x) {
    return x.folded([](const auto& a, const auto& b) { return min(a, b); });
  }

  CONTACT_LANE Bits bits() const { return std::bit_cast<Bits>(native_); }
  CONTACT_LANE static LanesOf of_bits(Bits bits) {
    return LanesOf(std::bit_cast<Native>(bits));
  }

  template <class Fold>
  CONTACT_LANE double folded(const Fold& fold) const {
    if constexpr (n == 1) {
      return native_[0];
    } else {
      using Half = LanesOf<n / 2, set>;
      const auto half = [&]<int... i>(std::integer_sequence<int, i...>,
                                      auto from)
          __attribute__((always_inline)) {
        constexpr int first = decltype(from)::value;
        return Half(__builtin_shufflevector(native_, native_, (first + i)...));
      };
      constexpr std::make_integer_sequence<int, n / 2> lanes;
      return fold(half(lanes, std::integral_constant<int, 0>()),
                  half(lanes, std::integral_constant<int, n / 2>()))
          .folded(fold);
    }
  }

 private:
  Native native_;
};

#undef CONTACT_LANE

}  // namespace contact::detail
