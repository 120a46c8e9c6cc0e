#pragma once

#include <span>
#include <vector>

#include "cli/stream/points.hpp"
#include "programs/joint/input.hpp"

namespace hinge_joint {

/// A set of columns by which a file of points gives states.
struct Form {
  Question question;
  std::vector<cli::PointColumn> columns;

  bool has_vectors() const { return columns.size() == 6; }
};

/// The first form whose columns the header has. Vectors come first, because
/// outputs of hinge-joint have the columns of several forms. Throws
/// contact::Error if no form fits.
/// @param questions  those that the options allow
Form find_form(const cli::PointHeader& header, bool pin,
               std::span<const Question> questions);

/// The state of a point; the columns of the form come first.
/// @param rate  |Dw| for forms without vectors, rad/s
Input state_of(const Form& form, const cli::PointLines& block, std::size_t i,
               bool pin, double rate);

}  // namespace hinge_joint
