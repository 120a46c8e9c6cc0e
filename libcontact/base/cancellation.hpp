#pragma once

namespace contact::detail {

/// (x - sin x)/x^3, 1/6 at 0; even. |x| <= 2 pi. Relative error at most 4e-16
/// (pressure/cosine_test.cpp).
double x_minus_sin_over_cube(double x);

/// (sin x - x cos x)/x^3, 1/3 at 0; even. |x| <= pi. Relative error at most
/// 1e-15 (pressure/cosine_test.cpp).
double sin_minus_x_cos_over_cube(double x);

}  // namespace contact::detail
