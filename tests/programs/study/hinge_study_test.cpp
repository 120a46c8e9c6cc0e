// hinge-study as a program: killed and repeated, in parts, one run again.
#include <gtest/gtest.h>
#include <hdf5.h>

#include <algorithm>
#include <csignal>
#include <fstream>
#include <nlohmann/json.hpp>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "support/program.hpp"

namespace contact::test::hinge_study_test {
namespace {

const std::string balls =
    "name = 'balls'\njoint = 'j.toml'\nruns = 300\n"
    "load = { reaction_kN = 100, beta_deg = 60 }\n"
    "[[requirement]]\nquantity = 'M_t_N_m'\nat_most = 700\nsuccess = 0.99\n"
    "[[dispersion]]\nkey = 'friction.coefficient'\nkind = 'uniform'\n"
    "low = 0.05\nhigh = 0.15\n"
    "[[dispersion]]\nkey = 'load.reaction_N'\nrelative = true\n"
    "kind = 'normal'\nmean = 1\ndeviation = 0.05\nlow = 0.5\nhigh = 1.5\n";

int times_in(const std::string& text, const std::string& part) {
  int found = 0;
  for (auto at = text.find(part); at != text.npos;
       at = text.find(part, at + part.size())) {
    ++found;
  }
  return found;
}

class HingeStudy : public testing::Test {
 protected:
  void SetUp() override {
    folder_.write("j.toml",
                  "name = 'ball'\nkind = 'ball'\n"
                  "geometry = { radius_mm = 50, radial_clearance_um = 100 }\n"
                  "materials = { pair = '" CONTACT_DATA_DIR
                  "/materials/steel_steel.toml' }\n"
                  "friction = { coefficient = 0.1 }\n"
                  "pressure = { law = 'sqrt_tan' }\n");
    folder_.write("s.toml", balls);
  }
  // Standard output of a command that ends with this status.
  std::string run(const std::string& arguments, int status = 0) const {
    const auto result = folder_.run("hinge-study " + arguments);
    EXPECT_EQ(result.status, status) << result.err;
    return result.out;
  }
  // CSV, JSON and the table of a study.
  std::vector<std::string> results(const std::string& journal,
                                   const std::string& options = "") const {
    std::string text = run("s.toml --journal " + journal +
                           " --csv rows.csv --output all.json " + options);
    return {folder_.read("rows.csv"), folder_.read("all.json"), text};
  }
  // Status of a study that is killed as soon as its journal has so many rows:
  // the signal's, unless it has ended before.
  int killed_at(int rows) const {
    return folder_
        .run(
            "hinge-study s.toml --runs 6000 --journal c --jobs 2 & study=$!\n"
            "for i in $(seq 5000); do\n"
            "  done=$(sqlite3 c 'SELECT count(*) FROM rows' 2>/dev/null)\n"
            "  [ \"${done:-0}\" -ge " +
            std::to_string(rows) +
            " ] && break\n"
            "done\n"
            "kill -KILL $study\n"
            "wait $study")
        .status;
  }

  ProgramFolder folder_;
};

TEST_F(HingeStudy, SameBytesInAnyThreadsAndParts) {
  const auto serial = results("a");
  EXPECT_EQ(std::ranges::count(serial[0], '\n'), 302);
  EXPECT_EQ(results("b", "--jobs 4"), serial);
  EXPECT_EQ(results("a"), serial);  // nothing is computed
  EXPECT_EQ(run("s.toml --rows 120:300 --journal p2 --jobs 2"), "");
  EXPECT_EQ(run("s.toml --rows 0:99 --journal p1"), "");
  // Runs that no part has are computed.
  EXPECT_EQ(results("c", "--merge p1 p2"), serial);
  // More runs leave the first ones.
  const auto more = results("a", "--runs 400");
  EXPECT_TRUE(more[0].starts_with(serial[0]));
}

TEST_F(HingeStudy, PartsAreAllRows) {
  EXPECT_EQ(run("s.toml --parts 100"), "0:99\n100:199\n200:299\n300:300\n");
  EXPECT_EQ(run("s.toml --parts 301"), "0:300\n");
}

TEST_F(HingeStudy, KilledItGoesOnToTheSameBytes) {
  const auto serial = results("a", "--runs 6000");
  for (const int rows : {1, 200, 700, 1200, 1700}) {
    EXPECT_EQ(killed_at(rows), 128 + SIGKILL) << rows;
  }
  EXPECT_EQ(results("c", "--runs 6000"), serial);
}

TEST_F(HingeStudy, OneRunAgainIsItsRow) {
  const auto rows = results("a")[0];
  std::istringstream stream(rows);
  std::string line;
  std::vector<std::string> lines;
  while (std::getline(stream, line)) lines.push_back(line);
  for (const int run_number : {0, 17, 300}) {
    const std::string again = run("s.toml --run " + std::to_string(run_number));
    std::string row = std::to_string(run_number);
    std::istringstream cells(again);
    std::getline(cells, line);
    EXPECT_EQ(line, "name,value");
    while (std::getline(cells, line)) row += line.substr(line.find(','));
    EXPECT_EQ(row + ",ok", lines[static_cast<std::size_t>(run_number) + 1]);
  }
}

TEST_F(HingeStudy, ChecksShowTheDrawsOfTheRows) {
  const auto rows = results("a")[0];
  std::istringstream draws(run("s.toml --check"));
  std::string line;
  std::getline(draws, line);
  EXPECT_EQ(line, "run,friction.coefficient,load.reaction_N");
  int count = 0;
  while (std::getline(draws, line)) {
    EXPECT_NE(rows.find('\n' + line + ','), rows.npos) << line;
    ++count;
  }
  EXPECT_EQ(count, 10);
}

TEST_F(HingeStudy, Hdf5HasTheSameNumbers) {
  const auto rows = results("a", "--hdf5 rows.h5")[0];
  const std::string name = (folder_.path() / "rows.h5").string();
  const hid_t file = H5Fopen(name.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT);
  ASSERT_GE(file, 0);
  std::vector<double> moments(301);
  const hid_t data = H5Dopen2(file, "quantities/M_t_N_m", H5P_DEFAULT);
  ASSERT_GE(data, 0);
  EXPECT_GE(H5Dread(data, H5T_NATIVE_DOUBLE, H5S_ALL, H5S_ALL, H5P_DEFAULT,
                    moments.data()),
            0);
  H5Dclose(data);
  EXPECT_GT(H5Lexists(file, "inputs/load.reaction_N", H5P_DEFAULT), 0);
  H5Fclose(file);
  std::istringstream stream(rows);
  std::string line;
  std::getline(stream, line);
  for (const double moment : moments) {
    std::getline(stream, line);
    std::istringstream cells(line);
    std::string cell;
    for (int i = 0; i < 4; ++i) std::getline(cells, cell, ',');
    EXPECT_EQ(std::stod(cell), moment);
  }
}

// Whenever it is written: HDF5 would note the second.
TEST_F(HingeStudy, Hdf5IsTheSameBytesLater) {
  run("s.toml --runs 5 --journal j --hdf5 a.h5");
  folder_.run_well("sleep 1.1");
  run("s.toml --runs 5 --journal j --hdf5 b.h5");
  EXPECT_TRUE(folder_.read("a.h5") == folder_.read("b.h5"));
}

// As it stands there, for a shell.
TEST_F(HingeStudy, TheCommandThatRepeatsARunIsOne) {
  folder_.write("a $(touch pwned) 'b'.toml", balls);
  const std::string text =
      run("\"a \\$(touch pwned) 'b'.toml\" --runs 5 --journal j");
  const std::string mark = "To repeat one: ";
  const auto at = text.find(mark) + mark.size();
  const auto result =
      folder_.run_well(text.substr(at, text.find('\n', at) - at));
  EXPECT_TRUE(has_text(result.out, "M_t_N_m,"));
  EXPECT_FALSE(folder_.has("pwned"));
}

// gnuplot takes labels of tics for formats.
TEST_F(HingeStudy, FactorsAreDrawnAsTheyAreCalled) {
  if (folder_.run("gnuplot --version").status != 0) GTEST_SKIP() << "gnuplot";
  const std::string factor = "rain 50 %g ''wet'' [1](x)";
  std::string study = balls;
  study.replace(study.find("runs = 300"), 10,
                "runs = 320\nsampling = 'saltelli'");
  folder_.write("f.toml", study + "factors = [\"" + factor +
                              "\"]\nloadings = [0.5]\n[[factor]]\nname = \"" +
                              factor + "\"\n");
  const std::string text = run("f.toml --plot p.svg");
  EXPECT_TRUE(has_text(text, R"(| factor rain 50 %g ''wet'' [1\](x) |)"))
      << text;
  EXPECT_TRUE(has_text(folder_.read("p_ranking_1.svg"), factor));
}

TEST_F(HingeStudy, TheTableSaysWhatTheVerdictRestsOn) {
  const std::string text = results("a")[2];
  for (const char* words :
       {"300 runs (random, seed 1) and the nominal one; 0 failed",
        "| M_t_N_m at most 700 | 99 % | 10 % |", "What drives M_t_N_m",
        "The worst runs for M_t_N_m at most 700",
        "To repeat one: hinge-study "
        "s.toml --run "}) {
    EXPECT_TRUE(has_text(text, words)) << words << '\n' << text;
  }
}

// Some runs have pressures above the strength of a material: their number is
// reported, and agrees with the rows.
TEST_F(HingeStudy, RunsAboveALimitOfPressureAreCounted) {
  std::string text = "quantities = 'p_peak_Pa'\n" + balls;
  folder_.write("s.toml", text);
  const auto free = folder_.run("hinge-study s.toml --output - --csv rows.csv");
  EXPECT_EQ(free.err, "");
  EXPECT_EQ(nlohmann::json::parse(free.out)["runs_above_limit_of_pressure"], 0);
  std::vector<double> peaks;
  for (const std::string& cell :
       csv_column(csv_rows(folder_.read("rows.csv")), "p_peak_Pa")) {
    peaks.push_back(std::stod(cell));
  }
  peaks.erase(peaks.begin());  // the nominal run
  std::vector<double> sorted = peaks;
  std::ranges::sort(sorted);
  const double limit = (sorted[279] + sorted[280]) / 2;
  text +=
      "[[dispersion]]\nkey = 'materials.outer.limit_pressure_Pa'\n"
      "kind = 'list'\nvalues = [" +
      std::to_string(limit) + "]\n";
  folder_.write("s.toml", text);
  const auto limited = folder_.run_well("hinge-study s.toml --journal k");
  const std::string said =
      "20 of 300 runs have peak pressures above 5 % of a Young's modulus, "
      "where linear elasticity ends, or above a limit_pressure: "
      "p_peak_over_limit";
  EXPECT_EQ(limited.err, "hinge-study: warning: " + said + '\n');
  EXPECT_TRUE(has_text(limited.out, said + ".\n"));
}

TEST_F(HingeStudy, AnotherStudysJournalIsRefused) {
  results("a");
  folder_.run_ill(
      "hinge-study s.toml --csv x.csv --journal a --seed 2", 2,
      "hinge-study: a: the study of this journal must be the same, with "
      "the same files, seed and version; remove it or name another one "
      "with --journal\n");
  EXPECT_FALSE(folder_.has("x.csv"));
}

// The history equals the case with the draws of the run.
TEST_F(HingeStudy, HistoriesOfARunOfACase) {
  folder_.write("c.toml",
                "name = 's'\ncase = '" CONTACT_DATA_DIR
                "/cases/two_stage_turn.toml'\nruns = 3\n"
                "quantities = 'stage.at_release.*'\n"
                "[[dispersion]]\nkey = 'body[stage].mass_t'\nrelative = true\n"
                "kind = 'uniform'\nlow = 0.9\nhigh = 1.1\n");
  const std::string draw = run("c.toml --run 2 --history h.csv");
  const auto at = draw.find("mass_t,") + 7;
  const std::string factor = draw.substr(at, draw.find('\n', at) - at);
  folder_.run_well("hinge-separation " CONTACT_DATA_DIR
                   "/cases/two_stage_turn.toml --set 'body[stage].mass_t=*" +
                   factor + "' --history d.csv --output d.json");
  EXPECT_EQ(folder_.read("h.csv"), folder_.read("d.csv"));
}

// Names that would end a script or an attribute are text.
TEST_F(HingeStudy, TheReportIsTheTableAsAPage) {
  std::string study = balls;
  study.replace(0, study.find('\n'),
                R"(name = "a </script><b onload=\"x\" 'y'> & study")");
  folder_.write("s.toml", study);
  run("s.toml --report r.html");
  const std::string page = folder_.read("r.html");
  for (const char* words :
       {R"(<h1>a &lt;/script>&lt;b onload=&quot;x&quot; 'y'> &amp; study</h1>)",
        "default-src 'none'", "<h2>Verdicts</h2>", "<h2>Percentiles</h2>",
        "<p class=\"verdict ", "confidence",
        "<th data-name=\"requirement\">Mₜ at most 700 N m</th>"
        "<td data-name=\"success\">99 %</td><td data-name=\"risk\">10 %</td>",
        "<th data-name=\"quantity\">Mₜ, N m</th>", "<th>Mₜ, N m</th>",
        "<th>probability of a miss: lower bound</th><th>upper bound</th>",
        "What drives Mₜ, N m", "The worst runs for Mₜ at most 700 N m",
        "<code>hinge-study s.toml --run "}) {
    EXPECT_TRUE(has_text(page, words)) << words;
  }
  for (const char* words : {"</script>", "<b ", " style="}) {
    EXPECT_FALSE(has_text(page, words)) << words;
  }
  if (folder_.run("gnuplot --version").status == 0) {
    // Histogram, ranking, inputs.
    EXPECT_EQ(times_in(page, "<svg"), 3);
    EXPECT_TRUE(has_text(page, "reaction of load, factor</text>"));
  }
  // The same study, the same page.
  run("s.toml --report again.html --jobs 2");
  EXPECT_EQ(folder_.read("again.html"), page);
}

TEST_F(HingeStudy, ListsAndMassesHaveTheirUnits) {
  run("data/studies/soyuz.toml --runs 2 --report r.html --output -");
  const std::string page = folder_.read("r.html");
  for (const char* words : {">com 1 of booster, m<", ">mass of booster, t<",
                            ">carrier point 2 of hinge of booster, m<"}) {
    EXPECT_TRUE(has_text(page, words)) << words;
  }
}

// The report shows the dispersions without the study file.
TEST_F(HingeStudy, TheReportSaysWhatScatters) {
  const std::string text =
      "# A <b>comment</b>.\n" + balls +
      "factors = ['cold', 'batch']\nloadings = [0.5, -0.25]\n"
      "[[factor]]\nname = 'cold'\n[[factor]]\nname = 'batch'\n"
      "[[dispersion]]\nkey = 'materials.inner.youngs_modulus_GPa'\n"
      "kind = 'list'\nvalues = [200, 210]\nweights = [1, 3]\n";
  folder_.write("s.toml", text);
  run("s.toml --report r.html --output -");
  const std::string page = folder_.read("r.html");
  for (const char* words :
       {"<h2>Inputs</h2>",
        ">coefficient of friction</th><td data-name=\"what is "
        "drawn\">number</td>"
        "<td data-name=\"distribution\">uniform, low 0.05, high 0.15</td>",
        ">reaction of load, N</th>"
        "<td data-name=\"what is drawn\">factor of its number</td>",
        ">normal, mean 1, deviation 0.05, low 0.5, high 1.5</td>"
        "<td data-name=\"factors\">cold 0.5, batch -0.25</td>",
        ">list, values 200 210, weights 1 3</td>",
        "standard normal numbers: cold, batch", "<h2>s.toml</h2>",
        "# A &lt;b>comment&lt;/b>.\nname = 'balls'\n"}) {
    EXPECT_TRUE(has_text(page, words)) << words;
  }
}

// The joint is of polyethylene, which this load breaks.
TEST_F(HingeStudy, SaysTheWarningsOfTheNominalRun) {
  folder_.write("j.toml",
                "name = 'ball'\nkind = 'ball'\n"
                "geometry = { radius_mm = 14, radial_clearance_um = 100 }\n"
                "materials = { pair = '" CONTACT_DATA_DIR
                "/materials/cocr_uhmwpe.toml', liner = false }\n"
                "friction = { coefficient = 0.1 }\n");
  const auto direct = folder_.run(
      "hinge-joint --joint j.toml --reaction 100000 --beta 60 --output d.csv");
  ASSERT_EQ(times_in(direct.err, "hinge-joint: warning: "), 1) << direct.err;
  for (const std::string options :
       {"--output o.json", "--quantities", "--check", "--report r.html"}) {
    const auto said = folder_.run("hinge-study s.toml " + options);
    EXPECT_EQ(times_in(said.err, "hinge-study: warning: nominal run: "), 1)
        << said.err;
  }
  EXPECT_EQ(times_in(folder_.read("r.html"), "Warning of the nominal run: "),
            1);
  EXPECT_TRUE(
      has_text(folder_.read("o.json"), "\"warnings_of_nominal_run\": [\n"));
  // Parts of a study leave them to the whole.
  EXPECT_EQ(folder_.run("hinge-study s.toml --rows 0:3 --journal p").err, "");
}

// All requested files except the page.
TEST_F(HingeStudy, AReportOnAFullDiskCostsNothingElse) {
  const auto expected = results("a");
  const auto result = folder_.run(
      "ln -s /dev/full r.html; hinge-study s.toml --journal b --csv rows.csv "
      "--output all.json --report r.html");
  EXPECT_EQ(result.status, 1);
  EXPECT_TRUE(
      has_text(result.err, "hinge-study: warning: no report: cannot write "));
  EXPECT_EQ((std::vector{folder_.read("rows.csv"), folder_.read("all.json"),
                         result.out}),
            expected);
}

// While gnuplot is at work; what was written before stays.
TEST_F(HingeStudy, SignalsEndPicturesAndReports) {
  folder_.write("gnuplot", "#!/bin/sh\ntouch started\nexec sleep 2\n");
  for (const auto& [name, status] : {std::pair("INT", 130), {"TERM", 143}}) {
    const auto result = folder_.run(
        "chmod +x gnuplot; rm -f started rows.csv; export PATH=.:\"$PATH\"; "
        "env --default-signal=INT hinge-study s.toml --csv rows.csv "
        "--report r.html & program=$!; "
        "while [ ! -e started ]; do sleep 0.05; done; kill -" +
        std::string(name) + " $program; wait $program");
    EXPECT_EQ(result.status, status) << result.err;
    EXPECT_EQ(times_in(folder_.read("rows.csv"), "\n"), 302);
    EXPECT_TRUE(has_text(result.out, "What drives M_t_N_m"));
    EXPECT_FALSE(folder_.has("r.html"));
  }
}

// Names of pictures and replays are unique.
TEST_F(HingeStudy, PicturesOverwriteNothing) {
  for (const std::string option : {"--journal", "--csv", "--hdf5"}) {
    folder_.run_ill("hinge-study s.toml --plot p.svg " + option + " p_1.svg", 2,
                    "hinge-study: --plot p_1.svg must be another file "
                    "than " +
                        option + "\n");
  }
}

TEST_F(HingeStudy, WithoutGnuplotAReportHasTables) {
  const auto result = folder_.run_well(
      "ln -s \"$(command -v hinge-study)\" hinge-study; PATH=.; "
      "hinge-study s.toml --report r.html --output -");
  EXPECT_TRUE(has_text(result.err, "no pictures in r.html: "));
  EXPECT_EQ(times_in(result.err, "\n"), 1) << result.err;
  EXPECT_EQ(times_in(folder_.read("r.html"), "<svg"), 0);
  EXPECT_EQ(times_in(folder_.read("r.html"), "<code>"), 5);
}

// Without gnuplot there are tables; where one picture fails, that is a failure.
TEST_F(HingeStudy, AReportWithoutAPictureSaysSo) {
  if (folder_.run("gnuplot --version").status != 0) GTEST_SKIP() << "gnuplot";
  folder_.run_ill(
      "printf '#!/bin/sh\\ngrep -q input0 $1 && exit 1\\nexec '"
      "\"$(command -v gnuplot)\"' \"$@\"\\n' >gnuplot; chmod +x gnuplot; "
      "PATH=.:$PATH; hinge-study s.toml --report r.html --output -",
      1,
      "hinge-study: warning: not all pictures in r.html: gnuplot: "
      "failed\n");
  EXPECT_EQ(times_in(folder_.read("r.html"), "<svg"), 2);
}

const std::string turns =
    "name = 's'\ncase = '" CONTACT_DATA_DIR
    "/cases/two_stage_turn.toml'\nruns = 6\n"
    "[[requirement]]\nquantity = 'stage.at_release.rate_deg_per_s'\n"
    "at_most = 0\nsuccess = 0.9\n"
    "[[dispersion]]\nkey = 'body[stage].mass_t'\nrelative = true\n"
    "kind = 'uniform'\nlow = 0.9\nhigh = 1.1\n";

TEST_F(HingeStudy, WorstRunsLinkToTheirReplays) {
  if (!folder_.has_page_libraries()) GTEST_SKIP() << "libjs-three";
  folder_.write("c.toml", turns);
  run("c.toml --report 'a \"#b.html'");
  const std::string page = folder_.read("a \"#b.html");
  EXPECT_EQ(times_in(page, "<a href="), 5);
  int pages = 0;
  for (int i = 0; i <= 6; ++i) {
    const std::string number = std::to_string(i);
    const std::string name = "a \"#b_run" + number + ".html";
    if (!folder_.has(name)) continue;
    ++pages;
    EXPECT_EQ(times_in(page, "\"a%20%22%23b_run" + number + ".html\""), 1);
    // The file names the draw of this run.
    const std::string row = run("c.toml --run " + number);
    const auto at = row.find("mass_t,") + 7;
    EXPECT_EQ(times_in(folder_.read(name),
                       "# run " + number + ": body[stage].mass_t = *" +
                           row.substr(at, row.find('\n', at) - at)),
              1);
  }
  EXPECT_EQ(pages, 5);
}

// The stage is released after the end, and passes through the carrier before.
TEST_F(HingeStudy, ReplaysHaveTheWarningsOfHingeSeparation) {
  if (!folder_.has_page_libraries()) GTEST_SKIP() << "libjs-three";
  std::ifstream file(CONTACT_DATA_DIR "/cases/two_stage_turn.toml");
  std::string text(std::istreambuf_iterator<char>(file), {});
  for (const auto& [old, now] :
       {std::pair{"\"../joints", "\"" CONTACT_DATA_DIR "/joints"},
        {"\"../joints", "\"" CONTACT_DATA_DIR "/joints"},
        {"angle_deg = 30", "angle_deg = 300"},
        {"end_time_s = 2.6", "end_time_s = 2.8"}}) {
    ASSERT_TRUE(has_text(text, old)) << old;
    text.replace(text.find(old), std::string(old).size(), now);
  }
  folder_.write("case.toml", text);
  folder_.write("c.toml",
                "name = 's'\ncase = 'case.toml'\nruns = 3\n"
                "[[requirement]]\nquantity = 'clearance.smallest_m'\n"
                "at_least = 0\nsuccess = 0.9\n"
                "[[dispersion]]\nkey = 'run.end_time_s'\nrelative = true\n"
                "kind = 'uniform'\nlow = 0.99\nhigh = 1\n");
  const auto said = folder_.run_well("hinge-study c.toml --report r.html");
  // Warnings of the nominal run are printed.
  for (const char* words :
       {"hinge-study: warning: nominal run: event \"release\" did not",
        "hinge-study: warning: nominal run: carrier and stage overlap from t "
        "="}) {
    EXPECT_EQ(times_in(said.err, words), 1) << said.err;
  }
  const std::string row = run("c.toml --run 2");
  const auto at = row.find("end_time_s,") + 11;
  folder_.run_well(
      "hinge-separation case.toml --replay d.html --set "
      "'run.end_time_s=*" +
      row.substr(at, row.find('\n', at) - at) + "'");
  const auto warnings = [&](const std::string& name) {
    const std::string page = folder_.read(name);
    const auto from = page.find("\"warnings\":[");
    return page.substr(from, page.find("\"case\":", from) - from);
  };
  const std::string found = warnings("d.html");
  for (const char* words : {"did not occur for stage", "stage overlap from"}) {
    EXPECT_TRUE(has_text(found, words));
  }
  EXPECT_EQ(warnings("r_run2.html"), found);
}

// Two moments of inertia that are valid separately but not together. An older
// program did not end for them.
TEST_F(HingeStudy, RunsOfTheSolarArrayDoNotFail) {
  for (const char* number : {"1", "19", "33"}) {
    const auto result =
        folder_.run("hinge-study " CONTACT_DATA_DIR
                    "/studies/solar_array.toml --runs 40 --run " +
                    std::string(number));
    EXPECT_EQ(result.status, 0) << number;
    EXPECT_EQ(result.err.find("failed"), result.err.npos) << result.err;
    EXPECT_EQ(result.out.find("failed"), result.out.npos) << result.out;
  }
}

TEST_F(HingeStudy, RunsWithoutACaseHaveNoHistory) {
  folder_.write("body.toml",
                "name = 'c'\nrun = { end_time_s = 0.2 }\n"
                "[carrier]\nname = 'a'\nmass_kg = 5\n"
                "principal_inertia_kg_m2 = [1, 1, 1]\n"
                "[[body]]\nname = 'b'\nmass_kg = 1\ncom_m = [0.5, 0, 0]\n"
                "principal_inertia_kg_m2 = [1, 1, 1]\n"
                "hinge = { kind = 'axis', axis = [0, 0, 1] }\n"
                "start = { rate_deg_per_s = 30 }\n");
  std::string study =
      "name = 's'\ncase = 'body.toml'\nruns = 9\n"
      "[[requirement]]\nquantity = 'b.peak_reaction_N'\nat_most = 100\n"
      "success = 0.9\n";
  for (const char* numbers :
       {"[1]'\nvalues = [1, 1.9]\n", "[2]'\nvalues = [1, 0.5]\n"}) {
    study += "[[dispersion]]\nkey = 'body[b].principal_inertia_kg_m2";
    study += numbers;
    study += "kind = 'list'\n";
  }
  folder_.write("c.toml", study);
  const auto result = folder_.run("hinge-study c.toml --report r.html");
  EXPECT_EQ(result.status, 1) << result.err;
  EXPECT_FALSE(has_text(result.out, "; 0 failed"));
  EXPECT_TRUE(folder_.has("r.html"));
}

TEST_F(HingeStudy, WithoutThreeJsAReportHasNoLinks) {
  folder_.write("c.toml", turns);
  const auto result = folder_.run_well(
      "XDG_DATA_DIRS=/nowhere hinge-study c.toml --report r.html --output -");
  EXPECT_TRUE(
      has_text(result.err,
               "a replay of each worst run beside r.html requires three.js "
               "and dygraphs (three/three.min.js is missing): apt install "
               "libjs-three libjs-dygraphs\n"));
  EXPECT_EQ(times_in(folder_.read("r.html"), "<a "), 0);
  EXPECT_EQ(times_in(folder_.read("r.html"), "<code>"), 5);
  EXPECT_FALSE(std::ranges::any_of(folder_.files(), [](const auto& name) {
    return name.find("_run") != name.npos;
  }));
}

}  // namespace
}  // namespace contact::test::hinge_study_test
