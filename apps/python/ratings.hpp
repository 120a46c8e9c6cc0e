#pragma once

#include <span>

#include "libcontact/duty/sliding_contact.hpp"
#include "libcontact/duty/wear_in.hpp"
#include "libcontact/joint/solution.hpp"
#include "python/answers.hpp"

namespace contact_python {

/// What a bearing is rated by: a SlidingContact without what it refers to.
struct Rating {
  contact::SlidingContact::Peak pv;
  contact::SlidingContact::Peak heat_flux;
  double pv_mean;
  double pv_nominal;
  double pv_total;
  double heat;
  double slip_coefficient;
};
Rating rating(const contact::SlidingContact& sliding);

/// The attributes of results.
std::span<const Field<contact::JointSolution>> solution_fields();
std::span<const Field<Rating>> rating_fields();
std::span<const Field<contact::WearIn::State>> worn_fields();

}  // namespace contact_python
