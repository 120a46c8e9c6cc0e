#include "joint/point_table.hpp"

#include <fmt/format.h>

#include <array>
#include <cstdio>
#include <vector>

#include "cli/output.hpp"
#include "cli/progress.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/ordered_blocks.hpp"
#include "cli/stream/points.hpp"
#include "joint/input.hpp"
#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace hinge_joint {
namespace {

constexpr cli::Allowed any_force{-allowed_force.max, allowed_force.max, "N"};
constexpr cli::Allowed any_rate{-allowed_rate.max, allowed_rate.max, "rad/s"};
constexpr cli::Allowed any_moment{-allowed_force.max, allowed_force.max, "N m"};

// The ways in which a file gives states, vectors first: outputs of this
// program have the columns of several.
struct Form {
  Question question;
  std::vector<cli::PointColumn> columns;
};

std::vector<Form> forms(bool pin) {
  const std::vector<cli::PointColumn> reaction = {
      {"R_x_N", any_force}, {"R_y_N", any_force}, {"R_z_N", any_force}};
  std::vector<Form> all = {{Question::reaction, reaction},
                           {Question::rest, reaction},
                           {Question::reaction, {{"R_N", allowed_force}}},
                           {Question::contact, {{"R_n_N", allowed_force}}}};
  for (const char* name : {"w_x_rad_per_s", "w_y_rad_per_s", "w_z_rad_per_s"}) {
    all[0].columns.push_back({name, any_rate});
  }
  for (const char* name : {"M_x_N_m", "M_y_N_m", "M_z_N_m"}) {
    all[1].columns.push_back({name, any_moment});
  }
  if (pin) return all;
  all[2].columns.push_back({"b_deg", allowed_beta});
  all[3].columns.push_back({"a_deg", allowed_alpha});
  return all;
}

Form find_form(const cli::PointHeader& header, bool pin) {
  std::string columns;
  for (const Form& form : forms(pin)) {
    if (header.has(form.columns)) return form;
    if (!columns.empty()) columns += "; ";
    for (std::size_t i = 0; i < form.columns.size(); ++i) {
      if (i > 0) columns += ',';
      columns += form.columns[i].name;
    }
  }
  throw contact::Error(
      fmt::format("{}: {}", header.place,
                  contact::detail::needs("a state", "the columns " + columns)));
}

Input state_of(Question question, const cli::PointLines& block, std::size_t i,
               bool pin, double rate) {
  const auto value = [&](std::size_t column) {
    return block.values[column][i];
  };
  if (block.values.size() == 6) {
    return {{value(0), value(1), value(2)}, {value(3), value(4), value(5)}};
  }
  return question == Question::contact
             ? state_from_contact(value(0), pin ? 0 : value(1), rate)
             : state_from_reaction(value(0), pin ? 90 : value(1), rate);
}

// Some points on their way through the program.
struct Block : cli::PointLines {
  cli::Text rows;
  Problems problems;
};

}  // namespace

Problems write_points(const NamedJoint& joint, const Options& options,
                      const std::function<void()>& begin) {
  const bool pin = joint.joint.is_pin();
  const double rate =
      options.rate.empty()
          ? 1
          : cli::parse_quantity("--rate", options.rate,
                                contact::Dimension::angular_velocity,
                                allowed_rate);
  cli::LineReader reader(options.points);
  const cli::PointHeader header = cli::read_header(reader);
  const Form form = find_form(header, pin);
  if (!options.rate.empty() && form.columns.size() == 6) {
    cli::refuse_beside(cli::given("--rate", options.rate),
                       "the vectors of " + header.place);
  }
  const cli::PointColumns columns(header.line, form.columns, header.place);

  const std::vector<Quantity> quantities = hinge_joint::quantities(
      form.question == Question::rest, joint.approach.has_value());
  std::vector<std::string> names = solution_columns(quantities, {});
  const std::size_t cells = names.size();
  for (std::string& name : cli::distinct_names(columns.riding, names)) {
    names.push_back(std::move(name));
  }
  cli::Output output(options.output.output);
  const cli::Table table(options.output, names);
  begin();
  cli::TableWriter writer(output, table);
  cli::Progress progress("points", 0);
  Problems problems;
  cli::ordered_blocks<Block>(
      options.output.jobs,
      [&](Block& block) { return reader.next(block.lines); },
      [&](Block& block) {
        cli::read_points(columns, block);
        block.rows.clear();
        block.problems = {};
        cli::RowWriter row(table, block.rows);
        for (std::size_t i = 0; i < block.size(); ++i) {
          if (block.good[i]) {
            const Answer a =
                answer(joint, form.question,
                       state_of(form.question, block, i, pin, rate));
            block.problems.add(a.solution.status);
            write_cells(row, joint, quantities, a, 1, {});
          } else {
            row.text("ERROR");
            for (std::size_t j = 1; j < cells; ++j) row.empty();
          }
          cli::write_riding(columns, block, i, row);
          row.end();
        }
      },
      [&](const Block& block) {
        writer.write(block.rows.view());
        progress.add(block.size());
        problems.out_of_range += block.problems.out_of_range;
        problems.not_converged += block.problems.not_converged;
        problems.bad_lines += block.bad_lines;
        if (block.bad_lines == 0) return;
        progress.clear();
        std::fputs(block.messages.c_str(), stderr);
      });
  writer.finish();
  output.commit();
  return problems;
}

}  // namespace hinge_joint
