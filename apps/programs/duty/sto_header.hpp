#pragma once

#include <cstddef>
#include <optional>
#include <string>

#include "cli/stream/points.hpp"

namespace hinge_duty {

/// Header of an OpenSim table (.sto, .mot): lines `key=value`, keys in upper or
/// lower case, `endheader`, then column names separated by tabs.
struct StoHeader {
  /// inDegrees; radians if absent, as OpenSim reads old files.
  std::optional<bool> in_degrees;
  std::optional<double> rows;
  cli::PointHeader columns;
};

/// Throws contact::Error without `endheader`, or if nColumns differs from the
/// number of names.
StoHeader read_sto_header(cli::LineReader& reader);

/// Throws contact::Error if nRows differs from the number of rows.
void check_sto_rows(const StoHeader& header, std::size_t rows,
                    const std::string& name);

}  // namespace hinge_duty
