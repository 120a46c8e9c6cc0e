#pragma once

#include <span>
#include <vector>

#include "cli/stream/points.hpp"
#include "programs/joint/input.hpp"

namespace hinge_joint {

/// A way in which a file of points gives states.
struct Form {
  Question question;
  std::vector<cli::PointColumn> columns;

  bool has_vectors() const { return columns.size() == 6; }
};

/// The first of the forms that a header has, vectors first: outputs of
/// hinge-joint have the columns of several. Throws contact::Error if it has
/// none.
/// @param questions  that are asked
Form find_form(const cli::PointHeader& header, bool pin,
               std::span<const Question> questions);

/// The state of a point, its columns the first ones.
/// @param rate  |Dw| of forms without vectors, rad/s
Input state_of(const Form& form, const cli::PointLines& block, std::size_t i,
               bool pin, double rate);

}  // namespace hinge_joint
