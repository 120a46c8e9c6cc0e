#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/plan/draws.hpp"
#include "study/plan/plan.hpp"

namespace study {

/// A random number: of a dispersion, or of one copy of it.
struct Draw {
  std::string name;   ///< the key; for the second copy "KEY@2"
  std::string label;  ///< the key and the copy's name, for people
  std::size_t dispersion;
  int copy;  ///< from 1; 0: all copies
};

/// Random numbers of each run. Run 0 is the nominal run and has none.
class Design {
 public:
  /// @param copies  names of each dispersion's copies; empty: one draw for all
  /// @throws contact::Error if the number of runs does not suit the sampling
  Design(const Plan& plan, const std::vector<std::vector<std::string>>& copies);

  const std::vector<Draw>& draws() const { return draws_; }
  /// Independent sources of scatter: first the factors, then the draws.
  const std::vector<std::string>& sources() const { return sources_; }
  /// A source's name for people.
  const std::string& source_label(std::size_t source) const {
    const std::size_t factors = plan_.factors.size();
    return source < factors ? sources_[source] : draws_[source - factors].label;
  }

  /// Uniform numbers in (0, 1), one for each source.
  std::vector<double> uniforms(std::uint64_t run) const;
  /// Numbers of the draws.
  std::vector<double> numbers(std::uint64_t run) const {
    return numbers_of(uniforms(run));
  }
  std::vector<double> numbers_of(const std::vector<double>& uniforms) const;
  /// Value of a draw that no factor affects.
  double number(std::size_t draw, double u) const {
    return plan_.dispersions[draws_[draw].dispersion].quantile(u);
  }
  /// Number of runs in a group of Saltelli's design: A, B, and A with a column
  /// of B for each source.
  std::size_t group() const { return sources_.size() + 2; }
  /// Group i of that design is a point of the sequence with shift i % shifts.
  /// Different shifts are independent; points with the same shift are not.
  static constexpr std::size_t shifts = 8;

  /// Identifies everything but the dispersions that affects the numbers.
  std::string identity() const;

 private:
  enum class Half { a, b };
  std::vector<double> sobol(std::uint64_t point, Half half,
                            std::uint64_t shift) const;
  std::vector<double> saltelli(std::uint64_t run) const;

  const Plan& plan_;
  std::vector<Draw> draws_;
  std::vector<std::string> sources_;
  std::vector<Stream> streams_;
};

}  // namespace study
