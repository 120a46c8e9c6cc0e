#pragma once

// clang-format off
/// Made by the program fit-half-angle (reference/half_angle_fit.hpp); do not
/// edit. Largest relative error of theta0 on the pairs of the fit above each.
namespace contact::detail {

struct NominalCoefficients {
  double limit_deg[4];
  double n1[3], n2[3], d1[3], d2[3];
};

// 0.014 %
inline constexpr double fitted_pin[2][5] = {
    {1.71715, -2.23107, 1.69503, -0.96949, 1.76534},
    {-0.00463, 0.05114, -0.40449, 0.78042, -0.44312},
};

// 0.047 %
inline constexpr NominalCoefficients nominal_pin = {
    {84.80845, -5.62280, 1.60328, -0.49539},
    {0.77254, 0.14909, -0.20077},
    {1.61560, 1.87188, 0.43558},
    {0.75297, -0.19733, -0.14268},
    {2.91608, 1.87864, 0.19127},
};

// 0.052 %
inline constexpr double fitted_ball[4][5] = {
    {0.42771, -14.42985, 80.50784, -134.90922, 71.51040},
    {-0.73841, 47.72394, -216.29652, 342.46484, -181.86849},
    {1.24292, -11.49862, 39.68878, -58.23126, 30.50361},
    {-1.53020, 20.00189, -79.38203, 124.87314, -68.55837},
};

// 0.085 %
inline constexpr NominalCoefficients nominal_ball = {
    {88.01806, -4.64839, 0.24033, -0.05768},
    {-0.16445, -0.16332, 0.05132},
    {0.45386, -0.01511, -0.00282},
    {-0.12589, -0.11174, 0.04978},
    {1.08322, 0.02676, -0.01391},
};

}  // namespace contact::detail
