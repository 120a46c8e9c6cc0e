#pragma once

#include <cstddef>

/// What JointFollower keeps of its joints: rows of numbers, one for each
/// joint, padded so that lanes may run over joints.
namespace contact::detail {

enum class FollowerRow : std::size_t {
  // Constants: s of docs/joint.md (7), 0 for a pin, 0 for dry friction.
  radius,
  side,
  ball,
  viscous,
  // R and Dw.
  reaction_x,
  reaction_y,
  reaction_z,
  rate_x,
  rate_y,
  rate_z,
  // The last solution: R, sine and cosine of b, tan psi, speed (1 if dry).
  last_reaction,
  last_sine,
  last_cosine,
  last_tangent,
  last_speed,
  // The last contact that was evaluated: R_n, cos a; f/cos a, c_Y/cos a,
  // c_Z/sin a, for the speed 1 if viscous, and the slopes of their logarithms
  // over ln R_n and ln cos^2 a.
  last_force,
  last_axis_cosine,
  friction,
  sliding,
  spinning,
  friction_by_force,
  friction_by_cosine,
  sliding_by_force,
  sliding_by_cosine,
  spinning_by_force,
  spinning_by_cosine,
  // The way from the evaluation before to the last one, direction and length;
  // half the second derivatives of the logarithms along it.
  way_force,
  way_cosine,
  way_length,
  friction_curve,
  sliding_curve,
  spinning_curve,
  // How wrong slopes have lately been.
  slope_error,
  // The place of the last prediction: R, tan psi, R_n, sine and cosine of b
  // and a, and the moves of the contact since the last evaluation.
  place_x,
  place_y,
  place_z,
  place_reaction,
  place_sine,
  place_cosine,
  place_speed,
  tangent,
  force,
  axis_sine,
  axis_cosine,
  force_move,
  cosine_move,
  // How they change: over ln R and b; d(residual) over dln tan psi.
  tangent_by_along,
  tangent_by_tilt,
  force_by_along,
  force_by_tilt,
  cosine_by_along,
  cosine_by_tilt,
  sine_by_along,
  sine_by_tilt,
  residual_slope,
  // How the contact and the moment answer to ln tan psi: sin psi, moves.
  sin_psi,
  sliding_share,
  spinning_share,
  force_by_tangent,
  cosine_by_tangent,
  // M_t at the place, and what it grows by when R moves along e and across it
  // in the plane of Dw (both over R), and normal to that (over R sin b), and
  // when ln tan psi, ln c_Y and ln c_Z grow.
  base_x,
  base_y,
  base_z,
  along_x,
  along_y,
  along_z,
  tilt_x,
  tilt_y,
  tilt_z,
  turn_x,
  turn_y,
  turn_z,
  by_along_x,
  by_along_y,
  by_along_z,
  by_tilt_x,
  by_tilt_y,
  by_tilt_z,
  by_turn_x,
  by_turn_y,
  by_turn_z,
  by_tangent_x,
  by_tangent_y,
  by_tangent_z,
  by_sliding_x,
  by_sliding_y,
  by_sliding_z,
  by_spinning_x,
  by_spinning_y,
  by_spinning_z,
  // Where R is now, in these three directions; where it was when the contact
  // was evaluated.
  along,
  tilt,
  turn,
  evaluated_along,
  evaluated_tilt,
  // The contact to be evaluated, and what is found.
  evaluated_force,
  evaluated_axis_sine,
  evaluated_axis_cosine,
  found_friction,
  found_sliding,
  found_spinning,
  // M_t for R.
  moment_x,
  moment_y,
  moment_z,
  // What M_t may be wrong by, relative: where it was evaluated, and for R.
  evaluated_error,
  error,
  // |move of R| from the place, over R sin b; largest move from the last
  // evaluation: of large ones (or NaN) nothing is known.
  shift,
  move,
  sensitivity,
  count,
};

class FollowerRows {
 public:
  static constexpr std::size_t lanes = 8;

  FollowerRows(double* numbers, std::size_t stride)
      : numbers_(numbers), stride_(stride) {}
  double* operator[](FollowerRow row) const {
    return numbers_ + static_cast<std::size_t>(row) * stride_;
  }

 private:
  double* numbers_;
  std::size_t stride_;
};

}  // namespace contact::detail
