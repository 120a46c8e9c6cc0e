#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "study/plan/draws.hpp"
#include "study/plan/plan.hpp"

namespace study {

/// A number that is drawn: of a dispersion, or of one copy of it.
struct Draw {
  std::string name;   ///< the key; of the second copy "KEY@2"
  std::string label;  ///< the key, with the copy's name for people
  std::size_t dispersion;
  int copy;  ///< from 1; 0: of all
};

/// Numbers of each run. Run 0 is the nominal one and has none.
class Design {
 public:
  /// @param copies  names of each dispersion's; none: one draw for all
  /// @throws contact::Error if the runs do not fit the sampling
  Design(const Plan& plan, const std::vector<std::vector<std::string>>& copies);

  const std::vector<Draw>& draws() const { return draws_; }
  /// Independent sources of scatter: the factors, then the draws.
  const std::vector<std::string>& sources() const { return sources_; }
  /// A source's name for people.
  const std::string& source_label(std::size_t source) const {
    const std::size_t factors = plan_.factors.size();
    return source < factors ? sources_[source] : draws_[source - factors].label;
  }

  /// In (0, 1), one of each source.
  std::vector<double> uniforms(std::uint64_t run) const;
  /// Numbers of the draws.
  std::vector<double> numbers(std::uint64_t run) const {
    return numbers_of(uniforms(run));
  }
  std::vector<double> numbers_of(const std::vector<double>& uniforms) const;
  /// Number of a draw that is not pushed by factors.
  double number(std::size_t draw, double u) const {
    return plan_.dispersions[draws_[draw].dispersion].quantile(u);
  }
  /// Runs of a group of Saltelli's design: A, B, and A with a column of B for
  /// each source.
  std::size_t group() const { return sources_.size() + 2; }
  /// Group i of that design is a point of the sequence in shift i % shifts. The
  /// shifts are independent of each other, points in one of them are not.
  static constexpr std::size_t shifts = 8;

  /// Whatever the numbers depend on beside the dispersions.
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
