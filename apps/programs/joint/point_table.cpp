#include "programs/joint/point_table.hpp"

#include <vector>

#include "cli/output.hpp"
#include "cli/quantity.hpp"
#include "cli/refuse.hpp"
#include "cli/stream/points.hpp"
#include "programs/joint/input.hpp"
#include "programs/joint/points/form.hpp"
#include "programs/joint/points/summary.hpp"

namespace hinge_joint {
namespace {

constexpr Question all_questions[] = {Question::reaction, Question::contact,
                                      Question::rest};

// A block of points that the program works on.
struct PointBlock : cli::PointLines {
  std::vector<PointRow> kept;
  Problems problems;
};

// A file of points after its header is accepted.
class Points {
 public:
  Points(const Options& options, bool pin)
      : reader_(options.points),
        header_(cli::read_header(reader_, options.output)),
        form_(find_form(header_, pin, all_questions)),
        columns_(header_, form_.columns),
        pin_(pin),
        rate_(only_rate(options)) {
    if (!options.rate.empty() && form_.has_vectors()) {
      cli::refuse_beside("--rate", "the vectors of " + header_.place);
    }
  }

  Question question() const { return form_.question; }
  Pointing pointing() const {
    if (form_.question == Question::contact) return Pointing::nowhere;
    return form_.has_vectors() ? Pointing::vector : Pointing::angle;
  }
  const cli::PointColumns& columns() const { return columns_; }

  // Reads and solves the points of a block: calls each(i, answer), with null
  // for a bad line.
  template <class Each>
  void answer(const NamedJoint& joint, PointBlock& block,
              const Each& each) const {
    cli::read_points(columns_, block);
    block.kept.clear();
    block.problems = {};
    for (std::size_t i = 0; i < block.size(); ++i) {
      if (!block.good[i]) {
        each(i, nullptr);
        continue;
      }
      const Answer a = hinge_joint::answer(
          joint, question(), state_of(form_, block, i, pin_, rate_));
      block.problems.add(a, joint, 0);
      each(i, &a);
    }
  }
  cli::PointRows rows() { return cli::PointRows(reader_); }

 private:
  cli::LineReader reader_;
  cli::PointHeader header_;
  Form form_;
  cli::PointColumns columns_;
  bool pin_;
  double rate_;
};

void keep(const PointSeries& series, PointBlock& block, std::size_t i,
          const Answer* a) {
  if (a == nullptr || a->solution().status != contact::Status::ok) return;
  block.kept.push_back(series.row(*a, block, i));
}

void add(const PointBlock& block, Problems& problems) {
  problems.add(block.problems);
  problems.bad_lines += block.bad_lines;
}

Problems write_rows(Points& points, const NamedJoint& joint,
                    const Options& options, PointSeries* series) {
  const cli::PointColumns& columns = points.columns();
  const std::vector<AnswerColumn> shown =
      answer_columns({.rest = points.question() == Question::rest,
                      .approach = joint.approach.has_value(),
                      .preload = joint.has_preload(),
                      .pv = options.pv,
                      .rims = joint.has_rims(),
                      .lie = joint.ends});
  std::vector<std::string> names = solution_columns(joint, shown, {});
  const std::size_t cells = names.size();
  for (std::string& name : cli::distinct_names(columns.riding, names)) {
    names.push_back(std::move(name));
  }
  cli::Output output(options.output.output);
  const cli::Table table(options.output, names);
  cli::PointRows rows = points.rows();
  Problems problems;
  const auto write = [&](PointBlock& block, cli::RowWriter& row) {
    points.answer(joint, block, [&](std::size_t i, const Answer* a) {
      if (a != nullptr) {
        write_cells(row, joint, shown, *a, 1, {});
      } else {
        row.text("ERROR");
        for (std::size_t j = 1; j < cells; ++j) row.empty();
      }
      cli::write_riding(columns, block, i, row);
      row.end();
      if (series != nullptr) keep(*series, block, i, a);
    });
  };
  cli::write_rows<PointBlock>(options.output, output, table, rows, "points",
                              write, [&](const PointBlock& block) {
                                add(block, problems);
                                if (series != nullptr) {
                                  series->append(block.kept, block.size());
                                }
                              });
  return problems;
}

Problems summarise(Points& points, const NamedJoint& joint,
                   const Options& options, PointSeries& series) {
  cli::PointRows rows = points.rows();
  Problems problems;
  cli::row_blocks<PointBlock>(
      options.output.jobs, rows, "points",
      [&](PointBlock& block) {
        points.answer(joint, block, [&](std::size_t i, const Answer* a) {
          keep(series, block, i, a);
        });
      },
      [&](const PointBlock& block) {
        add(block, problems);
        series.append(block.kept, block.size());
      });
  write_point_summary(joint, series, options.output);
  return problems;
}

}  // namespace

PointResult write_points(Setup& setup, const Options& options,
                         const std::function<void()>& begin) {
  Points points(options, setup.joints[0].joint.is_pin());
  give_ends(options, points.pointing(), setup);
  const NamedJoint& joint = setup.joints[0];
  PointSeries series(points.question(), points.columns());
  begin();
  const bool keeps = !options.output.plot.empty();
  const Problems problems =
      options.summary
          ? summarise(points, joint, options, series)
          : write_rows(points, joint, options, keeps ? &series : nullptr);
  return {problems, std::move(series)};
}

}  // namespace hinge_joint
