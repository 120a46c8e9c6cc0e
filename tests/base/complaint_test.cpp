#include "libcontact/base/complaint.hpp"

#include <gtest/gtest.h>

#include <vector>

namespace contact::detail {
namespace contact::test::complaint_test {
namespace {

TEST(Complaint, HasOneGrammar) {
  const std::vector<std::string> laws = {"hertz", "arctan", "tanh"};
  EXPECT_EQ(must_be("radius = -50", "above 0"), "radius = -50 must be above 0");
  EXPECT_EQ(unknown("law", "tahn", laws),
            "unknown law \"tahn\": did you mean \"tanh\"? (hertz, arctan, "
            "tanh)");
  EXPECT_EQ(unknown("law", "cubic", laws),
            "unknown law \"cubic\" (hertz, arctan, tanh)");
  EXPECT_EQ(unknown("key", "a.tahn", "tanh", laws),
            "unknown key \"a.tahn\": did you mean \"tanh\"? (hertz, arctan, "
            "tanh)");
  EXPECT_EQ(either(laws), "hertz, arctan or tanh");
  EXPECT_EQ(either(std::vector<std::string>{"one"}), "one");
  EXPECT_EQ(needs("--length", "--joint pin"), "--length requires --joint pin");
  EXPECT_EQ(conflicts("radius_m", "radius_mm", 3),
            "radius_m conflicts with radius_mm (line 3)");
  EXPECT_EQ(conflicts("--x", "--load"), "--x conflicts with --load");
  EXPECT_EQ(duplicate("key", "name", 3, 9),
            "duplicate key name (lines 3 and 9)");
  EXPECT_EQ(duplicate("force", "\"spring\""), "duplicate force \"spring\"");
}

// Names in messages stay on their line.
TEST(Complaint, ShowsNoControlCharacters) {
  EXPECT_EQ(unknown("law", "a\nb", {}), "unknown law \"a\\x0ab\"");
}

}  // namespace
}  // namespace contact::test::complaint_test
}  // namespace contact::detail
