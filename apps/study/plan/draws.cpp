#include "study/plan/draws.hpp"

#include <Random123/philox.h>

#include <bit>

namespace study {
namespace {

// Counters of permuted() are separate from the counters of runs.
constexpr std::uint64_t permutations = std::uint64_t{1} << 63;

}  // namespace

std::uint64_t hash_of(std::string_view text) {
  std::uint64_t hash = 0xcbf29ce484222325;
  for (const char c : text) {
    hash = (hash ^ static_cast<unsigned char>(c)) * 0x100000001b3;
  }
  return hash;
}

double uniform_of(std::uint64_t bits) {
  return (static_cast<double>(bits >> 12) + 0.5) * 0x1p-52;
}

Stream::Stream(std::uint64_t seed, std::string_view key)
    : seed_(seed), key_(hash_of(key)) {}

std::uint64_t Stream::bits(std::uint64_t counter) const {
  const auto low = [](std::uint64_t x) { return static_cast<uint32_t>(x); };
  const auto high = [](std::uint64_t x) {
    return static_cast<uint32_t>(x >> 32);
  };
  const r123::Philox4x32 generator;
  const auto random =
      generator({{low(counter), high(counter), low(key_), high(key_)}},
                {{low(seed_), high(seed_)}});
  return std::uint64_t{random[1]} << 32 | random[0];
}

double Stream::uniform(std::uint64_t run) const {
  return uniform_of(bits(run));
}

// A Feistel network on the next power of four; results outside are passed
// through it again until they are inside.
std::uint64_t Stream::permuted(std::uint64_t i, std::uint64_t n) const {
  constexpr std::uint64_t rounds = 6;
  const auto half = static_cast<unsigned>(std::bit_width(n - 1) + 1) / 2;
  const std::uint64_t mask = (std::uint64_t{1} << half) - 1;
  do {
    std::uint64_t left = i >> half;
    std::uint64_t right = i & mask;
    for (std::uint64_t round = 0; round < rounds; ++round) {
      const std::uint64_t random = bits(permutations | round << 48 | right);
      const std::uint64_t next = left ^ (random & mask);
      left = right;
      right = next;
    }
    i = left << half | right;
  } while (i >= n);
  return i;
}

}  // namespace study
