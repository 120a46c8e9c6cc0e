#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "cli/number.hpp"
#include "libcontact/base/dimension.hpp"

namespace cli {

/// The values of an option that takes a value, a comma-separated list,
/// start:stop:step or start:stop:logN (also as items of a list). Values are
/// computed on demand, so a long sweep takes no memory.
///
/// start:stop:step includes the stop when it lies on a step. Decimal inputs
/// are stepped as exact decimals, so 0:1:0.1 holds 0.3 and not
/// 0.30000000000000004. start:stop:logN gives N values in equal ratios, both
/// ends included, round powers of ten exactly. Each number may carry a unit
/// (quantity.hpp), if all but 0 do: 1kN:10kN:log5.
class Sweep {
 public:
  /// @param option   name for messages, such as "--theta0"
  /// @param text     what the user wrote
  /// @param allowed  interval that every value must lie in
  /// Throws contact::Error for a bad text or a value that is not allowed.
  Sweep(std::string_view option, std::string_view text, const Allowed& allowed,
        contact::Dimension dimension = contact::Dimension::number);

  std::size_t size() const { return pieces_.back().end; }
  /// Value number `index`, from 0 to size() - 1.
  double operator[](std::size_t index) const;
  /// True for a single start:stop:logN range: use a logarithmic axis.
  bool is_logarithmic() const {
    return pieces_.size() == 1 && pieces_[0].kind == Kind::logarithmic;
  }

 private:
  enum class Kind { linear, logarithmic };
  /// x_i = (start + i step)/scale or 10^x_i, i = 0, 1, ... count - 1; both ends
  /// exactly as given.
  struct Piece {
    Kind kind = Kind::linear;
    double start = 0;
    double step = 0;
    double scale = 1;
    double first = 0;
    double last = 0;
    std::size_t count = 1;
    std::size_t end = 0;  ///< number of values up to the end of this piece
    double value(std::size_t i) const;
  };
  static Piece parse_piece(std::string_view option, std::string_view text,
                           contact::Dimension dimension);
  static Piece linear(double start, double stop, double step);
  static Piece logarithmic(double start, double stop, double count);

  std::vector<Piece> pieces_;
};

/// The values of a sweep of whole numbers from 1 to `most`.
/// @throws contact::Error for other values
std::vector<int> whole_numbers(std::string_view option, std::string_view text,
                               int most);

/// At most `most` values of a sweep, evenly spread and including both ends, for
/// pictures.
std::vector<double> spread(const Sweep& sweep, std::size_t most);

}  // namespace cli
