#include "programs/identify/data.hpp"

#include <fmt/format.h>

#include <cmath>

#include "cli/refuse.hpp"
#include "cli/stream/points.hpp"
#include "libcontact/base/magnitude.hpp"
#include "programs/joint/points/form.hpp"

namespace hinge_identify {
namespace {

using contact::MeasuredMoment;
using Eigen::Vector3d;

constexpr cli::Allowed any_moment{-1e100, 1e100, "N m"};
// Negative rates turn in the opposite direction.
constexpr cli::Allowed any_rate{-1e100, 1e100, "rad/s"};
constexpr cli::Allowed above_zero{1e-300, 1e100, "N m"};

const std::vector<cli::PointColumn> torque = {{"torque_N_m", any_moment}};
const std::vector<cli::PointColumn> vector = {{"M_t_x_N_m", any_moment},
                                              {"M_t_y_N_m", any_moment},
                                              {"M_t_z_N_m", any_moment}};
const std::vector<cli::PointColumn> sigma = {{"sigma_N_m", above_zero}};
const std::vector<cli::PointColumn> rate = {{"rate_rad_per_s", any_rate}};

// sigma of a moment: sqrt(s_abs^2 + (s_rel M)^2).
double sigma_of(const Options& options, double moment) {
  return std::hypot(options.sigma_abs.value_or(0),
                    options.sigma_rel.value_or(0) * moment);
}

// Columns of a file, and the index of each among the required ones.
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
      header.fail(contact::detail::needs("a measured moment",
                                         "the column torque_N_m or the columns "
                                         "M_t_x_N_m,M_t_y_N_m,M_t_z_N_m"));
    }
    const auto add = [this](const std::vector<cli::PointColumn>& more) {
      needed.insert(needed.end(), more.begin(), more.end());
    };
    add(has_vectors ? vector : torque);
    if (has_sigma) add(sigma);
    if (has_rate) add(rate);
  }

  MeasuredMoment datum(const cli::PointLines& block, std::size_t i, bool pin,
                       const Options& options) const {
    std::size_t column = form.columns.size();
    const auto next = [&] { return block.values[column++][i]; };
    MeasuredMoment datum{};
    double size = 0;
    if (has_vectors) {
      const double x = next();
      const double y = next();
      const Vector3d moment(x, y, next());
      size = contact::magnitude(moment);
      datum.moment = moment;
    } else {
      size = next();
      datum.moment = size;
    }
    datum.sigma = has_sigma ? next() : sigma_of(options, size);
    const hinge_joint::Input state = state_of(
        form, block, i, pin, has_rate ? next() : options.rate.value_or(1));
    datum.reaction = state.force;
    datum.angular_velocity = state.turn;
    return datum;
  }
};

// Checks options against the columns of a file.
void check_options(const Options& options, const cli::PointHeader& header,
                   const Columns& columns) {
  const char* error = options.sigma_abs   ? "--sigma-abs"
                      : options.sigma_rel ? "--sigma-rel"
                                          : nullptr;
  if (columns.has_sigma && error != nullptr) {
    cli::refuse_beside(error, "the column sigma_N_m of " + header.place);
  }
  if (!columns.has_sigma && error == nullptr) {
    cli::refuse_without(cli::given("--data", options.data),
                        "a column sigma_N_m, --sigma-abs or --sigma-rel");
  }
  if (options.rate && (columns.form.has_vectors() || columns.has_rate)) {
    cli::refuse_beside("--rate", "the rates of " + header.place);
  }
}

// Adds the place of each line with a point, that is, of each line that is not
// blank.
void add_names(const std::string& file, const cli::LineBlock& block,
               std::vector<std::string>& names) {
  std::string_view text = block.text;
  for (std::size_t line = block.first_line; !text.empty(); ++line) {
    if (cli::next_line(text).find_first_not_of(" \t") == text.npos) continue;
    names.push_back(fmt::format("{}, line {}", file, line));
  }
}

}  // namespace

std::vector<MeasuredMoment> read_data(const Options& options, bool pin,
                                      contact::IdentifyOptions& identify) {
  cli::LineReader reader(options.data);
  const cli::PointHeader header = cli::read_header(reader, options.output);
  const Columns columns(header, pin);
  check_options(options, header, columns);
  const cli::PointColumns point(header, columns.needed);
  identify.direction = columns.form.has_vectors()
                           ? contact::LoadDirection::vector
                           : contact::LoadDirection::angle;
  std::vector<std::string>& names = identify.names;
  std::vector<MeasuredMoment> data;
  cli::read_all_points(reader, point, [&](const cli::PointLines& block) {
    add_names(reader.name(), block.lines, names);
    for (std::size_t i = 0; i < block.size(); ++i) {
      data.push_back(columns.datum(block, i, pin, options));
      if (data.back().sigma > 0) continue;
      cli::refuse_without(
          names[data.size() - 1] + ": the moment",
          "--sigma-abs or --sigma-rel that give it an error above 0");
    }
  });
  return data;
}

}  // namespace hinge_identify
