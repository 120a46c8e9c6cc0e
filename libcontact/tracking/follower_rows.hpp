#pragma once

/// What JointFollower keeps of its joints: rows of numbers, one for each
/// joint, padded so that lanes may run over joints.
namespace contact::detail {

enum class FollowerRow : int {
  // R and Dw.
  reaction_x,
  reaction_y,
  reaction_z,
  rate_x,
  rate_y,
  rate_z,
  // M_t for R; the one that acts, and what it last changed by.
  moment_x,
  moment_y,
  moment_z,
  acting_x,
  acting_y,
  acting_z,
  action_x,
  action_y,
  action_z,
  // 1 or 0.
  followed,
  // Constants: s of docs/joint.md (7), 0 for a pin, 0 for dry friction.
  radius,
  side,
  ball,
  viscous,
  // s where R has s z x M_t in it.
  feedback,
  // 1 for the exact integrals alone; JointContact::Strength at speed 1.
  plain,
  pressure_part,
  area_part,
  // The last solution: 1/R, sine and cosine of b, tan psi, ln tan psi less that
  // of the contact that was evaluated, speed (1 if dry).
  last_inverse_reaction,
  last_sine,
  last_cosine,
  last_tangent,
  last_residual,
  last_speed,
  // The last contact that was evaluated: 1/R_n, 1/cos a; f/cos a, c_Y/cos a,
  // c_Z/sin a, for the speed 1 if viscous, and the slopes of their logarithms
  // over ln R_n and ln cos^2 a.
  last_inverse_force,
  last_inverse_axis_cosine,
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
  // How they change: over ln R and b; dln tan psi over d(residual).
  tangent_by_along,
  tangent_by_tilt,
  force_by_along,
  force_by_tilt,
  cosine_by_along,
  cosine_by_tilt,
  sine_by_along,
  sine_by_tilt,
  inverse_slope,
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
  // Where R is now, in the first two directions; where it was when the contact
  // was evaluated.
  along,
  tilt,
  evaluated_along,
  evaluated_tilt,
  // The contact to be evaluated, and what is found.
  evaluated_force,
  evaluated_axis_sine,
  evaluated_axis_cosine,
  half_angle_sin,
  half_angle_cos,
  integral_force,
  integral_sliding,
  integral_spinning,
  integral_force_area,
  integral_sliding_area,
  integral_spinning_area,
  found_friction,
  found_sliding,
  found_spinning,
  // What M_t may be wrong by, relative: where it was evaluated, and for R.
  evaluated_error,
  error,
  // The acting moment kept last, and its change from the one before.
  kept_x,
  kept_y,
  kept_z,
  stretch_x,
  stretch_y,
  stretch_z,
  // What the acting moment missed before it last changed, and what M_t answers
  // to its changes, by columns.
  missed_x,
  missed_y,
  missed_z,
  answer_xx,
  answer_yx,
  answer_zx,
  answer_xy,
  answer_yy,
  answer_zy,
  answer_xz,
  answer_yz,
  answer_zz,
  // Functions of R_n near its value, see FollowerWindow: middle, 1/half width,
  // where R_n is in it; coefficients.
  window_middle,
  window_scale,
  window_place,
  window_1,
  window_1_last = window_1 + 11,
  window_2,
  window_2_last = window_2 + 11,
  // |move of R| from the place, over R sin b; how far the last evaluation is,
  // of FollowerReach: beyond 1 (or NaN) nothing is known.
  shift,
  reach,
  sensitivity,
  count,
};

/// How far series and slopes are good for: moves of R, b, R_n, ...; 1/sin b.
struct FollowerReach {
  static constexpr double move = 0.1;
  static constexpr double inverse_sine = 100;
};

/// What a joint has as a function of R_n alone, sin theta0 and cos theta0 of a
/// ball, friction and sliding moment of a pin, as polynomials in a narrow
/// window of R_n, through the values at these places (Chebyshev's, in an order
/// that keeps rounding small). The window is so narrow that powers do: their
/// coefficients fall off like 0.1^k.
struct FollowerWindow {
  static constexpr int size = 12;
  static constexpr double half_width = 0.1;  // of R_n
  static constexpr double nodes[size] = {
      0.991445,  -0.991445, -0.130526, 0.608761, -0.608761, 0.382683,
      -0.793353, 0.92388,   -0.382683, -0.92388, 0.793353,  0.130526};
};
static_assert(static_cast<int>(FollowerRow::window_1_last) -
                  static_cast<int>(FollowerRow::window_1) ==
              FollowerWindow::size - 1);

/// Joints in packets of lanes, the rows of one packet next to each other.
class FollowerRows {
 public:
  static constexpr unsigned lanes = 8;
  static constexpr auto count = static_cast<unsigned>(FollowerRow::count);

  explicit FollowerRows(double* numbers) : numbers_(numbers) {}
  /// Of a joint and those after it in its packet.
  double* at(FollowerRow row, int joint) const {
    const auto j = static_cast<unsigned>(joint);
    return numbers_ + (j / lanes * count + static_cast<unsigned>(row)) * lanes +
           j % lanes;
  }
  double& operator()(FollowerRow row, int joint) const {
    return *at(row, joint);
  }

 private:
  double* numbers_;
};

}  // namespace contact::detail
