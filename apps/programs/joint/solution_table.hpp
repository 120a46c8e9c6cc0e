#pragma once

#include <functional>
#include <span>

#include "libcontact/joint/contact_notes.hpp"
#include "programs/joint/beside.hpp"
#include "programs/joint/input.hpp"
#include "programs/joint/setup.hpp"
#include "programs/joint/solution_row.hpp"

namespace hinge_joint {

/// Counts rows without a solution, and collects notes on the contacts.
struct Problems {
  std::size_t out_of_range = 0;
  std::size_t not_converged = 0;
  std::size_t out_of_seat = 0;
  std::size_t bad_lines = 0;
  std::vector<contact::ContactNotes> notes =
      {};  ///< one for each of Setup::joints

  /// @param number  index of the joint in Setup::joints
  void add(const Answer& answer, const NamedJoint& joint, std::size_t number);
  void add(const Problems& more);
};

/// Writes a row for each state, joint and pair of laws: differences, law,
/// pressure, state, status and the answer_columns().
Problems write_solutions(const Setup& setup, const Inputs& inputs,
                         const Beside& beside,
                         const cli::OutputOptions& options,
                         const std::function<void()>& begin);

/// Writes a row for each quantity of the only state and pair of laws.
Problems write_summary(const Setup& setup, const Inputs& inputs,
                       const Beside& beside, const cli::OutputOptions& options,
                       const std::function<void()>& begin);

/// Names of the columns of write_solutions().
std::vector<std::string> solution_columns(const NamedJoint& joint,
                                          std::span<const AnswerColumn> columns,
                                          const Beside& beside);
/// Writes the cells of one row, but not its end.
void write_cells(cli::RowWriter& to, const NamedJoint& joint,
                 std::span<const AnswerColumn> columns, const Answer& a,
                 std::size_t row, const Beside& beside);

}  // namespace hinge_joint
