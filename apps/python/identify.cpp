#include <pybind11/eigen.h>
#include <pybind11/stl.h>

#include <algorithm>
#include <memory>
#include <utility>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/quantities/fit.hpp"
#include "python/contact_warning.hpp"
#include "python/file_joint.hpp"
#include "python/rows/rows.hpp"

namespace contact_python {
namespace {

using contact::Estimate;
using contact::FrictionFit;
using contact::FrictionParameter;
using contact::MeasuredMoment;

FrictionParameter parameter_of(const std::string& text) {
  const auto all = contact::fit_parameters();
  const auto found = std::ranges::find(all, text, &contact::FitParameter::key);
  if (found != all.end()) return found->parameter;
  std::vector<std::string> keys;
  for (const auto& p : all) keys.push_back(std::string(p.key));
  throw contact::Error(
      contact::detail::must_be("parameters: \"" + text + "\"",
                               "of " + contact::detail::joined(keys, ", ")));
}

std::unique_ptr<FrictionFit> identify(const FileJoint& joint,
                                      const Numbers& reaction,
                                      const Numbers& rate,
                                      const Numbers& moment,
                                      const Numbers& sigma,
                                      const std::vector<std::string>& names,
                                      bool huber, bool profile, double level) {
  contact::IdentifyOptions options{{}, huber, profile, level};
  for (const auto& name : names) {
    options.parameters.push_back(parameter_of(name));
  }
  // A vector of each state, or its component.
  const Rows states({{"reaction", reaction, 3}});
  const bool is_vector = moment.ndim() > py::ssize_t(states.shape().size()) &&
                         moment.shape(moment.ndim() - 1) == 3;
  std::vector<MeasuredMoment> data;
  Rows({{"reaction", reaction, 3},
        {"angular_velocity", rate, 3},
        {"moment", moment, is_vector ? 3 : 0},
        {"sigma", sigma, 0}})
      .for_each([&](const double* const* at) {
        MeasuredMoment datum{vector_at(at[0]), vector_at(at[1]), *at[2],
                             *at[3]};
        if (is_vector) datum.moment = vector_at(at[2]);
        data.push_back(datum);
      });
  // Parameters to be fitted need not be given.
  const bool finds_coefficient =
      std::ranges::count(options.parameters, FrictionParameter::coefficient);
  if (!finds_coefficient) joint.require_friction();
  contact::SharedLaws laws;
  const contact::JointContact contact =
      any_joint(LeftOut{true, true}.of(joint.spec()), laws).joint.contact();
  std::unique_ptr<FrictionFit> fit;
  {
    const Unlocked unlocked;
    fit = std::make_unique<FrictionFit>(
        contact::identify_friction(contact, data, options));
  }
  warn_of(joint.limits(), fit->largest_contact, frames_of_maker);
  const bool knows_sigma = sigma.size() != 1 || *sigma.data() != 1;
  if (knows_sigma) {
    for (const std::string& note : fit->notes()) warn_of(note, frames_of_maker);
  }
  return fit;
}

std::pair<double, double> pair_of(const Estimate::Interval& interval) {
  return {interval.low, interval.high};
}

// Moments that the fit predicts for states, and their standard errors.
py::tuple predict(const FrictionFit& fit, const Numbers& reaction,
                  const Numbers& rate) {
  const auto arguments = {Argument("reaction", reaction, 3),
                          Argument("angular_velocity", rate, 3)};
  const auto of = [&](double Estimate::*what) {
    return evaluate(arguments, [&](const double* const* at) {
      return fit.predicted_moment(vector_at(at[0]), vector_at(at[1])).*what;
    });
  };
  return py::make_tuple(of(&Estimate::value), of(&Estimate::standard_error));
}

void bind_estimate(py::module_& m) {
  py::class_<Estimate>(m, "Estimate", "A number that was found.")
      .def_readonly("value", &Estimate::value, "In SI units; NaN: none.")
      .def_readonly("standard_error", &Estimate::standard_error, "")
      .def_property_readonly(
          "interval", [](const Estimate& e) { return pair_of(e.interval); },
          "Low and high, by Student's t.")
      .def_property_readonly(
          "profile", [](const Estimate& e) { return pair_of(e.profile); },
          "Low and high, where the others are fitted anew; NaN unless asked.")
      .def_readonly("at_bound", &Estimate::at_bound,
                    "Held at 0, below which the data would have it.")
      .def("__float__", [](const Estimate& e) { return e.value; })
      .def("__repr__", [](const Estimate& e) {
        return py::str("{:.6g} +- {:.2g}").format(e.value, e.standard_error);
      });
}

}  // namespace

void bind_identify(py::module_& m) {
  bind_estimate(m);
  py::class_<FrictionFit> type(
      m, "Fit", "Friction parameters that fit measured moments.");
  py::list names;
  for (const auto& p : contact::fit_parameters())
    names.append(py::make_tuple(p.key, p.column, p.name, p.meaning));
  type.attr("_parameters") = names;
  py::list quantities;
  for (const auto& q : contact::fit_quantities())
    quantities.append(py::make_tuple(q.key, q.symbol, q.meaning));
  type.attr("_quantities") = quantities;
  type.def(py::init(&identify), py::arg("joint"), py::arg("reaction"),
           py::arg("angular_velocity"), py::arg("moment"), py::arg("sigma"),
           py::arg("parameters"), py::arg("huber"), py::arg("profile"),
           py::arg("level"));
  type.def_property_readonly(
      "converged",
      [](const FrictionFit& f) { return f.status == contact::Status::ok; }, "");
  type.def_property_readonly(
      "parameters",
      [](const FrictionFit& f) {
        py::dict all;
        for (std::size_t i = 0; i < f.parameters.size(); ++i) {
          const auto key = contact::fit_parameter(f.parameters[i]).key;
          all[py::str(key.data(), key.size())] = f.estimates[i];
        }
        return all;
      },
      "Estimates by the names of the parameters.");
  const auto matrix = [&](const char* name, auto member, const char* doc) {
    type.def_property_readonly(
        name, [member](const FrictionFit& f) { return f.*member; }, doc);
  };
  matrix("covariance", &FrictionFit::covariance, "Of the parameters.");
  matrix("correlation", &FrictionFit::correlation, "Of the parameters.");
  for (const auto& q : contact::fit_quantities()) {
    std::visit(
        [&](auto of) {
          type.def_property_readonly(
              q.key.data(), [of](const FrictionFit& f) { return of(f); },
              std::string(q.meaning).c_str());
        },
        q.of);
  }
  type.def("predict", &predict, py::arg("reaction"),
           py::arg("angular_velocity"),
           R"(predict(self, reaction, angular_velocity)
--

The moment that turns the joint in other states by this fit, and its standard
error, N m. Arguments as in Joint.solve().)");
}

}  // namespace contact_python
