#pragma once

#include <cstdint>
#include <string_view>

namespace study {

/// Random numbers that depend only on a seed, a key and a run (Philox 4x32 of
/// Random123, libcontact/docs/reference/references.md#salmon-2011). They are
/// the same on any machine, in any order and thread, and a further key does not
/// change the numbers of the others.
class Stream {
 public:
  Stream(std::uint64_t seed, std::string_view key);

  /// Uniform in (0, 1): an odd multiple of 2^-53, so that 1 - u is one too.
  double uniform(std::uint64_t run) const;
  /// 64 random bits.
  std::uint64_t bits(std::uint64_t counter) const;
  /// Position of i in a random permutation of 0 ... n - 1.
  std::uint64_t permuted(std::uint64_t i, std::uint64_t n) const;

 private:
  std::uint64_t seed_;
  std::uint64_t key_;
};

/// The odd multiple of 2^-53 in (0, 1) given by the upper bits.
double uniform_of(std::uint64_t bits);
/// Smallest and largest value of uniform_of().
inline constexpr double lowest_uniform = 0x1p-53;
inline constexpr double highest_uniform = 1 - 0x1p-53;

/// FNV-1a hash.
std::uint64_t hash_of(std::string_view text);

}  // namespace study
