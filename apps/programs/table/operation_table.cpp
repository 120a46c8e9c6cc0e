#include "programs/table/operation_table.hpp"

#include <array>
#include <cmath>
#include <string>
#include <vector>

#include "cli/refuse.hpp"
#include "cli/stream/report.hpp"
#include "cli/sweep.hpp"
#include "multibody/dynamics/operation_count.hpp"
#include "programs/table/elliptic_table.hpp"

namespace hinge_table {
namespace {

// (c[0] L^3 + c[1] L^2 + c[2] L + c[3])/c[4]
using Cubic = std::array<double, 5>;
double value(const Cubic& c, double bodies) {
  return (((c[0] * bodies + c[1]) * bodies + c[2]) * bodies + c[3]) / c[4];
}

// Operations of a Cholesky factorisation of order n.
double factor(double n) { return n * (n + 1) * (2 * n + 1) / 6; }

using multibody::Operations;
struct Work {
  const char* hinges;
  const char* name;
  Cubic at_once;     // the paper's count
  Operations paper;  // the paper's count
  Operations ours;
  int kept = 0;  // unknowns of a hinge if the factor is known
};
constexpr Operations papers_balls{120, 66}, papers_axes{204, 66};
constexpr Cubic balls_again = {9, 23, 67, -3, 1};
constexpr Cubic axes_again = {250, 375, 959, 54, 6};
// Sections 1.3 (evaluation) and 4 (iteration).
constexpr std::array<Work, 6> works = {{
    {"balls",
     "evaluation",
     {9, 72, 227, 36, 1},
     {456, 295},
     multibody::evaluation_of_balls},
    {"balls", "iteration", balls_again, papers_balls,
     multibody::iteration_of_balls},
    {"balls", "iteration with a kept factor", balls_again, papers_balls,
     multibody::iteration_of_balls, 3},
    {"axes",
     "evaluation",
     {250, 1002, 3092, 216, 6},
     {837, 286},
     multibody::evaluation_of_axes},
    {"axes", "iteration", axes_again, papers_axes,
     multibody::iteration_of_axes},
    {"axes", "iteration with a kept factor", axes_again, papers_axes,
     multibody::iteration_of_axes, 5},
}};

void refuse_idle_of_operations(const Options& options) {
  refuse_idle(options, operations_quantity);
  const std::string quantity = cli::given("--quantity", operations_quantity);
  if (!options.theta0.empty()) cli::refuse_beside("--theta0", quantity);
  if (options.method != Options().method) {
    cli::refuse_beside(cli::given("--method", options.method), quantity);
  }
}

}  // namespace

cli::ExitStatus run_operations(const Options& options) {
  refuse_idle_of_operations(options);
  // The cubics are exact in double up to here.
  constexpr int most = 1000;
  const std::vector<int> bodies = cli::whole_numbers(
      "--bodies", options.bodies.empty() ? "1:8:1" : options.bodies, most);
  const std::vector<std::string> columns = {
      "hinges",  "work",       "bodies", "N_at_once",
      "N_paper", "gain_paper", "N_ours", "gain_ours"};
  cli::write_table(options.output, columns, [&](cli::RowWriter& row) {
    for (const Work& work : works) {
      for (const int count : bodies) {
        const double at_once =
            value(work.at_once, count) - factor(work.kept * count);
        row.text(work.hinges);
        row.text(work.name);
        row.count(count);
        row.count(std::llround(at_once));
        for (const Operations& way : {work.paper, work.ours}) {
          row.count(way.of(count));
          row.number(at_once / way.of(count));
        }
        row.end();
      }
    }
  });
  return cli::all_good;
}

}  // namespace hinge_table
