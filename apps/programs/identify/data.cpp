#include "programs/identify/data.hpp"

#include <fmt/format.h>

#include <cmath>
#include <string>
#include <utility>

#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/points.hpp"
#include "programs/joint/points/form.hpp"

namespace hinge_identify {
namespace {

using contact::MeasuredMoment;
using Eigen::Vector3d;
using hinge_joint::allowed_rate;

constexpr cli::Allowed any_moment{-1e100, 1e100, "N m"};
constexpr cli::Allowed above_zero{1e-300, 1e100, "N m"};

const std::vector<cli::PointColumn> torque = {{"torque_N_m", any_moment}};
const std::vector<cli::PointColumn> vector = {{"M_t_x_N_m", any_moment},
                                              {"M_t_y_N_m", any_moment},
                                              {"M_t_z_N_m", any_moment}};
const std::vector<cli::PointColumn> sigma = {{"sigma_N_m", above_zero}};
const std::vector<cli::PointColumn> rate = {{"rate_rad_per_s", allowed_rate}};

// sigma of moments: sqrt(s_abs^2 + (s_rel M)^2).
struct Errors {
  double absolute = 0;
  double relative = 0;

  explicit Errors(const Options& options) {
    const std::string& abs = options.sigma_abs;
    const std::string& rel = options.sigma_rel;
    if (!abs.empty()) {
      absolute =
          cli::parse_quantity("--sigma-abs", abs, contact::Dimension::moment,
                              {0, any_moment.max, "N m"});
    }
    if (!rel.empty()) {
      relative = cli::parse_value("--sigma-rel", rel, {0, 1e3, ""});
    }
  }
  double of(double moment) const {
    return std::hypot(absolute, relative * moment);
  }
};

// Columns of a file, and where they begin among those that are needed.
struct Columns {
  hinge_joint::Form form;
  bool has_vectors;
  bool has_sigma;
  bool has_rate;
  std::vector<cli::PointColumn> needed;

  Columns(const cli::PointHeader& header, bool pin)
      : form(find_form(header, pin,
                       std::vector{hinge_joint::Question::reaction})),
        has_vectors(header.has(vector)),
        has_sigma(header.has(sigma)),
        has_rate(!form.has_vectors() && header.has(rate)),
        needed(form.columns) {
    if (!has_vectors && !header.has(torque)) {
      throw contact::Error(fmt::format(
          "{}: {}", header.place,
          contact::detail::needs("a measured moment",
                                 "the column torque_N_m or the columns "
                                 "M_t_x_N_m,M_t_y_N_m,M_t_z_N_m")));
    }
    const auto add = [this](const std::vector<cli::PointColumn>& more) {
      needed.insert(needed.end(), more.begin(), more.end());
    };
    add(has_vectors ? vector : torque);
    if (has_sigma) add(sigma);
    if (has_rate) add(rate);
  }

  MeasuredMoment datum(const cli::PointLines& block, std::size_t i, bool pin,
                       double given_rate, const Errors& errors) const {
    std::size_t column = form.columns.size();
    const auto next = [&] { return block.values[column++][i]; };
    MeasuredMoment datum{};
    double size = 0;
    if (has_vectors) {
      const double x = next();
      const double y = next();
      const Vector3d moment(x, y, next());
      size = moment.stableNorm();
      datum.moment = moment;
    } else {
      size = next();
      datum.moment = size;
    }
    datum.sigma = has_sigma ? next() : errors.of(size);
    const hinge_joint::Input state =
        state_of(form, block, i, pin, has_rate ? next() : given_rate);
    datum.reaction = state.force;
    datum.angular_velocity = state.turn;
    return datum;
  }
};

void check_errors(const Options& options, const cli::PointHeader& header,
                  bool has_sigma) {
  for (const auto& [name, text] :
       {std::pair{"--sigma-abs", &options.sigma_abs},
        std::pair{"--sigma-rel", &options.sigma_rel}}) {
    if (has_sigma && !text->empty()) {
      cli::refuse_beside(cli::given(name, *text),
                         "the column sigma_N_m of " + header.place);
    }
  }
  if (!has_sigma && options.sigma_abs.empty() && options.sigma_rel.empty()) {
    cli::refuse_without(cli::given("--data", options.data),
                        "a column sigma_N_m, --sigma-abs or --sigma-rel");
  }
}

// The first message of bad lines, without "ERROR: ".
[[noreturn]] void refuse_lines(const std::string& name,
                               const std::string& messages) {
  constexpr std::string_view mark = "ERROR: ";
  throw contact::Error(
      name + ", " +
      messages.substr(mark.size(), messages.find('\n') - mark.size()));
}

}  // namespace

std::vector<MeasuredMoment> read_data(const Options& options, bool pin) {
  const Errors errors(options);
  cli::LineReader reader(options.data);
  const cli::PointHeader header = cli::read_header(reader);
  const Columns columns(header, pin);
  check_errors(options, header, columns.has_sigma);
  double given_rate = 1;
  if (!options.rate.empty()) {
    given_rate =
        cli::parse_quantity("--rate", options.rate,
                            contact::Dimension::angular_velocity, allowed_rate);
    if (columns.form.has_vectors() || columns.has_rate) {
      cli::refuse_beside(cli::given("--rate", options.rate),
                         "the rates of " + header.place);
    }
  }
  const cli::PointColumns point(header.line, columns.needed, header.place);
  std::vector<MeasuredMoment> data;
  cli::PointLines block;
  while (reader.next(block.lines)) {
    cli::read_points(point, block);
    if (block.bad_lines > 0) refuse_lines(reader.name(), block.messages);
    for (std::size_t i = 0; i < block.size(); ++i) {
      data.push_back(columns.datum(block, i, pin, given_rate, errors));
    }
  }
  return data;
}

}  // namespace hinge_identify
