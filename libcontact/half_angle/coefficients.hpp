#pragma once

// clang-format off
/// Made by the program fit-half-angle (reference/half_angle_fit.hpp); do not
/// edit. Largest relative error of theta0 on the pairs of the fit above each.
namespace contact::detail {

// 0.014 %
inline constexpr double fitted_pin[2][5] = {
    {1.71715, -2.23107, 1.69503, -0.96949, 1.76534},
    {-0.00463, 0.05114, -0.40449, 0.78042, -0.44312},
};

// 0.052 %
inline constexpr double fitted_ball[4][5] = {
    {0.42771, -14.42985, 80.50784, -134.90922, 71.51040},
    {-0.73841, 47.72394, -216.29652, 342.46484, -181.86849},
    {1.24292, -11.49862, 39.68878, -58.23126, 30.50361},
    {-1.53020, 20.00189, -79.38203, 124.87314, -68.55837},
};

}  // namespace contact::detail
