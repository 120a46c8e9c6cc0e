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
#include "joint/points/summary.hpp"
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
  std::vector<PointRow> kept;
  Problems problems;
};

// A file of points whose header is good.
class Points {
 public:
  Points(const Options& options, bool pin)
      : reader_(options.points),
        header_(cli::read_header(reader_)),
        form_(find_form(header_, pin)),
        columns_(header_.line, form_.columns, header_.place),
        pin_(pin) {
    if (options.rate.empty()) return;
    rate_ =
        cli::parse_quantity("--rate", options.rate,
                            contact::Dimension::angular_velocity, allowed_rate);
    if (form_.columns.size() == 6) {
      cli::refuse_beside(cli::given("--rate", options.rate),
                         "the vectors of " + header_.place);
    }
  }

  Question question() const { return form_.question; }
  const cli::PointColumns& columns() const { return columns_; }

  // Answers all of them in `jobs` threads: each(block, i, answer) in these,
  // null for a bad line; write(block) in order.
  template <class Each, class Write>
  Problems answer(const NamedJoint& joint, int jobs, const Each& each,
                  const Write& write) {
    cli::Progress progress("points", 0);
    Problems problems;
    cli::ordered_blocks<Block>(
        jobs, [&](Block& block) { return reader_.next(block.lines); },
        [&](Block& block) {
          cli::read_points(columns_, block);
          block.rows.clear();
          block.kept.clear();
          block.problems = {};
          for (std::size_t i = 0; i < block.size(); ++i) {
            if (!block.good[i]) {
              each(block, i, nullptr);
              continue;
            }
            const Answer a = hinge_joint::answer(
                joint, question(), state_of(question(), block, i, pin_, rate_));
            block.problems.add(a, 0);
            each(block, i, &a);
          }
        },
        [&](const Block& block) {
          write(block);
          progress.add(block.size());
          problems.add(block.problems);
          problems.bad_lines += block.bad_lines;
          if (block.bad_lines == 0) return;
          progress.clear();
          std::fputs(block.messages.c_str(), stderr);
        });
    return problems;
  }

 private:
  cli::LineReader reader_;
  cli::PointHeader header_;
  Form form_;
  cli::PointColumns columns_;
  bool pin_;
  double rate_ = 1;
};

void keep(const PointSeries& series, Block& block, std::size_t i,
          const Answer* a) {
  if (a == nullptr || a->solution.status != contact::Status::ok) return;
  block.kept.push_back(series.row(*a, block, i));
}

Problems write_rows(Points& points, const NamedJoint& joint,
                    const Options& options, PointSeries* series) {
  const cli::PointColumns& columns = points.columns();
  const std::vector<Quantity> quantities =
      hinge_joint::quantities(points.question() == Question::rest,
                              joint.approach.has_value(), false, options.pv);
  std::vector<std::string> names = solution_columns(joint, quantities, {});
  const std::size_t cells = names.size();
  for (std::string& name : cli::distinct_names(columns.riding, names)) {
    names.push_back(std::move(name));
  }
  cli::Output output(options.output.output);
  const cli::Table table(options.output, names);
  cli::TableWriter writer(output, table);
  Problems problems = points.answer(
      joint, options.output.jobs,
      [&](Block& block, std::size_t i, const Answer* a) {
        cli::RowWriter row(table, block.rows);
        if (a != nullptr) {
          write_cells(row, joint, quantities, *a, 1, {});
        } else {
          row.text("ERROR");
          for (std::size_t j = 1; j < cells; ++j) row.empty();
        }
        cli::write_riding(columns, block, i, row);
        row.end();
        if (series != nullptr) keep(*series, block, i, a);
      },
      [&](const Block& block) {
        writer.write(block.rows.view());
        if (series != nullptr) series->append(block.kept, block.size());
      });
  writer.finish();
  output.commit();
  return problems;
}

Problems summarise(Points& points, const NamedJoint& joint,
                   const Options& options, PointSeries& series) {
  Problems problems = points.answer(
      joint, options.output.jobs,
      [&](Block& block, std::size_t i, const Answer* a) {
        keep(series, block, i, a);
      },
      [&](const Block& block) { series.append(block.kept, block.size()); });
  write_point_summary(joint, series, options.output);
  return problems;
}

}  // namespace

PointResult write_points(const NamedJoint& joint, const Options& options,
                         const std::function<void()>& begin) {
  Points points(options, joint.joint.is_pin());
  PointSeries series(points.question(), points.columns().riding);
  begin();
  const bool keeps = !options.output.plot.empty();
  const Problems problems =
      options.summary
          ? summarise(points, joint, options, series)
          : write_rows(points, joint, options, keeps ? &series : nullptr);
  return {problems, std::move(series)};
}

}  // namespace hinge_joint
