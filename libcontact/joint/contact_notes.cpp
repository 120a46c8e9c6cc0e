#include "libcontact/joint/contact_notes.hpp"

#include <algorithm>
#include <iterator>

namespace contact {

void ContactNotes::add(const Joint& joint, const JointSolution& solution) {
  largest_.add(solution.half_angle, solution.peak_pressure);
  if (joint.is_endless()) return;
  for (std::string& note : joint.notes(solution)) {
    of_seat_.insert(std::move(note));
  }
}

void ContactNotes::add(const ContactNotes& more) {
  largest_.add(more.largest_);
  of_seat_.insert(more.of_seat_.begin(), more.of_seat_.end());
}

std::vector<std::string> ContactNotes::notes(const Joint& joint) const {
  std::vector<std::string> all = joint.contact().limits().notes(largest_);
  std::ranges::copy(of_seat_, std::back_inserter(all));
  return all;
}

}  // namespace contact
