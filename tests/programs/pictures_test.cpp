// Pictures of the programs: complete or absent, with every text unchanged, and
// axes that end where the data end.
#include <fmt/format.h>
#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <string>
#include <vector>

#include "cli/gnuplot.hpp"
#include "cli/plot.hpp"
#include "support/program.hpp"

namespace contact::test::pictures_test {
namespace {

constexpr const char* no_gnuplot = "gnuplot is not installed";

bool have_gnuplot(const ProgramFolder& folder) {
  return folder.run("command -v gnuplot").status == 0;
}

// The texts of an SVG that gnuplot has drawn: titles and labels.
std::vector<std::string> texts(const std::string& svg) {
  std::vector<std::string> all;
  for (std::size_t at = 0; (at = svg.find("<text>", at)) != svg.npos;) {
    at += 6;
    std::string text = svg.substr(at, svg.find("</text>", at) - at);
    text.erase(0, text.find_first_not_of(" \t\n"));
    for (const auto& [code, c] :
         {std::pair{"&lt;", "<"}, {"&gt;", ">"}, {"&amp;", "&"}}) {
      for (std::size_t i = 0; (i = text.find(code, i)) != text.npos; ++i) {
        text.replace(i, std::string(code).size(), c);
      }
    }
    all.push_back(text);
  }
  return all;
}

// A title or label may have several lines.
std::string joined(const std::vector<std::string>& all) {
  return fmt::format("{}", fmt::join(all, " "));
}

bool has(const std::vector<std::string>& all, const std::string& text) {
  return std::find(all.begin(), all.end(), text) != all.end();
}

// Characters that mean something to a shell, gnuplot, its enhanced text or XML:
// in names of bodies, and with those that bodies may not have.
const std::string wild_body = R"(it's `touch pwned` \)";
const std::string other_wild_body = "$(touch pwned) @m a_{b}^2~&<#";
const std::string wild_joint = wild_body + other_wild_body +
                               "\"\n"
                               R"(system("touch pwned") \)";
const std::string wild_joint_shown = wild_body + other_wild_body +
                                     "\"\\x0a"
                                     R"(system("touch pwned") \)";

// A text as TOML has it.
std::string toml(const std::string& text) {
  std::string quoted = "\"";
  for (const char c : text) {
    if (c == '"' || c == '\\') quoted += '\\';
    quoted += c == '\n' ? "\\n" : std::string(1, c);
  }
  return quoted + '"';
}

cli::LinePlot plot_of(double low, double high) {
  cli::LinePlot plot;
  plot.title = "title";
  plot.curves = {{"curve", {low, high}, {1, 2}}};
  return plot;
}

std::vector<std::string> logarithmic_labels(double low, double high) {
  const ProgramFolder folder;
  cli::LinePlot plot = plot_of(low, high);
  plot.x.logarithmic = true;
  EXPECT_EQ(cli::draw(plot, folder.path() / "p.svg"), "");
  // Labels of the other axis are below 3.
  std::vector<std::string> labels;
  for (const std::string& text : texts(folder.read("p.svg"))) {
    if (!text.empty() &&
        text.find_first_not_of("0123456789.e+-") == text.npos &&
        std::stod(text) >= 3) {
      labels.push_back(text);
    }
  }
  return labels;
}

TEST(Pictures, TextIsQuoted) {
  EXPECT_EQ(cli::gnuplot_text("it's"), R"("it\047s")");
  EXPECT_EQ(cli::gnuplot_text("a\nb\r\x1b\x7f"),
            R"("a\134x0ab\134x0d\134x1b\134x7f")");
  EXPECT_EQ(cli::gnuplot_text("θ₀ \\ \"`$@%"), R"("θ₀ \134 \042\140$@%")");
  EXPECT_EQ(cli::gnuplot_tic("50 %g"), R"("50 %%g")");
}

// gnuplot reads the text as it is, wherever its apostrophes are.
TEST(Pictures, QuotedTextIsDrawn) {
  const ProgramFolder folder;
  if (!have_gnuplot(folder)) GTEST_SKIP() << no_gnuplot;
  cli::LinePlot plot = plot_of(1, 2);
  for (const std::string title :
       {"'t Hooft", "5'' pin", "'''", "a'", R"("a\")", "`touch pwned`", "100 %",
        "50 %g wet", "@x $y {z}", R"(it's "it's")"}) {
    plot.title = title;
    ASSERT_EQ(cli::draw(plot, folder.path() / "p.svg"), "") << title;
    EXPECT_TRUE(has(texts(folder.read("p.svg")), title)) << title;
    const std::string svg = cli::svg_of(
        "set xtics (" + cli::gnuplot_tic(title) + " 1)\nplot [0:2] x\n");
    EXPECT_TRUE(has(texts(svg), title)) << title;
  }
  EXPECT_EQ(folder.files(), std::vector<std::string>{"p.svg"});
}

TEST(Pictures, CutOnesAreKnown) {
  const ProgramFolder folder;
  if (!have_gnuplot(folder)) GTEST_SKIP() << no_gnuplot;
  for (const std::string name : {"p.svg", "p.png", "p.pdf"}) {
    ASSERT_EQ(cli::draw(plot_of(1, 2), folder.path() / name), "");
    const std::string all = folder.read(name);
    EXPECT_TRUE(cli::is_whole_picture(all, name));
    // Line ends at the end may be missing.
    const std::size_t end = all.find_last_not_of('\n') + 1;
    for (std::size_t size = 0; size < end; ++size) {
      ASSERT_FALSE(cli::is_whole_picture(all.substr(0, size), name))
          << name << ", " << size << " of " << all.size();
    }
  }
}

// A gnuplot that stops without saying so, or says why.
TEST(Pictures, WhatGnuplotLeavesUnfinishedIsRefused) {
  const ProgramFolder folder;
  const std::string run =
      "chmod +x gnuplot; PATH=.:$PATH hinge-table --theta0 45 --alpha 0:90:9 "
      "--plot p.svg --output t.csv";
  const auto warning = [&](const std::string& does) {
    folder.write("gnuplot", "#!/bin/sh\n[ \"$1\" = -e ] && exit 0\n" + does);
    const ProgramResult result = folder.run(run);
    EXPECT_EQ(result.status, 1);
    EXPECT_EQ(folder.files(), (std::vector<std::string>{"gnuplot", "t.csv"}));
    return result.err;
  };
  const std::string unfinished =
      "hinge-table: warning: no picture p.svg: gnuplot left it unfinished\n";
  EXPECT_EQ(warning("exit 0\n"), unfinished);
  EXPECT_EQ(warning("echo '<svg>'\n"), unfinished);
  EXPECT_EQ(warning("echo '<svg></svg'\n"), unfinished);
  EXPECT_EQ(warning("echo '<svg></svg>'; echo '\"p\", line 1: no' >&2; exit 1"),
            "hinge-table: warning: no picture p.svg: gnuplot: no\n");
}

TEST(Pictures, NamesWithControlCharactersAreRefused) {
  const ProgramFolder folder;
  const std::string evil = "$(printf 'a\\nsystem(\"touch pwned\")\\n.svg')";
  const std::string shown = R"(a\x0asystem("touch pwned")\x0a.svg)";
  for (const std::string run :
       {"hinge-table --theta0 45 --alpha 0:90:9 --plot",
        "hinge-table --theta0 45 --alpha 0:90:9 --output",
        "hinge-table --points",
        "hinge-angle --joint ball --modulus-ratio 1 --x 0.1:1:0.1 --plot",
        "hinge-angle --x 1 --joint",
        "hinge-pressure --joint ball --modulus-ratio 1 --x 1 --plot",
        // NOLINTNEXTLINE(bugprone-suspicious-missing-comma): it is one command.
        "hinge-joint --joint data/joints/hip_cocr_uhmwpe_infinite.toml "
        "--reaction "
        "1:9:1 --beta 30 --plot",
        "hinge-separation data/cases/slosh.toml --plot",
        "hinge-separation data/cases/slosh.toml --history",
        "hinge-separation data/cases/slosh.toml --events",
        "hinge-separation data/cases/slosh.toml --checkpoint-every 1 "
        "--checkpoint",
        "hinge-separation"}) {
    const ProgramResult result = folder.run(run + " \"" + evil + '"');
    EXPECT_EQ(result.status, 2) << run;
    EXPECT_EQ(result.err, run.substr(0, run.find(' ')) + ": " + shown +
                              " must be without control characters\n");
    EXPECT_EQ(result.out, "");
    EXPECT_TRUE(folder.files().empty()) << run;
  }
  // Names within files too.
  std::string joint = folder.read("data/joints/hip_cocr_uhmwpe_infinite.toml");
  folder.write("c.toml", "pair = \"a\\nb.toml\"\n" + joint);
  EXPECT_EQ(folder.run("hinge-angle --load 1 --joint c.toml").status, 2);
}

// Names of a joint, a case and its bodies.
TEST(Pictures, NamesAreShownAsTheyAre) {
  const ProgramFolder folder;
  if (!have_gnuplot(folder)) GTEST_SKIP() << no_gnuplot;
  const auto replaced = [](std::string text, const std::string& old,
                           const std::string& by) {
    EXPECT_TRUE(has_text(text, old)) << old;
    return text.replace(text.find(old), old.size(), by);
  };
  const std::string joint =
      replaced(folder.read("data/joints/hip_cocr_uhmwpe_infinite.toml"),
               "\"hip, 28 mm CoCrMo head in UHMWPE\"", toml(wild_joint));
  folder.write("j.toml", replaced(joint, "\"../", "\"data/"));
  const std::string slosh =
      replaced(folder.read("data/cases/slosh.toml"),
               "\"tank with two slosh pendulums\"", toml(wild_joint));
  folder.write("c.toml", replaced(replaced(slosh, "\"fuel\"", toml(wild_body)),
                                  "\"oxidiser\"", toml(other_wild_body)));
  const auto drawn = [&](const std::string& run, const std::string& picture) {
    folder.run_well(run + " --plot p.svg >/dev/null");
    EXPECT_FALSE(folder.has("pwned")) << run;
    return texts(folder.read(picture));
  };
  for (const std::string run :
       {"hinge-angle --joint j.toml --load 10:5000:log9",
        "hinge-pressure --joint j.toml --load 1000",
        "hinge-joint --joint j.toml --reaction 100:900:100 --beta 30",
        "hinge-table --joint j.toml --pressure exact --theta0 45 --alpha "
        "0:90:9"}) {
    // Some titles say more.
    const std::string all = joined(drawn(run, "p.svg"));
    const std::size_t at = all.find(wild_joint_shown);
    ASSERT_NE(at, all.npos) << run;
    EXPECT_EQ(all.find(wild_joint_shown, at + 1), all.npos) << run;
  }
  const auto all = drawn("hinge-separation c.toml", "p_rates.svg");
  EXPECT_TRUE(has_text(joined(all), wild_joint_shown));
  EXPECT_TRUE(has(all, wild_body));
  EXPECT_TRUE(has(all, other_wild_body));
}

// gnuplot leaves out legends for which there is no room.
TEST(Pictures, LongLabelsAreCut) {
  const ProgramFolder folder;
  if (!have_gnuplot(folder)) GTEST_SKIP() << no_gnuplot;
  cli::LinePlot plot = plot_of(1, 2);
  plot.curves.push_back(plot.curves[0]);
  plot.curves[1].label = std::string(200, 'a');
  EXPECT_EQ(cli::draw(plot, folder.path() / "p.svg"), "");
  const auto all = texts(folder.read("p.svg"));
  EXPECT_TRUE(has(all, "curve"));
  EXPECT_TRUE(has(all, std::string(60, 'a') + "..."));
}

// The number of times that something is drawn.
std::size_t count(const std::string& svg, const std::string& what) {
  std::size_t times = 0;
  for (std::size_t at = 0; (at = svg.find(what, at)) != svg.npos; ++at) ++times;
  return times;
}

// Coinciding curves are all visible; others are solid.
TEST(Pictures, CurvesOnEachOtherAreDashed) {
  const ProgramFolder folder;
  if (!have_gnuplot(folder)) GTEST_SKIP() << no_gnuplot;
  cli::LinePlot plot = plot_of(1, 2);
  plot.curves = {
      {"a", {1, 2}, {1, 3}}, {"b", {1, 2}, {1, 3}}, {"c", {1, 2}, {1, 3.001}}};
  EXPECT_EQ(cli::draw(plot, folder.path() / "p.svg"), "");
  // "b" and "c", each with its sample in the legend.
  EXPECT_EQ(count(folder.read("p.svg"), "stroke-dasharray"), 4U);
  plot.curves = {{"a", {1, 2}, {1, 2}}, {"b", {1, 2}, {2, 1}}};
  EXPECT_EQ(cli::draw(plot, folder.path() / "p.svg"), "");
  EXPECT_EQ(count(folder.read("p.svg"), "stroke-dasharray"), 0U);
}

// Labels are in the order of the ends of their curves, not of the curves.
TEST(Pictures, LabelsStandAtTheEndsOfTheirCurves) {
  const ProgramFolder folder;
  if (!have_gnuplot(folder)) GTEST_SKIP() << no_gnuplot;
  cli::LinePlot plot = plot_of(1, 2);
  plot.curves = {{"low", {1, 2}, {3, 1}},
                 {"high", {1, 2}, {1, 9}},
                 {"middle", {1, 2}, {2, 5}}};
  EXPECT_EQ(cli::draw(plot, folder.path() / "p.svg"), "");
  const std::string svg = folder.read("p.svg");
  const auto height = [&](const std::string& label) {
    const std::size_t text = svg.find(label + "</text>");
    const std::size_t at = svg.rfind("translate(", text);
    return std::stod(svg.substr(svg.find(',', at) + 1));
  };
  EXPECT_LT(height("high"), height("middle") - 50);
  EXPECT_LT(height("middle"), height("low") - 50);
}

TEST(Pictures, TitlesNameTheJoint) {
  const ProgramFolder folder;
  if (!have_gnuplot(folder)) GTEST_SKIP() << no_gnuplot;
  const std::string joint =
      "--joint data/joints/hip_cocr_uhmwpe_infinite.toml ";
  const auto title = [&](const std::string& run, const std::string& expected) {
    EXPECT_EQ(folder.run(run + " --plot p.svg >/dev/null").status, 0) << run;
    EXPECT_TRUE(has_text(joined(texts(folder.read("p.svg"))), expected)) << run;
  };
  const std::string name = "hip, 28 mm CoCrMo head in UHMWPE";
  title("hinge-angle --load 10:500:10 " + joint, name);
  title("hinge-angle --x 0:1:0.1 --joint ball --modulus-ratio 1", "ball joint");
  title(
      "hinge-angle --x 0:1:0.1 --joint ball "
      "--pair data/materials/steel_bronze.toml",
      "ball joint, carbon steel in phosphor bronze");
  title("hinge-pressure --load 10 --pressure cosine " + joint,
        name + ", cosine");
  title("hinge-joint --reaction 1:9:1 --beta 30 " + joint,
        name + ", β = 30°, law fitted, pressure exact");
  title("hinge-table --theta0 45 --alpha 0:90:9 --pressure exact " + joint,
        "chi, method exact, pressure exact, " + name);
}

// Contacts of one state: the largest values of --pv in the titles of three
// images of a ball and beside the curves of a pin.
TEST(Pictures, Contacts) {
  const ProgramFolder folder;
  if (!have_gnuplot(folder)) GTEST_SKIP() << no_gnuplot;
  const auto draw = [&](const std::string& joint) {
    folder.run_well("hinge-joint --joint data/joints/" + joint +
                    " --map p.svg --pv --output p.csv --columns p_peak_Pa,"
                    "pv_max_W_per_m2,v_m_per_s");
    return texts(folder.read("p.svg"));
  };
  const auto value = [&](const std::string& column, double unit) {
    const auto rows = csv_rows(folder.read("p.csv"));
    return fmt::format("{:.3g}",
                       std::stod(csv_column(rows, column).at(0)) / unit);
  };
  const auto ball =
      draw("hip_cocr_uhmwpe.toml --reaction 2000 --beta 50 --rate 2");
  EXPECT_TRUE(has(ball, "p to " + value("p_peak_Pa", 1e6) + " MPa"));
  EXPECT_TRUE(
      has(ball, "p v to " + value("pv_max_W_per_m2", 1e6) + " MPa m/s"));
  // The contact is wider than a: where it crosses the equator of Dw the slip
  // is rho |Dw|.
  EXPECT_TRUE(has(ball, "slip to 0.028 m/s"));
  EXPECT_TRUE(has(ball, "−X"));
  const auto pin = draw("pin_joint.toml --reaction 2e5 --rate 2");
  EXPECT_TRUE(has(pin, value("p_peak_Pa", 1e6)));
  EXPECT_TRUE(has(pin, value("pv_max_W_per_m2", 1e6)));
  EXPECT_TRUE(has(pin, value("v_m_per_s", 1)));
}

TEST(Pictures, NoPictureOfNoContact) {
  const ProgramFolder folder;
  const ProgramResult result = folder.run(
      "hinge-joint --joint data/joints/pin_joint.toml --reaction 0 --map p.svg "
      "--columns state");
  EXPECT_EQ(result.status, 1);
  EXPECT_EQ(result.out, "state\nunloaded\n");
  EXPECT_EQ(result.err,
            "hinge-joint: warning: no picture p.svg: no contact slides\n");
  EXPECT_EQ(folder.files(), std::vector<std::string>{});
}

TEST(Pictures, LogarithmicAxesEndWithTheData) {
  const ProgramFolder folder;
  if (!have_gnuplot(folder)) GTEST_SKIP() << no_gnuplot;
  using Labels = std::vector<std::string>;
  EXPECT_EQ(logarithmic_labels(1e3, 1e6),
            (Labels{"1000", "10000", "100000", "1e+06"}));
  EXPECT_EQ(logarithmic_labels(1e5, 1e8),
            (Labels{"100000", "1e+06", "1e+07", "1e+08"}));
  EXPECT_EQ(
      logarithmic_labels(1e3, 1e5),
      (Labels{"1000", "2000", "5000", "10000", "20000", "50000", "100000"}));
  EXPECT_EQ(logarithmic_labels(1e5, 5e6),
            (Labels{"100000", "200000", "500000", "1e+06", "2e+06", "5e+06"}));
  EXPECT_EQ(logarithmic_labels(200, 500),
            (Labels{"200", "250", "300", "350", "400", "450", "500"}));
  EXPECT_EQ(
      logarithmic_labels(35000, 41000),
      (Labels{"35000", "36000", "37000", "38000", "39000", "40000", "41000"}));
  EXPECT_EQ(logarithmic_labels(7, 90), (Labels{"10", "20", "50"}));
  EXPECT_EQ(logarithmic_labels(0.3, 7e4),
            (Labels{"10", "100", "1000", "10000"}));
  // One value, or as good as one.
  EXPECT_FALSE(logarithmic_labels(300, 300).empty());
  EXPECT_FALSE(logarithmic_labels(300, 300 * (1 + 1e-15)).empty());
}

}  // namespace
}  // namespace contact::test::pictures_test
