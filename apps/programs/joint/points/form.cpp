#include "programs/joint/points/form.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"

namespace hinge_joint {
namespace {

constexpr cli::Allowed any_force{-allowed_force.max, allowed_force.max, "N"};
constexpr cli::Allowed any_rate{-allowed_rate.max, allowed_rate.max, "rad/s"};
constexpr cli::Allowed any_moment{-allowed_force.max, allowed_force.max, "N m"};

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

}  // namespace

Form find_form(const cli::PointHeader& header, bool pin,
               std::span<const Question> questions) {
  std::string columns;
  for (const Form& form : forms(pin)) {
    if (std::ranges::find(questions, form.question) == questions.end())
      continue;
    if (header.has(form.columns)) return form;
    if (!columns.empty()) columns += "; ";
    for (std::size_t i = 0; i < form.columns.size(); ++i) {
      if (i > 0) columns += ',';
      columns += form.columns[i].name;
    }
  }
  header.fail(contact::detail::needs("a state", "the columns " + columns));
}

Input state_of(const Form& form, const cli::PointLines& block, std::size_t i,
               bool pin, double rate) {
  const auto value = [&](std::size_t column) {
    return block.values[column][i];
  };
  if (form.has_vectors()) {
    return {{value(0), value(1), value(2)}, {value(3), value(4), value(5)}};
  }
  return form.question == Question::contact
             ? state_from_contact(value(0), pin ? 0 : value(1), rate)
             : state_from_reaction(value(0), pin ? 90 : value(1), rate);
}

}  // namespace hinge_joint
