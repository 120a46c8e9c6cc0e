#include "support/accuracy_report.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>

namespace contact::test {

void AccuracyReport::add_error(double error, const std::string& label) {
  if (std::isnan(error)) error = std::numeric_limits<double>::infinity();
  if (count_ == 0 || error > max_) {
    max_ = error;
    worst_ = label;
  }
  sum_of_squares_ += error * error;
  ++count_;
}

double AccuracyReport::rms() const {
  return std::sqrt(sum_of_squares_ / static_cast<double>(count_));
}

void AccuracyReport::check() {
  is_checked_ = true;
  if (count_ == 0 && may_be_empty_) return;
  std::printf("%-24s %6zu rows  max %8.2e  rms %8.2e  budget %8.2e  worst %s\n",
              quantity_.c_str(), count_, max_, rms(), budget_, worst_.c_str());
  char text[64];
  std::snprintf(text, sizeof text, "max %.3e rms %.3e", max_, rms());
  testing::Test::RecordProperty(quantity_, text);
  EXPECT_GT(count_, 0u) << quantity_ << ": no row was compared";
  EXPECT_LE(max_, budget_) << quantity_ << ", worst row: " << worst_;
}

}  // namespace contact::test
