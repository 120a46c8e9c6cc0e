#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "cli/stream/points.hpp"

namespace hinge_duty {

/// The head of an OpenSim table (.sto, .mot): lines `key=value`, keys in any
/// case, `endheader`, the names of the columns with tabs.
struct StoHeader {
  /// inDegrees; without it radians, as OpenSim reads old files.
  std::optional<bool> in_degrees;
  std::optional<double> rows;
  cli::PointHeader columns;
};

/// Throws contact::Error without `endheader` or if nColumns is not the number
/// of names.
StoHeader read_sto_header(cli::LineReader& reader);

/// Throws contact::Error if nRows says another number.
void check_sto_rows(const StoHeader& header, std::size_t rows,
                    const std::string& name);

}  // namespace hinge_duty
