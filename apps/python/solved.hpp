#pragma once

#include <memory>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/joint/joint.hpp"
#include "libcontact/joint/step.hpp"
#include "python/answers.hpp"

/// Solutions as Python stores many of them: with the ends of their contacts,
/// but without the grids of contacts at rims.
namespace contact_python {

/// Ends of a solution's contact; NaN where it has no such end.
struct Ends {
  contact::RimContact rims;
  contact::PinLie lie;
};
/// The ends of a contact; null if it has none.
using EndsOf = std::shared_ptr<const Ends>;

struct Solved : contact::JointSolution {
  Solved() = default;
  Solved(const contact::Joint& joint, const contact::JointSolution& s);
  Solved(const contact::JointSolution& s, EndsOf of)
      : JointSolution(s), ends(std::move(of)) {}

  EndsOf ends;
};

struct Held : contact::RestSolution {
  Held() = default;
  Held(const contact::Joint& joint, const contact::RestSolution& rest);
  Held(const contact::RestSolution& rest, EndsOf of)
      : RestSolution(rest), ends(std::move(of)) {}

  EndsOf ends;  ///< ends of the slip
};

struct Stepped : contact::JointStep {
  Stepped() = default;
  Stepped(const contact::Joint& joint, const contact::JointStep& step);

  EndsOf ends;       ///< ends of the solution
  EndsOf rest_ends;  ///< ends of the slip of the rest
};

/// The quantities of solutions; the quantities of their ends come last.
const Table<Solved>& solved_table();
const Table<Held>& held_table();
const Table<Stepped>& stepped_table();

/// @throws contact::Error for unpickled results, which have no rows
template <class Row>
void require_rows(const Answers<Row>& solution) {
  if (!solution.rows.empty() || !solution.arrays) return;
  throw contact::Error(contact::detail::must_be(
      "solution", "a result of solve() that was not unpickled"));
}

/// A part of the results, row by row.
/// @throws contact::Error for unpickled results
template <class Whole, class Get>
auto part_of(const Answers<Whole>& all, const char* name, const Get& get) {
  if (all.rows.empty() && all.arrays) {
    throw contact::Error(
        contact::detail::must_be(name, "asked for before it is pickled"));
  }
  Answers<std::decay_t<decltype(get(all.rows[0]))>> parts{all.shape};
  for (const Whole& row : all.rows) parts.rows.push_back(get(row));
  return parts;
}

/// The grid of the last bounded contact, which speeds up the next row.
class NearRim {
 public:
  /// Uses it as the start of a solution of the same joint.
  void put(const contact::Joint& joint, contact::JointSolution& start) const {
    if (of_ == &joint) start.work = work_;
  }
  contact::JointSolution begin(const contact::Joint& joint,
                               const contact::JointSolution* start) const {
    contact::JointSolution s;
    if (start) s = *start;
    put(joint, s);
    return s;
  }
  void keep(const contact::Joint& joint, const contact::JointSolution& s);

 private:
  const contact::Joint* of_ = nullptr;
  std::shared_ptr<const contact::detail::ContactWork> work_;
};

}  // namespace contact_python
