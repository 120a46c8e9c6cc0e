#include "study/plan/design.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/math/distributions/normal.hpp>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <set>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace study {

namespace {

// "body[booster 3].mass_kg" of body[booster].mass_kg, and
// "force[push, booster 3].force_N" of a force on that body.
std::string label_of(const std::string& key, const std::string& copy) {
  const auto from = key.find('[') + 1;
  const auto to = std::min(key.find(']'), key.size());
  return key.substr(0, from) +
         (key.starts_with("body[")
              ? copy
              : key.substr(from, to - from) + ", " + copy) +
         key.substr(to);
}

}  // namespace

Design::Design(const Plan& plan,
               const std::vector<std::vector<std::string>>& copies)
    : plan_(plan) {
  for (const std::string& factor : plan.factors) {
    sources_.push_back("factor " + factor);
  }
  for (std::size_t i = 0; i < plan.dispersions.size(); ++i) {
    const std::string& key = plan.dispersions[i].key;
    if (copies[i].empty()) draws_.push_back({key, key, i, 0});
    int number = 0;
    for (const std::string& copy : copies[i]) {
      ++number;
      draws_.push_back(
          {fmt::format("{}@{}", key, number), label_of(key, copy), i, number});
    }
  }
  for (const Draw& draw : draws_) sources_.push_back(draw.name);
  std::set<std::uint64_t> hashes;
  for (const std::string& source : sources_) {
    streams_.emplace_back(plan.seed, source);
    if (hashes.insert(hash_of(source)).second) continue;
    throw contact::Error("two keys have the same numbers: " + source);
  }
  if (plan.sampling == Sampling::saltelli &&
      plan.runs % (shifts * group()) != 0) {
    throw contact::Error(contact::detail::must_be(
        fmt::format("runs = {} with sampling = \"saltelli\"", plan.runs),
        fmt::format("a multiple of {}: {} shifts of 2 runs and one for each "
                    "of {} inputs",
                    shifts * group(), shifts, sources_.size())));
  }
}

// Coordinates of a point of the sequence, scrambled by digital shifts: one half
// of them if the sequence has two for each source.
std::vector<double> Design::sobol(std::uint64_t point, Half half,
                                  std::uint64_t shift) const {
  const std::size_t count = sources_.size();
  const std::size_t size =
      plan_.sampling == Sampling::saltelli ? 2 * count : count;
  const std::size_t from = half == Half::a ? 0 : count;
  boost::random::sobol engine(size);
  // Boost omits the origin, without which 2^k points are not balanced.
  if (point > 0) engine.discard((point - 1) * size + from);
  std::vector<double> result;
  for (const Stream& stream : streams_) {
    const std::uint64_t digits = point > 0 ? engine() : 0;
    const std::uint64_t counter = 2 * shift + (half == Half::a ? 0 : 1);
    result.push_back(uniform_of(digits ^ stream.bits(counter)));
  }
  return result;
}

// Assigns groups to the shifts in turn, so that the first groups stay the same
// if runs are added.
std::vector<double> Design::saltelli(std::uint64_t run) const {
  const std::uint64_t shift = (run - 1) / group() % shifts;
  const std::uint64_t point = (run - 1) / group() / shifts;
  const std::size_t place = (run - 1) % group();
  if (place == 1) return sobol(point, Half::b, shift);
  std::vector<double> result = sobol(point, Half::a, shift);
  if (place > 1) {
    result[place - 2] = sobol(point, Half::b, shift)[place - 2];
  }
  return result;
}

std::vector<double> Design::uniforms(std::uint64_t run) const {
  std::vector<double> result;
  switch (plan_.sampling) {
    case Sampling::random:
      for (const Stream& stream : streams_) {
        result.push_back(stream.uniform(run));
      }
      break;
    case Sampling::latin_hypercube:
      for (const Stream& stream : streams_) {
        const auto cell =
            static_cast<double>(stream.permuted(run - 1, plan_.runs));
        result.push_back((cell + stream.uniform(run)) /
                         static_cast<double>(plan_.runs));
      }
      break;
    case Sampling::sobol:
      return sobol(run - 1, Half::a, 0);
    case Sampling::saltelli:
      return saltelli(run);
  }
  return result;
}

std::string Design::identity() const {
  std::string text =
      fmt::format("{} {}", static_cast<int>(plan_.sampling), plan_.seed);
  switch (plan_.sampling) {
    case Sampling::random:
      break;
    case Sampling::latin_hypercube:  // with as many cells
      text += fmt::format(" {}", plan_.runs);
      break;
    case Sampling::sobol:
    case Sampling::saltelli:
      // Increase this number whenever the points of a run change.
      text += " points 2";
  }
  return text;
}

// A draw with factors is given by its normal score, to which the factors add.
std::vector<double> Design::numbers_of(
    const std::vector<double>& uniforms) const {
  const boost::math::normal normal;
  const std::size_t factors = plan_.factors.size();
  std::vector<double> result;
  for (std::size_t i = 0; i < draws_.size(); ++i) {
    const Dispersion& dispersion = plan_.dispersions[draws_[i].dispersion];
    double u = uniforms[factors + i];
    if (!dispersion.shares.empty()) {
      double score = 0;
      double own = 1;
      for (const auto& [factor, loading] : dispersion.shares) {
        score += loading * quantile(normal, uniforms[factor]);
        own -= loading * loading;
      }
      score += std::sqrt(std::max(0.0, own)) * quantile(normal, u);
      u = std::clamp(cdf(normal, score), lowest_uniform, highest_uniform);
    }
    result.push_back(dispersion.quantile(u));
  }
  return result;
}

}  // namespace study
