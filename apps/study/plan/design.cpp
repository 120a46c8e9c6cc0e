#include "study/plan/design.hpp"

#include <fmt/format.h>

#include <boost/math/distributions/normal.hpp>
#include <boost/random/sobol.hpp>
#include <cmath>
#include <set>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace study {

Design::Design(const Plan& plan, const std::vector<int>& copies) : plan_(plan) {
  for (const std::string& factor : plan.factors) {
    sources_.push_back("factor " + factor);
  }
  for (std::size_t i = 0; i < plan.dispersions.size(); ++i) {
    const std::string& key = plan.dispersions[i].key;
    if (copies[i] == 0) draws_.push_back({key, i, 0});
    for (int copy = 1; copy <= copies[i]; ++copy) {
      draws_.push_back({fmt::format("{}@{}", key, copy), i, copy});
    }
  }
  for (const Draw& draw : draws_) sources_.push_back(draw.name);
  std::set<std::uint64_t> hashes;
  for (const std::string& source : sources_) {
    streams_.emplace_back(plan.seed, source);
    if (hashes.insert(hash_of(source)).second) continue;
    throw contact::Error("two keys have the same numbers: " + source);
  }
  if (plan.sampling == Sampling::saltelli && plan.runs % group() != 0) {
    throw contact::Error(contact::detail::must_be(
        fmt::format("runs = {} with sampling = \"saltelli\"", plan.runs),
        fmt::format("a multiple of {}: 2 and one for each of {} inputs",
                    group(), sources_.size())));
  }
}

// Coordinates of a point of the sequence, scrambled by shifts of their digits.
std::vector<double> Design::sobol(std::uint64_t point, std::size_t from) const {
  const bool two = plan_.sampling == Sampling::saltelli;
  boost::random::sobol engine((two ? 2 : 1) * sources_.size());
  engine.discard(point * (two ? 2 : 1) * sources_.size() + from);
  std::vector<double> result;
  for (const Stream& stream : streams_) {
    result.push_back(uniform_of(engine() ^ stream.bits(from)));
  }
  return result;
}

std::vector<double> Design::uniforms(std::uint64_t run) const {
  const std::size_t count = sources_.size();
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
      result = sobol(run - 1, 0);
      break;
    case Sampling::saltelli: {
      const std::uint64_t point = (run - 1) / group();
      const std::size_t place = (run - 1) % group();
      if (place == 1) return sobol(point, count);
      result = sobol(point, 0);
      if (place > 1) result[place - 2] = sobol(point, count)[place - 2];
    }
  }
  return result;
}

// A draw with factors is that of its normal score, to which they add.
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
