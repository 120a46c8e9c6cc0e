#include "multibody/motion/step_path.hpp"

#include <algorithm>
#include <array>

namespace multibody {
namespace {

// Newton's form through the ends and points near Chebyshev's between them,
// in an order in which it is exact at the beginning and stable.
constexpr int fit_points = 6;
constexpr std::array<double, fit_points> fit_nodes = {0,     1,     0.345,
                                                      0.905, 0.095, 0.655};

// Divided differences.
void make_coefficients(std::array<double, fit_points>& c) {
  for (int order = 1; order < fit_points; ++order) {
    for (int k = fit_points - 1; k >= order; --k) {
      c[k] = (c[k] - c[k - 1]) / (fit_nodes[k] - fit_nodes[k - order]);
    }
  }
}

}  // namespace

void StepPath::fit() {
  const std::size_t count = stepper_.end_state().size();
  const double begin = stepper_.begin();
  const double h = stepper_.end() - begin;
  coefficients_.resize(fit_points * count);
  state_.resize(count);
  for (int k = 0; k < fit_points; ++k) {
    if (k < 2) {
      std::ranges::copy(k == 0 ? stepper_.begin_state() : stepper_.end_state(),
                        state_.begin());
    } else {
      stepper_.interpolate(begin + fit_nodes[k] * h, state_);
    }
    for (std::size_t i = 0; i < count; ++i) {
      coefficients_[fit_points * i + k] = state_[i];
    }
  }
  std::array<double, fit_points> c;
  for (std::size_t i = 0; i < count; ++i) {
    const auto own = coefficients_.begin() + fit_points * i;
    std::copy_n(own, fit_points, c.begin());
    make_coefficients(c);
    std::ranges::copy(c, own);
  }
  serial_ = stepper_.serial();
}

// Some numbers of the state.
const double* StepPath::numbers(int first, int count, double time) {
  const double begin = stepper_.begin();
  const double h = stepper_.end() - begin;
  if (!(h > 0) || stepper_.degree() < 0 || stepper_.degree() >= fit_points) {
    state_.resize(stepper_.end_state().size());
    stepper_.interpolate(time, state_);
    return &state_[first];
  }
  if (serial_ != stepper_.serial()) fit();
  const double s = (time - begin) / h;
  for (int i = first; i < first + count; ++i) {
    const double* c = &coefficients_[fit_points * i];
    double sum = c[fit_points - 1];
    for (int k = fit_points - 2; k >= 0; --k)
      sum = c[k] + (s - fit_nodes[k]) * sum;
    state_[i] = sum;
  }
  return &state_[first];
}

BodyMotion StepPath::place(int body, double time) {
  if (body == 0) return carrier_at(numbers(0, StateLayout::body_size, time));
  const Link& link = equations_.system.links()[body - 1];
  const JointMode mode = equations_.modes()[body - 1];
  const BodyMotion parent = place(1 + link.parent, time);
  const double* own = numbers(equations_.offset(body - 1),
                              StateLayout::link_size(link.kind, mode), time);
  return body_at(link, mode, own, parent);
}

}  // namespace multibody
