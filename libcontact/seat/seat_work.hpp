#pragma once

#include "libcontact/seat/friction.hpp"
#include "libcontact/seat/joint.hpp"

namespace contact::detail {

/// A contact that was found, with what friction needs of it.
struct SeatWork {
  SeatState state;
  SeatHarmonics harmonics;
  const SeatBasis* basis = nullptr;
  int evaluations = 0;
};

}  // namespace contact::detail
