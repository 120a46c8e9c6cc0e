#include <Eigen/Geometry>
#include <cmath>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/error.hpp"
#include "libcontact/duty/sliding_contact.hpp"
#include "libcontact/finite_pin/slices_model.hpp"
#include "libcontact/joint/contact_model.hpp"
#include "libcontact/joint/joint.hpp"

// Answers of a joint about its solutions, whatever its contact.
namespace contact {
namespace {

using Eigen::Vector3d;

// A contact at a rim has none.
bool is_round(const JointSolution& s) { return !std::isnan(s.half_angle); }

using Model = std::shared_ptr<const detail::ContactModel>;

// The model that found a solution: the one for tilts or the joint's.
const detail::ContactModel* finder(const JointSolution& s, const Model& model,
                                   const Model& tilted) {
  const bool is_tilted =
      dynamic_cast<const detail::SlicesFound*>(s.work.get()) != nullptr;
  return is_tilted ? tilted.get() : model.get();
}

Model in_seat(Model model) {
  if (!model) {
    throw Error(detail::needs("a table of contacts", "a joint with a [seat]"));
  }
  return model;
}

}  // namespace

std::optional<RimContact> Joint::rims(const JointSolution& solution) const {
  if (!model_) return {};
  return model_->rims(solution);
}

std::optional<PinLie> Joint::lie(const JointSolution& solution) const {
  const auto* model = finder(solution, model_, tilted_);
  return model ? model->lie(solution) : std::nullopt;
}

ContactPv Joint::pv(const JointSolution& solution, const Vector3d& rate) const {
  if (solution.status != Status::ok) return {};
  if (!is_round(solution)) {
    const auto* model = finder(solution, model_, tilted_);
    return model ? model->pv(solution, rate) : ContactPv();
  }
  const SlidingContact sliding(contact_, solution, rate);
  const SlidingContact::Peak peak = sliding.largest_pv();
  return {sliding.pv_total(), peak.value, peak.place};
}

std::vector<double> Joint::pressures(const JointSolution& solution,
                                     std::span<const Vector3d> places,
                                     RimPressure at_rims) const {
  const auto* model = finder(solution, model_, tilted_);
  if (model && !is_round(solution)) {
    return model->pressures(solution, places, at_rims);
  }
  const Vector3d centre = contact_.geometry().side() * solution.normal;
  std::vector<double> all;
  for (const Vector3d& place : places) {
    const double theta =
        std::atan2(centre.cross(place).norm(), centre.dot(place));
    const bool is_pressed =
        solution.normal_force > 0 || contact_.has_interference();
    all.push_back(is_pressed || !is_round(solution)
                      ? contact_.pressure(theta, solution.normal_force,
                                          solution.half_angle)
                      : 0);
  }
  return all;
}

std::vector<std::string> Joint::notes(const JointSolution& solution) const {
  if (dynamic_cast<const detail::PlacementRefused*>(solution.work.get())) {
    return {detail::needs(
        "a pin that is tilted, loaded at a place or slides along its axis",
        "a pin of a JointSpec with dry friction, a radial_clearance above 0 m, "
        "loading = centre and a wall with an end")};
  }
  const auto* model = finder(solution, model_, tilted_);
  if (model) return model->notes(solution);
  return detail::failure_notes(
      solution.status,
      "the half-angle law or the pressure law has no value under this load");
}

JointSolution Joint::with_grid(const JointSolution& solution,
                               const JointSolution& near) const {
  return model_ ? model_->with_grid(solution, near) : solution;
}

Joint Joint::with_model(
    std::shared_ptr<const detail::ContactModel> model) const {
  Joint other = *this;
  other.model_ = std::move(model);
  return other;
}

Joint Joint::tabulated(const RimTableOptions& options) const {
  return with_model(in_seat(in_seat(model_)->tabulated(options)));
}

Joint Joint::tabulated(std::string_view table) const {
  return with_model(in_seat(in_seat(model_)->tabulated(table)));
}

std::string Joint::table() const {
  return model_ ? model_->table() : std::string();
}

std::optional<RimTableCheck> Joint::table_check() const {
  if (!model_) return {};
  return model_->table_check();
}

}  // namespace contact
