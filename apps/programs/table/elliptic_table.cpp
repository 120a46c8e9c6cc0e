#include "programs/table/elliptic_table.hpp"

#include <cmath>
#include <string>
#include <vector>

#include "cli/choice.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/report.hpp"
#include "cli/sweep.hpp"
#include "libcontact/base/units.hpp"
#include "libcontact/friction/elliptic/integrals.hpp"
#include "programs/table/point_block.hpp"

namespace hinge_table {

void refuse_idle(const Options& options, std::string_view quantity) {
  const auto refuse = [&](const std::string& given, bool is_given) {
    if (!is_given) return;
    cli::refuse_beside(given, cli::given("--quantity", quantity));
  };
  const std::string materials = options.joint.materials();
  refuse("--alpha", !options.alpha.empty());
  refuse("--plot", !options.output.plot.empty());
  refuse("--pressure", !options.joint.pressures.empty());
  refuse(materials, !materials.empty());
  refuse(cli::given("--loading", options.joint.loading),
         !options.joint.loading.empty());
}

cli::ExitStatus run_elliptic(const Options& options) {
  refuse_idle(options, elliptic_quantity);
  const std::vector<cli::Choice<bool>> methods = {{"exact", false},
                                                  {"chebyshev", true}};
  const bool is_approximate = cli::choice("--method", options.method, methods);
  const cli::Sweep theta0("--theta0", options.theta0, point_columns[0].allowed,
                          contact::Dimension::angle);
  std::vector<std::string> columns = {"theta0_deg", "K", "E"};
  if (is_approximate) {
    columns.insert(columns.end(), {"K_error_percent", "E_error_percent"});
  }
  cli::write_table(options.output, columns, [&](cli::RowWriter& row) {
    for (std::size_t i = 0; i < theta0.size(); ++i) {
      const double cosine = std::cos(theta0[i] * contact::degree);
      const double x = cosine * cosine;  // 1 - k^2
      const double k = contact::elliptic_k(x), e = contact::elliptic_e(x);
      std::vector<double> values = {theta0[i], k, e};
      if (is_approximate) {
        const double of_k = contact::elliptic_k_chebyshev(x);
        const double of_e = contact::elliptic_e_chebyshev(x);
        values = {theta0[i], of_k, of_e, 100 * (of_k / k - 1),
                  100 * (of_e / e - 1)};
      }
      for (const double value : values) row.number(value);
      row.end();
    }
  });
  return cli::all_good;
}

}  // namespace hinge_table
