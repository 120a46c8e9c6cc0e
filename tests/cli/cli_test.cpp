// Plumbing of the programs: sweeps, numbers, CSV, tables, files, threads.
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <csignal>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <numbers>
#include <random>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "cli/choice.hpp"
#include "cli/files_in_use.hpp"
#include "cli/interrupts.hpp"
#include "cli/joint/laws.hpp"
#include "cli/number.hpp"
#include "cli/output.hpp"
#include "cli/picture/axis.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/csv.hpp"
#include "cli/stream/decoding.hpp"
#include "cli/stream/line_blocks.hpp"
#include "cli/stream/ordered_blocks.hpp"
#include "cli/stream/quoting.hpp"
#include "cli/sweep.hpp"
#include "cli/table.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/base/file_text.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/base/units.hpp"
#include "support/error_message.hpp"
#include "support/numbers.hpp"
#include "support/program.hpp"

namespace contact::test::cli_test {
namespace {

using namespace std::string_literals;

constexpr cli::Allowed angles{-90, 120, "deg"};
constexpr cli::Allowed any{-infinity, infinity, ""};

std::vector<double> values(const std::string& text,
                           const cli::Allowed& allowed = any) {
  const cli::Sweep sweep("--theta0", text, allowed);
  std::vector<double> all;
  for (std::size_t i = 0; i < sweep.size(); ++i) all.push_back(sweep[i]);
  return all;
}

std::string sweep_error(const std::string& text) {
  return error_message([&] { cli::Sweep("--theta0", text, angles); });
}

TEST(Sweep, ValuesAndLists) {
  EXPECT_EQ(values("45"), std::vector<double>{45});
  EXPECT_EQ(values(" 1e1,+2.5,-3"), (std::vector<double>{10, 2.5, -3}));
  EXPECT_EQ(values("0,inf"), (std::vector<double>{0, infinity}));
  EXPECT_EQ(values("5,0:2:1,7"), (std::vector<double>{5, 0, 1, 2, 7}));
}

TEST(Sweep, DecimalStepsAreTheNearestDoubles) {
  const auto tenths = values("0:1:0.1");
  ASSERT_EQ(tenths.size(), 11U);
  for (int i = 0; i <= 10; ++i) EXPECT_EQ(tenths[i], i / 10.0);
  const auto fine = values("0:95:0.0001");
  ASSERT_EQ(fine.size(), 950001U);
  for (int i = 0; i <= 950000; ++i) ASSERT_EQ(fine[i], i / 10000.0);
  EXPECT_EQ(values("0:1:0.3"), (std::vector<double>{0, 0.3, 0.6, 0.9}));
  EXPECT_EQ(values("90:-90:-7.5").size(), 25U);
  EXPECT_EQ(values("3:3:1"), std::vector<double>{3});
}

TEST(Sweep, StopIsIncludedDespiteRounding) {
  // 1/3 and 1e-17 are no decimals of 15 digits: the floating-point route.
  const auto thirds = values("0:1:0.33333333333333331");
  ASSERT_EQ(thirds.size(), 4U);
  EXPECT_DOUBLE_EQ(thirds[3], 1);
  EXPECT_EQ(values("0:1e-16:1e-17").size(), 11U);
}

TEST(Sweep, LogarithmicEndsAndDecadesAreExact) {
  EXPECT_EQ(values("0.01:100:log5"),
            (std::vector<double>{0.01, 0.1, 1, 10, 100}));
  const auto loads = values("0.3:7e5:log40");
  ASSERT_EQ(loads.size(), 40U);
  EXPECT_EQ(loads.front(), 0.3);
  EXPECT_EQ(loads.back(), 7e5);
  for (int i = 2; i < 40; ++i) {
    // 4e-15: a few roundings of exponents below 6 by pow(10, x).
    EXPECT_NEAR(loads[i] / loads[i - 1], loads[1] / loads[0], 4e-15 * 10);
  }
  EXPECT_TRUE(cli::Sweep("--x", "1:2:log3", any).is_logarithmic());
  EXPECT_FALSE(cli::Sweep("--x", "1:2:0.5", any).is_logarithmic());
}

TEST(Sweep, MessagesNameOptionValueAndRange) {
  EXPECT_EQ(sweep_error("200"), "--theta0 200 must be -90 to 120 deg");
  EXPECT_EQ(sweep_error("0:125:5"), "--theta0 125 must be -90 to 120 deg");
  EXPECT_EQ(sweep_error("nan"), "--theta0 nan must be -90 to 120 deg");
  for (const char* text : {"", "abc", "1:2", "1:2:3:4", "1,,2", "1:2:logx",
                           "1e999", "0x10", "1 2"}) {
    EXPECT_TRUE(has_text(sweep_error(text), "must be a value, a list")) << text;
  }
  for (const char* text : {"0:10:0", "0:10:-1", "10:0:1"}) {
    EXPECT_TRUE(has_text(sweep_error(text), "step leads"));
  }
  for (const auto& [text, said] : {std::pair{"0:inf:1", "finite"},
                                   {"0:10:log5", "above 0"},
                                   {"1:10:log1", "2 or more"},
                                   {"1:10:log2.5", "whole number"},
                                   {"0:1:1e-12", "1e9"},
                                   {"1:10:log1e12", "1e9"}}) {
    EXPECT_TRUE(has_text(sweep_error(text), said)) << text;
  }
}

TEST(Number, ReadsBackTheSameDouble) {
  std::mt19937_64 random(1);
  for (int i = 0; i < 100000; ++i) {
    const auto value = std::bit_cast<double>(random());
    if (std::isnan(value)) continue;
    ASSERT_EQ(cli::parse_number(cli::number_text(value)), value);
  }
}

TEST(Number, Rounded) {
  EXPECT_EQ(cli::rounded_text(0.8, 4), "0.8000");
  EXPECT_EQ(cli::rounded_text(0, 4), "0.000");
  EXPECT_EQ(cli::rounded_text(12.3456, 4), "12.35");
  EXPECT_EQ(cli::rounded_text(1234.5, 4), "1234");  // half to even
  EXPECT_EQ(cli::rounded_text(1.2344e-7, 4), "1.234e-07");
  EXPECT_EQ(cli::rounded_text(nan, 4), "-");
}

TEST(Choice, NamesWhatIsAllowed) {
  constexpr std::array<cli::Choice<int>, 2> words = {{{"one", 1}, {"two", 2}}};
  EXPECT_EQ(cli::choice("--count", "two", words), 2);
  EXPECT_ERROR(cli::choice("--count", "tow", words),
               "unknown count \"tow\": did you mean \"two\"? (one, two)");
}

TEST(Text, PrintableIsOneLineOfUtf8) {
  using detail::printable;
  for (const std::string same : {"", "a b~", "θ₀, deg", "\xf0\x9f\x94\xa7"}) {
    EXPECT_EQ(printable(same), same);
  }
  EXPECT_EQ(printable("a\n\t\x7f"), R"(a\x0a\x09\x7f)");
  // A control character of two bytes, one that is cut, a longer way to write
  // "/", half of a pair.
  EXPECT_EQ(printable("\xc2\x9b|\xce|\xe0\x80\xaf|\xed\xa0\x80|\xe2\x82"),
            R"(\xc2\x9b|\xce|\xe0\x80\xaf|\xed\xa0\x80|\xe2\x82)");
  // Right to left, an isolate, a line separator.
  EXPECT_EQ(printable("a\u202eb\u2067c\u2028"),
            R"(a\xe2\x80\xaeb\xe2\x81\xa7c\xe2\x80\xa8)");
  EXPECT_EQ(printable("θθθ", 3), "θθ...");
  EXPECT_EQ(printable("θθ", 4), "θθ");
}

TEST(Text, ControlCharactersOfAnyLengthAreFound) {
  for (const char* text :
       {"a\n", "\xc2\x9b", "θ\u202e", "\u2066a", "\xff\x7f"}) {
    EXPECT_TRUE(detail::has_control_characters(text)) << text;
  }
  for (const char* text : {"", "θ₀ ~", "\xff\x80", "مرحبا", "\u2027\u202f"}) {
    EXPECT_FALSE(detail::has_control_characters(text)) << text;
  }
}

// As CommonMark and GitHub read it.
TEST(Quoting, MarkdownShowsTheText) {
  EXPECT_EQ(cli::markdown_text("wall.layer[1].thickness_mm, p|N & m > 0"),
            R"(wall.layer[1].thickness_mm, p\|N & m > 0)");
  EXPECT_EQ(cli::markdown_text("[x](javascript:1) [x][1]"),
            R"([x\](javascript:1) [x\][1])");
  EXPECT_EQ(cli::markdown_text("_e_ *e* ~~d~~ &copy; &#65; <b> `c` $m$ \\"),
            R"(\_e\_ \*e\* \~\~d\~\~ \&copy; \&#65; \<b> \`c\` \$m\$ \\)");
  EXPECT_EQ(cli::markdown_text("a\nb\u202e"), R"(a\\x0ab\\xe2\\x80\\xae)");
}

TEST(Quoting, LatexTakesNoArgument) {
  EXPECT_EQ(cli::latex_text("[3mm] a"), "{}[3mm] a");
  EXPECT_EQ(cli::latex_text("*"), "{}*");
  EXPECT_EQ(cli::latex_text("a[1]*_%\\"), R"(a[1]*\_\%\textbackslash{})");
}

TEST(Quoting, ShellsReadOneWord) {
  EXPECT_EQ(cli::shell_word("data/a_1.toml"), "data/a_1.toml");
  EXPECT_EQ(cli::shell_word(""), "''");
  EXPECT_EQ(cli::shell_word("it's"), R"('it'\''s')");
  const ProgramFolder folder;
  for (const std::string word : {"a b", "$(touch pwned)", "`x`", "'", "\"'\\",
                                 "~", "*", "#a", "a;b", "[!x]", "θ"}) {
    EXPECT_EQ(folder.run_well("printf %s " + cli::shell_word(word)).out, word);
  }
  EXPECT_TRUE(folder.files().empty());
}

TEST(Quoting, TerminalsSeeLines) {
  EXPECT_EQ(cli::terminal_text("a\tθ\n\n\x1b[2J\r\nb"),
            "a\tθ\n\n\\x1b[2J\\x0d\nb");
}

TEST(Csv, SplitsAndKeepsRawText) {
  std::vector<std::string_view> fields;
  EXPECT_EQ(cli::split_record(R"(1,"a, ""b""", x ,)", fields), "");
  ASSERT_EQ(fields.size(), 4U);
  EXPECT_EQ(fields[1], R"("a, ""b""")");
  EXPECT_EQ(cli::field_value(fields[1]), R"(a, "b")");
  EXPECT_EQ(fields[2], " x ");
  EXPECT_EQ(fields[3], "");
  EXPECT_EQ(cli::split_record("", fields), "");
  EXPECT_EQ(fields.size(), 1U);
  EXPECT_EQ(cli::split_record(R"(1,"open)", fields), "a quote is left open");
  EXPECT_EQ(cli::split_record(R"(1,"a"b)", fields),
            "text after a closing quote");
}

TEST(Csv, RawFieldReadsBack) {
  std::vector<std::string_view> fields;
  for (const std::string value : {"", "plain", "a,b", "\"", "x\"y\"", "\"\""}) {
    const std::string raw = cli::raw_field(value);
    ASSERT_EQ(cli::split_record(raw, fields), "");
    ASSERT_EQ(fields.size(), 1U);
    EXPECT_EQ(cli::field_value(fields[0]), value);
  }
}

// The whole text of a table with one text column and one number column.
std::string table_text(cli::Format format) {
  const cli::Table table({format}, {"name", "p_Pa"});
  cli::Text rows;
  cli::RowWriter row(table, rows);
  for (const double value : {0.1, 1e-7, nan, infinity, -infinity}) {
    row.text("a_\"|,");
    row.number(value);
    row.end();
  }
  std::string_view all = rows.view();
  if (format == cli::Format::json) all.remove_prefix(1);
  return table.header() + std::string(all) + table.footer();
}

TEST(Table, Csv) {
  EXPECT_EQ(table_text(cli::Format::csv),
            "name,p_Pa\n"
            "\"a_\"\"|,\",0.1\n\"a_\"\"|,\",1e-07\n"
            "\"a_\"\"|,\",\n\"a_\"\"|,\",inf\n\"a_\"\"|,\",-inf\n");
}

TEST(Table, JsonParses) {
  const auto json = nlohmann::json::parse(table_text(cli::Format::json));
  ASSERT_EQ(json.size(), 5U);
  EXPECT_EQ(json[0]["name"], "a_\"|,");
  EXPECT_EQ(json[1]["p_Pa"], 1e-7);
  EXPECT_TRUE(json[2]["p_Pa"].is_null());
  // No value, and no number that JSON has.
  EXPECT_EQ(json[3]["p_Pa"], "inf");
  EXPECT_EQ(json[4]["p_Pa"], "-inf");
}

TEST(Table, Print) {
  EXPECT_EQ(table_text(cli::Format::markdown),
            "|   name |   p_Pa |\n"
            "| -----: | -----: |\n"
            "| a\\_\"\\|, | 0.1000 |\n"
            "| a\\_\"\\|, | 1.000e-07 |\n"
            "| a\\_\"\\|, |      - |\n"
            "| a\\_\"\\|, |    inf |\n"
            "| a\\_\"\\|, |   -inf |\n");
  EXPECT_EQ(table_text(cli::Format::latex),
            "\\begin{tabular}{rr}\n\\hline\n"
            "name & p\\_Pa \\\\\n\\hline\n"
            "a\\_\"|, & $0.1000$ \\\\\n"
            "a\\_\"|, & $1.000\\cdot10^{-7}$ \\\\\n"
            "a\\_\"|, & - \\\\\n"
            "a\\_\"|, & $\\infty$ \\\\\n"
            "a\\_\"|, & $-\\infty$ \\\\\n"
            "\\hline\n\\end{tabular}\n");
}

// One row of three columns and an infinity, in some style.
std::string row_text(const cli::TableStyle& style) {
  const cli::Table table(style, {"a", "b;c", "d"});
  cli::Text rows;
  cli::RowWriter row(table, rows);
  for (const double value : {0.5, -infinity}) {
    row.text("x,y");
    row.number(value);
    row.field(value > 0 ? "1.5" : "\"u;v\"");
    row.end();
  }
  return table.header() + std::string(rows.view());
}

TEST(Table, SeparatorAndDecimalComma) {
  EXPECT_EQ(row_text({}), "a,b;c,d\n\"x,y\",0.5,1.5\n\"x,y\",-inf,\"u;v\"\n");
  EXPECT_EQ(row_text({.separator = ';'}),
            "a;\"b;c\";d\nx,y;0.5;1.5\nx,y;-inf;\"u;v\"\n");
  EXPECT_EQ(row_text({.separator = '\t', .decimal_comma = true}),
            "a\tb;c\td\nx,y\t0,5\t1,5\nx,y\t-inf\tu;v\n");
}

TEST(Table, ColumnsInTheOrderAskedFor) {
  using cli::Format;
  EXPECT_EQ(row_text({.columns = {"d", "a"}}),
            "d,a\n1.5,\"x,y\"\n\"u;v\",\"x,y\"\n");
  EXPECT_EQ(
      row_text({.format = Format::json, .columns = {"d", "b;c"}}),
      "[,\n{\"d\":\"1.5\",\"b;c\":0.5},\n{\"d\":\"u;v\",\"b;c\":\"-inf\"}");
  EXPECT_EQ(row_text({.format = Format::markdown, .columns = {"b;c"}}),
            "|    b;c |\n| -----: |\n| 0.5000 |\n|   -inf |\n");
  EXPECT_ERROR(row_text({.columns = {"b;d"}}),
               "unknown column \"b;d\": did you mean \"b;c\"?");
  EXPECT_ERROR(row_text({.columns = {"xyz"}}),
               "unknown column \"xyz\" (a, b;c, d)");
}

// A table of `rows` rows whose names alone fill a line.
std::string wide_table(cli::Format format, int rows, cli::Output& output,
                       const std::filesystem::path& file) {
  std::vector<std::string> names = {"n"};
  for (int i = 0; i < 3; ++i) {
    names.push_back(std::string(40, 'x') + std::to_string(i));
  }
  const cli::Table table({format}, names);
  EXPECT_TRUE(table.is_turned());
  cli::TableWriter writer(output, table);
  for (int i = 1; i <= rows; ++i) {
    cli::Text text;
    cli::RowWriter row(table, text);
    row.count(i);
    for (int j = 0; j < 3; ++j) row.number(i + 0.1 * j);
    row.end();
    writer.write(text.view());
  }
  writer.finish();
  output.commit();
  std::ostringstream text;
  text << std::ifstream(file).rdbuf();
  return text.str();
}

TEST(Table, CountsAreWhole) {
  for (const auto& [format, expected] :
       {std::pair{cli::Format::csv, "123456\n"},
        std::pair{cli::Format::json, ",\n{\"n\":123456}"},
        std::pair{cli::Format::markdown, "| 123456 |\n"}}) {
    const cli::Table table({format}, {"n"});
    cli::Text rows;
    cli::RowWriter row(table, rows);
    row.count(123456);
    row.end();
    EXPECT_EQ(rows.view(), expected);
  }
}

TEST(Quantity, ValuesAndVectors) {
  EXPECT_EQ(cli::parse_value("--x", "1e3", {0, 1e4, "N"}), 1000);
  EXPECT_EQ(cli::parse_vector("--v", "1, -2.5,3e2", "in N"),
            (std::array<double, 3>{1, -2.5, 300}));
  EXPECT_ERROR(cli::parse_value("--x", "2", {0, 1, "N"}),
               "--x 2 must be 0 to 1 N");
  EXPECT_ERROR(cli::parse_value("--x", "1N", {0, 1, "N"}),
               "--x 1N must be a number, 0 to 1 N");
  for (const char* bad :
       {"", "1,2", "1,2,3,4", "1,,3", "1,2,x", "1,2,nan", "1,2,inf"}) {
    EXPECT_ERROR(cli::parse_vector("--v", bad, "in N"),
                 cli::given("--v", bad) + " must be X,Y,Z, in N");
  }
}

double quantity(const std::string& text, Dimension dimension) {
  return cli::parse_quantity("--x", text, dimension, any);
}

TEST(Quantity, DecimalUnitsGiveTheNearestDoubles) {
  EXPECT_EQ(quantity("50mm", Dimension::length), 0.05);
  EXPECT_EQ(quantity("1.5cm", Dimension::length), 0.015);
  EXPECT_EQ(quantity("0.5in", Dimension::length), 0.0127);
  EXPECT_EQ(quantity(" 7 um ", Dimension::length), 7e-6);
  EXPECT_EQ(quantity("1lbf", Dimension::force), 4.4482216152605);
  EXPECT_EQ(quantity("4MPa", Dimension::stress), 4e6);
  EXPECT_EQ(quantity("5ms", Dimension::time), 0.005);
  EXPECT_EQ(quantity("2e3", Dimension::force), 2000);
  EXPECT_EQ(quantity("inf", Dimension::force), infinity);
}

TEST(Quantity, AnglesAreInDegrees) {
  EXPECT_EQ(quantity("30", Dimension::angle), 30);
  EXPECT_EQ(quantity("0.1deg", Dimension::angle), 0.1);
  EXPECT_DOUBLE_EQ(quantity("0.5rad", Dimension::angle), 90 / std::numbers::pi);
  EXPECT_DOUBLE_EQ(quantity("100rpm", Dimension::angular_velocity),
                   std::numbers::pi * 10 / 3);
}

TEST(Quantity, ManyWaysToWriteAUnit) {
  for (const char* text : {"3N_m", "3N*m", "3Nm", "3 N m", "3000N_mm"}) {
    EXPECT_EQ(quantity(text, Dimension::moment), 3) << text;
  }
  for (const char* text : {"2kN_per_m", "2kN/m", "2N/mm"}) {
    EXPECT_EQ(quantity(text, Dimension::line_force), 2000) << text;
  }
  EXPECT_EQ(quantity("2kg*m^2", Dimension::inertia), 2);
  EXPECT_EQ(quantity("2GPa*s/m", Dimension::viscous_constant), 2e9);
}

TEST(Quantity, MessagesNameTheUnits) {
  const auto message = [](const char* text, Dimension dimension) {
    return error_message([&] {
      cli::parse_quantity("--x", text, dimension, {0, 1e4, "N"});
    });
  };
  EXPECT_EQ(message("1kg", Dimension::force),
            "--x 1kg must be a number in N, kN, MN or lbf");
  EXPECT_EQ(message("abc", Dimension::force),
            "--x abc must be a number, 0 to 10000 N");
  EXPECT_EQ(message("20kN", Dimension::force), "--x 20kN must be 0 to 10000 N");
  EXPECT_EQ(message("1N", Dimension::number),
            "--x 1N must be a number, 0 to 10000 N");
  EXPECT_ERROR(
      cli::parse_vector("--v", "1,2kN,0", "in N", Dimension::force),
      "--v 1,2kN,0 must be numbers that all have a unit, or all have none");
  EXPECT_EQ(cli::parse_vector("--v", "1kN,2N,0", "in N", Dimension::force),
            (std::array<double, 3>{1000, 2, 0}));
}

TEST(Quantity, IsAKeyOfAFile) {
  const auto key = [](const char* text) {
    return cli::quantity_key("--x", text, "geometry.radius", Dimension::length);
  };
  EXPECT_EQ(key("2 in").key, "geometry.radius_in");
  EXPECT_EQ(key("2 in").value, "2");
  EXPECT_EQ(key("2 in").origin, "--x 2 in");
  EXPECT_EQ(key("0.05").key, "geometry.radius_m");
  EXPECT_ERROR(key("2ft"),
               "--x 2ft must be a number in m, mm, um, cm, in or km");
}

TEST(Quantity, DimensionOfAUnit) {
  const auto dimension = [](const char* text) {
    return cli::unit_dimension(text, {Dimension::force, Dimension::line_force});
  };
  EXPECT_EQ(dimension("20kN"), Dimension::force);
  EXPECT_EQ(dimension("20kN_per_m"), Dimension::line_force);
  EXPECT_EQ(dimension("0:20N/mm:log5"), Dimension::line_force);
  EXPECT_EQ(dimension("0,20 kN"), Dimension::force);
  for (const char* none : {"20", "1:10:log5", "20m", "", "inf"}) {
    EXPECT_EQ(dimension(none), std::nullopt) << none;
  }
}

TEST(Sweep, NumbersWithUnits) {
  const auto forces = [](const char* text) {
    const cli::Sweep sweep("--load", text, {0, infinity, "N"},
                           Dimension::force);
    return cli::spread(sweep, sweep.size());
  };
  using Values = std::vector<double>;
  EXPECT_EQ(forces("1kN:100kN:log3"), (Values{1e3, 1e4, 1e5}));
  EXPECT_EQ(forces("0:2kN:500N"), (Values{0, 500, 1000, 1500, 2000}));
  EXPECT_EQ(forces("5,0.1:0.3:0.1"), (Values{5, 0.1, 0.2, 0.3}));
  const auto lengths = cli::Sweep("--x", "0:1mm:0.1mm", any, Dimension::length);
  ASSERT_EQ(lengths.size(), 11U);
  for (int i = 0; i <= 10; ++i) EXPECT_EQ(lengths[i], i / 1e4);
  for (const auto& [text, rule] :
       {std::pair{"1:10:1kN", "numbers that all have a unit, or all have none"},
        std::pair{"1,2,5kN", "numbers that all have a unit, or all have none"},
        std::pair{"1kN:2:log3",
                  "numbers that all have a unit, or all have none"},
        std::pair{"7,1kN:100kN:5",
                  "--load 1kN:100kN:5 must be a range whose step has a unit, "
                  "as 1kN:100kN:5kN; 1kN:100kN:log5 has 5 values in equal "
                  "ratios"},
        std::pair{"0:1 kN:0.5",
                  "a range whose step has a unit, as 0:1 kN:0.5 kN"},
        std::pair{"-1kN", "0 to inf N"}}) {
    const std::string message = error_message([&, t = text] { forces(t); });
    EXPECT_TRUE(message.ends_with(rule)) << message;
  }
  EXPECT_ERROR(forces("1kN:2m:log3"),
               "--load 2m must be a number in N, kN, MN or lbf");
}

TEST(Quantity, Counts) {
  EXPECT_EQ(cli::parse_count("--points", "7", 2, 10), 7);
  EXPECT_EQ(cli::parse_count("--points", "1e1", 2, 10), 10);
  for (const char* text : {"1", "11", "2.5", "nan", "x", ""}) {
    EXPECT_ERROR(
        cli::parse_count("--points", text, 2, 10),
        cli::given("--points", text) + " must be a whole number, 2 to 10");
  }
}

TEST(Laws, AllAreThoseThatAllowTheLoading) {
  using Names = std::vector<std::string>;
  const auto centre = InnerLoading::centre();
  const auto back = cli::parse_loading("back:30", centre);
  EXPECT_EQ(back, InnerLoading::back(30 * degree));
  EXPECT_EQ(cli::parse_loading("", back), back);
  EXPECT_EQ(cli::parse_loading("centre", back), centre);
  EXPECT_EQ(cli::half_angle_laws({"all"}, {}, {back}), Names{"exact"});
  EXPECT_EQ(cli::half_angle_laws({"all"}, {}, {centre}).size(),
            half_angle_law_names().size() - 1);
  EXPECT_EQ(cli::pressure_laws({"all"}, {}, {back}),
            (Names{"cosine", "sqrt_tan", "sqrt_theta", "exact"}));
  // All but the last, worn.
  Names unworn = pressure_law_names();
  EXPECT_EQ(unworn.back(), "worn");
  unworn.pop_back();
  EXPECT_EQ(cli::pressure_laws({"all"}, {}, {centre}), unworn);
  EXPECT_EQ(cli::half_angle_laws({}, {"tanh"}, {centre}), Names{"tanh"});
  // A law that does not allow the loading is refused when it is made.
  EXPECT_EQ(cli::half_angle_laws({"tanh"}, {}, {back}), Names{"tanh"});
  EXPECT_ERROR(cli::pressure_laws({"exact", "exact"}, {}, {centre}),
               "duplicate --pressure exact");
}

TEST(Table, DistinctNames) {
  EXPECT_EQ(cli::distinct_names({"a", "chi", "a"}, {"chi", "chi_in"}),
            (Texts{"a", "chi_in2", "a_in"}));
  EXPECT_EQ(cli::distinct_names({"", "a_in2", "a", "a", "", "a", "a"}, {""}),
            (Texts{"_in", "a_in2", "a", "a_in", "_in2", "a_in3", "a_in4"}));
}

// Spreadsheets end lines in empty columns. Names that are searched for one by
// one, or grow with every column, take minutes and gigabytes for these.
TEST(Table, ManyEqualNamesStayShort) {
  constexpr std::size_t count = 200'000;
  const std::vector<std::string> names = cli::distinct_names(Texts(count), {});
  EXPECT_EQ(std::set<std::string>(names.begin(), names.end()).size(), count);
  for (const std::string& name : names) ASSERT_LE(name.size(), 9U);
}

class OutputFile : public testing::Test {
 protected:
  std::string read(const std::string& name) const { return owner_.read(name); }
  std::size_t files() const { return owner_.files().size(); }

  const ProgramFolder owner_;
  const std::filesystem::path folder_ = owner_.path();
};

TEST_F(OutputFile, AppearsOnlyWhenComplete) {
  const std::string name = folder_ / "table.csv";
  {
    cli::Output output(name);
    output.write("half");
    EXPECT_FALSE(std::filesystem::exists(name));
  }
  EXPECT_EQ(files(), 0U);
  {
    cli::Output output(name);
    output.write("whole");
    output.commit();
  }
  EXPECT_EQ(read("table.csv"), "whole");
  {
    cli::Output output(name);
    output.write("lost");
  }
  EXPECT_EQ(read("table.csv"), "whole");
  EXPECT_EQ(files(), 1U);
}

// The last line of defence, for every name of the file.
TEST_F(OutputFile, LeavesNothingWhenASignalEndsTheProgram) {
  for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGQUIT, SIGPIPE, SIGXFSZ,
                           SIGALRM, SIGXCPU, SIGUSR1, SIGUSR2}) {
    const pid_t child = fork();
    if (child == 0) {
      const rlimit no_core = {0, 0};
      setrlimit(RLIMIT_CORE, &no_core);
      struct sigaction before = {};
      sigaction(signal, nullptr, &before);
      if (before.sa_handler == SIG_IGN) std::signal(signal, SIG_DFL);
      cli::Output output(folder_ / "a.csv");
      output.write("half");
      raise(signal);
      _exit(0);
    }
    int status = 0;
    waitpid(child, &status, 0);
    EXPECT_TRUE(WIFSIGNALED(status) && WTERMSIG(status) == signal) << signal;
    EXPECT_EQ(files(), 0U) << signal;
  }
}

TEST_F(OutputFile, IsNoFileThatWasRead) {
  const std::string name = folder_ / "measured.csv";
  std::ofstream(name) << "measured";
  cli::note_reading();
  {
    cli::Output output(name);
    output.write("computed");
    detail::file_text(name);
    EXPECT_ERROR(output.commit(), name + " must be another file than " + name +
                                      ", which is read");
  }
  EXPECT_EQ(read("measured.csv"), "measured");
  EXPECT_EQ(files(), 1U);
  EXPECT_ERROR(cli::Output again(name),
               name + " must be another file than " + name + ", which is read");
  detail::watch_reading(nullptr);
}

TEST_F(OutputFile, WideTablesAreTurnedInGroups) {
  const std::string name = folder_ / "table.md";
  const auto text = [&](cli::Format format, int rows) {
    cli::Output output(name);
    return wide_table(format, rows, output, name);
  };
  const std::string x(40, 'x');
  const std::string blank(40, ' ');
  // 45 + 6 * 8 = 93 characters; a seventh row does not fit.
  EXPECT_EQ(text(cli::Format::markdown, 7),
            "| n" + blank +
                " |     1 |     2 |     3 |     4 |     5 |     6 |\n| :" +
                std::string(40, '-') +
                " | ----: | ----: | ----: | ----: | ----: | ----: |\n"
                "| " +
                x +
                "0 | 1.000 | 2.000 | 3.000 | 4.000 | 5.000 | 6.000 |\n"
                "| " +
                x +
                "1 | 1.100 | 2.100 | 3.100 | 4.100 | 5.100 | 6.100 |\n"
                "| " +
                x +
                "2 | 1.200 | 2.200 | 3.200 | 4.200 | 5.200 | 6.200 |\n"
                "\n"
                "| n" +
                blank + " |     7 |\n| :" + std::string(40, '-') +
                " | ----: |\n"
                "| " +
                x +
                "0 | 7.000 |\n"
                "| " +
                x +
                "1 | 7.100 |\n"
                "| " +
                x + "2 | 7.200 |\n");
  EXPECT_EQ(text(cli::Format::latex, 1),
            "\\begin{tabular}{lr}\n\\hline\nn" + blank +
                " &       1 \\\\\n\\hline\n" + x + "0 & $1.000$ \\\\\n" + x +
                "1 & $1.100$ \\\\\n" + x +
                "2 & $1.200$ \\\\\n\\hline\n\\end{tabular}\n");
  EXPECT_EQ(text(cli::Format::markdown, 0),
            "| n" + blank + " |\n| :" + std::string(40, '-') + " |\n| " + x +
                "0 |\n| " + x + "1 |\n| " + x + "2 |\n");
}

TEST_F(OutputFile, KeepsLinksAndSpecialFiles) {
  std::ofstream(folder_ / "real.csv") << "old";
  std::filesystem::create_symlink("real.csv", folder_ / "link.csv");
  cli::Output output(folder_ / "link.csv");
  output.write("new");
  output.commit();
  EXPECT_TRUE(std::filesystem::is_symlink(folder_ / "link.csv"));
  EXPECT_EQ(read("real.csv"), "new");

  cli::Output null("/dev/null");
  null.write("gone");
  null.commit();
  EXPECT_TRUE(std::filesystem::is_character_file("/dev/null"));
}

TEST_F(OutputFile, Errors) {
  EXPECT_THROW(cli::Output(folder_ / "no" / "where.csv"), Error);
  cli::Output full("/dev/full");
  EXPECT_THROW(full.write("x"), Error);
}

TEST_F(OutputFile, CheckedWithoutATrace) {
  cli::Output::check("");
  cli::Output::check(folder_ / "table.csv");
  cli::Output::check("/dev/null");
  std::ofstream(folder_ / "old.csv") << "old";
  cli::Output::check(folder_ / "old.csv");
  EXPECT_EQ(read("old.csv"), "old");
  EXPECT_EQ(files(), 1U);
  EXPECT_THROW(cli::Output::check(folder_ / "no" / "where.csv"), Error);
  EXPECT_THROW(cli::Output::check(folder_), Error);
}

TEST_F(OutputFile, LineBlocksGiveEveryLineOnce) {
  const std::string name = folder_ / "lines.txt";
  std::string text;
  for (int i = 0; i < 40000; ++i) text += std::to_string(i) + "\r\n";
  std::ofstream(name) << text << "last";

  cli::LineReader reader(name);
  EXPECT_EQ(reader.line(), "0");
  cli::LineBlock block;
  std::size_t number = 2;
  std::size_t blocks = 0;
  while (reader.next(block)) {
    ++blocks;
    EXPECT_EQ(block.first_line, number);
    for (std::string_view rest = block.text; !rest.empty(); ++number) {
      ASSERT_EQ(cli::next_line(rest),
                number <= 40000 ? std::to_string(number - 1) : "last");
    }
  }
  EXPECT_EQ(number, 40002U);
  EXPECT_GT(blocks, 2U);
  EXPECT_FALSE(reader.next(block));
}

// Only its beginning is kept; the lines around it are whole.
TEST_F(OutputFile, LineTooLong) {
  const std::string name = folder_ / "long.txt";
  const std::string longest(cli::longest_line, 'x');
  for (const std::size_t size : {cli::longest_line + 1, std::size_t{3000000}}) {
    for (const char* end : {"", "\n", "\nlast"}) {
      std::ofstream(name) << "first\n"
                          << longest << "\nbefore\n"
                          << std::string(size, ' ') << end;
      cli::LineReader reader(name);
      std::vector<std::string> lines;
      for (cli::LineBlock block; reader.next(block);) {
        EXPECT_EQ(block.first_line, lines.size() + 1);
        for (std::string_view rest = block.text; !rest.empty();) {
          lines.emplace_back(cli::next_line(rest));
        }
      }
      ASSERT_EQ(lines.size(), std::string(end).size() > 1 ? 5U : 4U);
      EXPECT_EQ(lines[1], longest);
      EXPECT_EQ(lines[2], "before");
      EXPECT_GT(lines[3].size(), cli::longest_line);
      // A block more than the limit, however long the line is.
      EXPECT_LT(lines[3].size(), cli::longest_line + 200000);
      if (lines.size() > 4) {
        EXPECT_EQ(lines[4], "last");
      }
    }
  }
  std::ofstream(name) << longest << "x\nsecond\n";
  cli::LineReader reader(name);
  EXPECT_ERROR(reader.line(),
               name + ", line 1: longer than 1000000 characters");
  EXPECT_THROW(cli::LineReader(folder_ / "none.txt"), Error);
}

// Whatever pieces it comes in: marks, pairs of surrogates and "\r\n" that are
// cut in two.
TEST(TextDecoder, OfTextInPieces) {
  const std::string text = "a\r\nä€\U0001F600\nb\n";
  std::string little = "\xFF\xFE";
  std::string big = "\xFE\xFF";
  for (const char16_t unit : std::u16string(u"a\r\nä€\U0001F600\rb\r")) {
    const auto low = static_cast<char>(unit & 0xFF);
    const auto high = static_cast<char>(unit >> 8);
    little += {low, high};
    big += {high, low};
  }
  for (const std::string& bytes :
       {"\xEF\xBB\xBF" + text, "a\r\nä€\U0001F600\rb\r"s, little, big}) {
    for (std::size_t piece = 1; piece <= bytes.size(); ++piece) {
      cli::TextDecoder decoder;
      std::string decoded;
      for (std::size_t at = 0; at < bytes.size(); at += piece) {
        decoder.decode(std::string_view(bytes).substr(at, piece), decoded);
      }
      decoder.finish(decoded);
      ASSERT_EQ(decoded, text) << piece;
    }
  }
}

TEST(TextDecoder, OfWhatIsNoText) {
  for (const auto& [bytes, expected] :
       {std::pair("\xFF\xFE\x00\xD8\x41\x00"s, "\uFFFDA"s),
        {"\xFE\xFF\xDC\x00\x41"s, "\uFFFD\uFFFD"s},
        {"\xFF"s, "\xFF"s},
        {"\xEF\xBB"s, "\xEF\xBB"s},
        {"\xFF\xFE\x00\xD8"s, "\uFFFD"s},
        {""s, ""s}}) {
    cli::TextDecoder decoder;
    std::string decoded;
    decoder.decode(bytes, decoded);
    decoder.finish(decoded);
    EXPECT_EQ(decoded, expected);
  }
}

volatile std::sig_atomic_t handled = 0;
extern "C" void count_signal(int) { handled = handled + 1; }

// The first signal is remembered, the second does what it would have done.
TEST(Interrupts, AreRememberedOnce) {
  struct sigaction count = {};
  struct sigaction before = {};
  count.sa_handler = count_signal;
  sigaction(SIGTERM, &count, &before);
  for (int times = 0; times < 2; ++times) {
    const cli::Interrupts interrupts;
    EXPECT_EQ(interrupts.signal(), 0);
    raise(SIGTERM);
    EXPECT_EQ(interrupts.signal(), SIGTERM);
    EXPECT_EQ(handled, times);
    raise(SIGTERM);
    EXPECT_EQ(handled, times + 1);
  }
  { const cli::Interrupts interrupts; }
  raise(SIGTERM);
  EXPECT_EQ(handled, 3);
  count.sa_handler = SIG_IGN;
  sigaction(SIGTERM, &count, nullptr);
  const cli::Interrupts interrupts;
  raise(SIGTERM);
  EXPECT_EQ(interrupts.signal(), 0);
  sigaction(SIGTERM, &before, nullptr);
}

TEST(OrderedBlocks, KeepOrder) {
  for (const int jobs : {1, 2, 7}) {
    int last = 0;
    std::vector<int> written;
    cli::ordered_blocks<int>(
        jobs, [&](int& block) { return (block = ++last) <= 1000; },
        [](int& block) { block *= 2; },
        [&](const int& block) { written.push_back(block); });
    ASSERT_EQ(written.size(), 1000U);
    for (int i = 0; i < 1000; ++i) ASSERT_EQ(written[i], 2 * (i + 1));
  }
}

TEST(OrderedBlocks, ErrorsComeOut) {
  for (const int jobs : {1, 4}) {
    int last = 0;
    EXPECT_THROW(cli::ordered_blocks<int>(
                     jobs, [&](int& block) { return (block = ++last) < 100; },
                     [](int& block) {
                       if (block == 50) throw Error("block 50");
                     },
                     [](const int&) {}),
                 Error);
  }
}

TEST(Axis, CoversItsDataAndHasPlacesOnIt) {
  for (const char* unit : {"", "N", "deg"}) {
    for (double span = 1e-10; span < 1e12; span *= 3) {
      for (const double low : {0.0, -span / 3, 1e3}) {
        for (const bool whole : {false, true}) {
          const cli::Extent data{low, low + span};
          const cli::Ticks ticks =
              cli::ticks_of({"x", unit}, data, cli::Run::up, 20, whole);
          SCOPED_TRACE(fmt::format("{} {} {} {}", unit, span, low, whole));
          const double rounding = 1e-12 * std::max(std::abs(low), span);
          EXPECT_LE(ticks.range.low, data.low + rounding);
          EXPECT_GE(ticks.range.high, data.high - rounding);
          EXPECT_FALSE(ticks.places.empty());
          EXPECT_LE(ticks.places.size(), 12u);
        }
      }
    }
  }
}

}  // namespace
}  // namespace contact::test::cli_test
