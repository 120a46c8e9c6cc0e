// Steps of joints in a simulator's own rates, for adapters in Python.
#include <pybind11/stl.h>

#include <Eigen/Core>
#include <vector>

#include "libcontact/base/complaint.hpp"
#include "libcontact/base/text.hpp"
#include "libcontact/joint/steps/mechanism_step.hpp"
#include "python/answers.hpp"
#include "python/file_joint.hpp"
#include "python/rows/starts.hpp"

namespace contact_python {
namespace {

using contact::MechanismStep;
using Eigen::VectorXd;

Eigen::Map<const VectorXd> vector_of(const Numbers& numbers) {
  return {numbers.data(), numbers.size()};
}

// Row by row.
Eigen::MatrixXd matrix_of(const char* name, const Numbers& numbers) {
  if (numbers.ndim() != 2) {
    throw contact::Error(contact::detail::must_be(name, "a matrix"));
  }
  return Eigen::Map<const Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic,
                                        Eigen::RowMajor>>(
      numbers.data(), numbers.shape(0), numbers.shape(1));
}

py::array_t<double> array_of(const VectorXd& numbers) {
  return py::array_t<double>(numbers.size(), numbers.data());
}

// With its joints, and those with a seat on the carrier.
struct Mechanism {
  std::vector<contact::Joint> joints;
  MechanismStep step;
  std::vector<bool> seats_on_carrier;
};

Mechanism made(const std::vector<const FileJoint*>& joints,
               const std::vector<int>& first, int size) {
  if (joints.size() != first.size()) {
    throw contact::Error(contact::detail::must_be("first", "of each joint"));
  }
  std::vector<contact::Joint> own;
  std::vector<contact::MechanismJoint> all;
  std::vector<bool> on_carrier;
  own.reserve(joints.size());
  for (std::size_t i = 0; i < joints.size(); ++i) {
    if (!joints[i]) {  // None
      throw contact::Error(contact::detail::must_be("joints", "all of Joint"));
    }
    own.push_back(joints[i]->joint());
    all.push_back({&own.back(), first[i]});
    const contact::JointGeometry& geometry = joints[i]->spec().geometry;
    on_carrier.push_back(geometry.seat() &&
                         geometry.inner_body() == contact::JointBody::body);
  }
  return {std::move(own), MechanismStep(all, size), std::move(on_carrier)};
}

void begin(Mechanism& self, const Numbers& reaction, const Numbers& axis,
           const Numbers& from_seat, const Numbers& rates,
           const Numbers& likely) {
  std::vector<contact::MechanismStart> starts;
  const Rows rows({{"reaction", reaction, 3},
                   {"axis", axis, 3},
                   Argument::matrix("from_seat", from_seat)});
  rows.for_each([&](const double* const* at) {
    starts.push_back({vector_at(at[0]), vector_at(at[1]), matrix_at(at[2])});
  });
  self.step.begin(starts, vector_of(rates), vector_of(likely));
}

py::tuple turn(Mechanism& self, const Numbers& rates_at_end,
               const Numbers& force) {
  VectorXd changed = vector_of(force);
  const double change = self.step.turn(vector_of(rates_at_end), changed);
  if (self.step.sweeps().status != contact::Status::ok) {
    throw contact::Error(contact::detail::message(
        "Mechanism.turn(): friction has no value: {}",
        contact::to_string(self.step.sweeps().status)));
  }
  return py::make_tuple(array_of(changed), change);
}

std::vector<bool> holds(const Mechanism& self) {
  std::vector<bool> all;
  for (const auto& step : self.step.steps()) all.push_back(step.holds);
  return all;
}

}  // namespace

void bind_mechanism(py::module_& m) {
  py::class_<Mechanism>(
      m, "Mechanism",
      R"(Joints with friction in a simulator's own rates, for adapters: libcontact.mujoco.

joints: list of Joint; first: index of the first rate of each joint, three for a
ball and one for a pin; size: number of all rates. The simulator solves H q'' =
forces + J^T lambda + friction. Friction and the simulator's constraints alternate:
weigh(), begin(), then turn() and the simulator's q'' until the force is constant.)")
      .def(py::init(&made), py::arg("joints"), py::arg("first"),
           py::arg("size"))
      .def(
          "weigh",
          [](Mechanism& self, const Numbers& inertia, const Numbers& rows,
             const Numbers& stiffness, double time_step) {
            self.step.weigh(matrix_of("inertia", inertia),
                            matrix_of("rows", rows), vector_of(stiffness),
                            time_step);
          },
          py::arg("inertia"), py::arg("rows"), py::arg("stiffness"),
          py::arg("time_step"),
          R"(weigh(self, inertia, rows, stiffness, time_step)
--

inertia: H, (size, size), with time_step times the dampings.
rows, stiffness: J, (n, size), and D, (n,), of constraints whose force is linear
    in the acceleration now.
time_step: s.)")
      .def("begin", &begin, py::arg("reaction"), py::arg("axis"),
           py::arg("from_seat"), py::arg("rates"), py::arg("likely"),
           R"(begin(self, reaction, axis, from_seat, rates, likely)
--

reaction: R on the body in the previous step, N, (joints, 3): for a ball in the
    axes of its rates, for a pin in the axes of its axis.
axis: unit axes of pins, (joints, 3).
from_seat: for balls with a [seat], rotation from the axes of the body with the
    seat to the axes of the rates, (joints, 3, 3).
rates: q', (size,); likely: a guess of the rates at the step's end, for speed.)")
      .def("turn", &turn, py::arg("rates_at_end"), py::arg("force"),
           R"(turn(self, rates_at_end, force)
--

rates_at_end: q' + time_step q'' with the friction force, (size,). Returns the
generalized force of friction, (size,), and its relative change, 0 to 1.)")
      .def(
          "hold",
          [](const Mechanism& self, const Numbers& rates,
             const Numbers& rates_at_end) {
            return array_of(self.step.holding_force(vector_of(rates),
                                                    vector_of(rates_at_end)));
          },
          py::arg("rates"), py::arg("rates_at_end"),
          R"(hold(self, rates, rates_at_end)
--

The force that would keep the joints' rates constant, (size,), for the reactions of
the first step.)")
      .def_readonly("seats_on_carrier", &Mechanism::seats_on_carrier,
                    "Which joints have a [seat] on the carrier, a list.")
      .def_property_readonly("holds", &holds,
                             "Which joints the last turn holds, a list.");
}

}  // namespace contact_python
