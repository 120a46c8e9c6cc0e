#include "libcontact/base/number.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <string>
#include <system_error>
#include <vector>

namespace contact::detail {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// As the standard has std::from_chars, by libraries with and without it.
TEST(Number, ReadsAsFromCharsDoes) {
  struct Row {
    std::string text;
    double value;
    int taken;
  };
  const std::vector<Row> rows = {
      {"0.1", 0.1, 3},
      {"-2.5e-3", -2.5e-3, 7},
      {"1.5e3xyz", 1500, 5},
      {"5.", 5, 2},
      {".5", 0.5, 2},
      {"1e", 1, 1},
      {"1e+", 1, 1},
      {"1,5", 1, 1},
      {"0x1p3", 0, 1},
      {"-0x", -0.0, 2},
      {"0e999", 0, 5},
      {"-0", -0.0, 2},
      {"INF", infinity, 3},
      {"-infinity", -infinity, 9},
      {"infin", infinity, 3},
      {"2.2250738585072014e-308", std::numeric_limits<double>::min(), 23},
      {"4.9406564584124654e-324", 4.9406564584124654e-324, 23},
      {"1.7976931348623157e308", std::numeric_limits<double>::max(), 22},
      // Halfway between two doubles, and a digit above: to even, and up.
      {"9007199254740993", 9007199254740992.0, 16},
      {"9007199254740993.00001", 9007199254740994.0, 22}};
  for (const Row& row : rows) {
    double value = 7;
    const char* const first = row.text.data();
    const auto [stop, error] =
        number_from(first, first + row.text.size(), value);
    EXPECT_EQ(error, std::errc()) << row.text;
    EXPECT_EQ(stop - first, row.taken) << row.text;
    EXPECT_EQ(value, row.value) << row.text;
    EXPECT_EQ(std::signbit(value), std::signbit(row.value)) << row.text;
  }
}

TEST(Number, RefusesWhatIsNone) {
  for (const std::string text : {"", "-", "+1", " 1", "\t1", "-.", ".e1", "--1",
                                 "- 1", "e5", "x", "-inx"}) {
    double value = 7;
    const char* const first = text.data();
    const auto [stop, error] = number_from(first, first + text.size(), value);
    EXPECT_EQ(error, std::errc::invalid_argument) << text;
    EXPECT_EQ(stop, first) << text;
    EXPECT_EQ(value, 7) << text;
    EXPECT_FALSE(number_in(text)) << text;
  }
}

TEST(Number, BeyondDoublesIsOutOfRange) {
  for (const std::string text : {"1e400", "-1e400", "1e-400", "0.001e-400"}) {
    double value = 7;
    const char* const first = text.data();
    const auto [stop, error] = number_from(first, first + text.size(), value);
    EXPECT_EQ(error, std::errc::result_out_of_range) << text;
    EXPECT_EQ(stop - first, std::ssize(text)) << text;
    EXPECT_EQ(value, 7) << text;
  }
}

TEST(Number, InATextIsTheWholeOfIt) {
  EXPECT_EQ(number_in("1e3"), 1000);
  EXPECT_TRUE(std::isnan(number_in("nan").value()));
  EXPECT_FALSE(number_in("1e3 "));
  EXPECT_FALSE(number_in("1x"));
}

}  // namespace
}  // namespace contact::detail
